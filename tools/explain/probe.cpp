#include "tools/explain/probe.hpp"

#include "renderer/scene/names.hpp"
#include "tools/explain/json.hpp"
#include "tools/explain/naming.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::tools::explain {
namespace {

using json = nlohmann::ordered_json;

std::string material_text(const HitReport& hit) {
  const MaterialValues& m = hit.material;
  std::string text = fmt::format("color {}, ambient {}, diffuse {}, specular {:.10g}, shininess {:.10g}",
                                 text_of(m.color), text_of(m.ambient), text_of(m.diffuse), m.specular, m.shininess);
  if (m.highlight == scene::Highlight::phong) text += " (phong)";
  if (m.metallic != 0) text += fmt::format(", metallic {:.10g}", m.metallic);
  if (!(m.reflect == black)) text += fmt::format(", reflect {}", text_of(m.reflect));
  if (m.refract != 0) text += fmt::format(", refract {:.10g}, ior {:.10g}", m.refract, hit.ior);
  if (m.fresnel) text += ", fresnel";
  if (m.thin) text += ", thin";
  if (m.roughness) text += fmt::format(", roughness {:.10g}", *m.roughness);
  if (m.metal) text += fmt::format(", metal {{ n: {}, k: {} }}", text_of(m.metal->n), text_of(m.metal->k));
  if (m.coat != 0)
    text += fmt::format(", coat {:.10g} (roughness {:.10g}, ior {:.10g})", m.coat, m.coat_roughness, m.coat_ior);
  if (!(m.emission == black)) text += fmt::format(", emission {}", text_of(m.emission));
  return text;
}

std::string hit_text(const scene::Scene& scene, const HitReport& hit) {
  std::string text = fmt::format("  object    {}\n", Namer(scene).whole(hit.path));
  text += fmt::format("  t         {:.17g}    distance {:.17g}\n", hit.t, hit.distance);
  text += fmt::format("  point     {}\n", text_of(hit.position));
  text += fmt::format("  normal    {}    the ray {} here\n", text_of(hit.normal), hit.enters ? "enters" : "leaves");
  if (!(hit.shading_normal == hit.normal)) text += fmt::format("  shaded as {}\n", text_of(hit.shading_normal));
  text += fmt::format("  material  {}\n", material_text(hit));
  return text;
}

// For a hit that is not the first in its place.
std::string place_text(const std::vector<HitReport>& hits, std::size_t i) {
  if (i == 0 || hits[i - 1].place != hits[i].place) return "";
  const auto first = std::ranges::find(hits, hits[i].place, &HitReport::place);
  return fmt::format(", coincides with hit {}", first - hits.begin() + 1);
}

json material_json(const HitReport& hit) {
  const MaterialValues& m = hit.material;
  json j = {{"color", to_json(m.color)},
            {"ambient", to_json(m.ambient)},
            {"diffuse", to_json(m.diffuse)},
            {"emission", to_json(m.emission)},
            {"specular", m.specular},
            {"shininess", m.shininess},
            {"highlight", m.highlight == scene::Highlight::phong ? "phong" : "blinn"},
            {"metallic", m.metallic},
            {"reflect", to_json(m.reflect)},
            {"refract", m.refract},
            {"ior", hit.ior},
            {"fresnel", m.fresnel}};
  if (m.thin) j["thin"] = true;
  if (m.roughness) j["roughness"] = *m.roughness;
  if (m.metal) j["metal"] = {{"n", to_json(m.metal->n)}, {"k", to_json(m.metal->k)}};
  if (m.coat != 0) j["coat"] = m.coat, j["coat_roughness"] = m.coat_roughness, j["coat_ior"] = m.coat_ior;
  return j;
}

json hit_json(const scene::Scene& scene, const HitReport& hit) {
  return {{"objects", objects_json(scene, hit.path)},
          {"t", hit.t},
          {"distance", hit.distance},
          {"point", to_json(hit.position)},
          {"normal", to_json(hit.normal)},
          {"shading_normal", to_json(hit.shading_normal)},
          {"enters", hit.enters},
          {"place", hit.place},
          {"material", material_json(hit)}};
}

} // namespace

std::string text_of(const Vec3& v) {
  return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", v.x, v.y, v.z);
}

std::string text_of(const Color& c) {
  if (c.r == c.g && c.g == c.b) return fmt::format("{:.9g}", c.r);
  return fmt::format("linear_rgb({:.9g}, {:.9g}, {:.9g})", c.r, c.g, c.b);
}

std::vector<HitReport> find_hits(const RayQuery& query, const Ray& ray, bool all) {
  if (all) return query.all_hits(ray);
  std::vector<HitReport> hits;
  if (auto hit = query.nearest(ray)) hits.push_back(std::move(*hit));
  return hits;
}

std::string probe_text(const scene::Scene& scene, const NamedRay& ray, const std::vector<HitReport>& hits, bool all) {
  std::string text =
      fmt::format("{}: from {} along {}\n", ray.name, text_of(ray.ray.origin), text_of(ray.ray.direction));
  if (hits.empty()) return text + "  hits nothing: the background is visible\n";
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (all) text += fmt::format("hit {} of {}{}\n", i + 1, hits.size(), place_text(hits, i));
    text += hit_text(scene, hits[i]);
  }
  return text;
}

json probe_json(const scene::Scene& scene, const NamedRay& ray, const std::vector<HitReport>& hits) {
  json list = json::array();
  for (const HitReport& hit : hits) list.push_back(hit_json(scene, hit));
  return {{"ray", {{"origin", to_json(ray.ray.origin)}, {"direction", to_json(ray.ray.direction)}}},
          {"hits", std::move(list)}};
}

} // namespace rt::tools::explain
