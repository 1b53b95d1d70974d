#include "renderer/scene/names.hpp"
#include "tools/explain/json.hpp"
#include "tools/explain/naming.hpp"
#include "tools/explain/why/pattern_readings.hpp"
#include "tools/explain/why/why_surface.hpp"

#include <cmath>
#include <numbers>

namespace rt::tools::explain {
namespace {

using json = nlohmann::ordered_json;

double degrees(double cosine) {
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * (180 / std::numbers::pi);
}

json ray_json(const Ray& ray) {
  return {{"origin", to_json(ray.origin)}, {"direction", to_json(ray.direction)}};
}

json derivation_json(const Derivation& d) {
  json j{{"shape", d.shape}, {"equation", d.equation}, {"own_space", d.is_own_space}, {"ray", ray_json(d.ray)}};
  json quantities = json::object(), words = json::array();
  for (const DerivationLine& line : d.lines) {
    for (const Quantity& q : line.quantities)
      quantities[q.key] = std::holds_alternative<double>(q.value) ? to_json(std::get<double>(q.value))
                                                                  : to_json(std::get<Vec3>(q.value));
    if (!line.words.empty()) words.push_back(line.words);
  }
  j["quantities"] = std::move(quantities);
  j["says"] = std::move(words);
  if (!d.choice.empty()) j["choice"] = d.choice;
  j["t"] = d.t;
  j["disagreement"] = d.disagreement;
  return j;
}

json intervals_json(const LineIntervals& intervals) {
  json list = json::array();
  for (const LineInterval& s : intervals) list.push_back({to_json(s.enter), to_json(s.leave)});
  return list;
}

json combination_json(const scene::Scene& scene, const CombinationIntervals& c) {
  json operands = json::array();
  for (const OperandIntervals& operand : c.operands) {
    json o{{"object", name_of(scene, *operand.object)}};
    o = with_place(scene, std::move(o), operand.object->origin);
    o["inside"] = intervals_json(operand.inside);
    operands.push_back(std::move(o));
  }
  return {{"operation", noun(c.operation)}, {"operands", std::move(operands)}, {"inside", intervals_json(c.inside)}};
}

std::string_view name_of(MediumTransition::Kind kind) {
  return kind == MediumTransition::Kind::entering         ? "entering"
         : kind == MediumTransition::Kind::leaving        ? "leaving"
         : kind == MediumTransition::Kind::entering_outer ? "entering_outer"
         : kind == MediumTransition::Kind::leaving_outer  ? "leaving_outer"
                                                          : "through_sheet";
}

json passage_json(const MediumTransition& p) {
  return {{"kind", name_of(p.kind)}, {"ior_from", p.ior_from}, {"ior_to", p.ior_to}};
}

class TreeJson {
public:
  TreeJson(const Answer& answer, const Detail& detail) : answer_(answer), detail_(detail) {}

  json ray(const RayNode& node) const {
    static constexpr std::string_view kinds[] = {"camera", "reflected", "refracted", "total_reflection"};
    static constexpr std::string_view ends[] = {"surface", "background", "max_depth"};
    json j{{"kind", kinds[static_cast<std::size_t>(node.kind)]},
           {"depth", node.depth},
           {"weight", to_json(node.weight)},
           {"ray", ray_json(node.ray)},
           {"radiance", to_json(node.radiance)}};
    if (!shows(answer_, detail_, node)) return j;
    json surfaces = json::array();
    for (const SurfaceNode& s : node.surfaces) surfaces.push_back(surface(s));
    j["surfaces"] = std::move(surfaces);
    j["ends_at"] = ends[static_cast<std::size_t>(node.end)];
    return j;
  }

private:
  json surface(const SurfaceNode& s) const {
    const MaterialValues& m = s.material;
    json j{{"objects", objects_json(answer_.scene, s.path)},
           {"ray", ray_json(s.ray)},
           {"t", s.hit.t},
           {"point", to_json(s.surface.position)},
           {"normal", to_json(s.normal)},
           {"enters", dot(s.surface.normal, s.ray.direction) < 0}};
    if (!s.touching.empty()) {
      json touching = json::array();
      for (const auto& path : s.touching) touching.push_back(objects_json(answer_.scene, path));
      j["touching"] = std::move(touching);
    }
    if (const auto intervals = intervals_of(answer_, s)) j["combination"] = combination_json(answer_.scene, *intervals);
    j["derivation"] = derivation_json(derivation_of(answer_, s));
    j["color"] = to_json(m.color);
    j["refract"] = m.refract;
    json patterns = json::array();
    for (const PatternReading& r : pattern_readings(answer_.scene, s.surface)) patterns.push_back(pattern(r));
    if (!patterns.empty()) j["patterns"] = std::move(patterns);
    j["passed"] = to_json(s.passed);
    if (s.absorbed) j["absorbed"] = {{"left", to_json(s.absorbed->left)}, {"length", s.absorbed->length}};
    j["ambient"] = to_json(s.ambient);
    j["emission"] = to_json(s.emission);
    json lights = json::array();
    for (const LightNode& node : s.lights) lights.push_back(light(node));
    j["lights"] = std::move(lights);
    if (s.mirror) j["mirror"] = mirror(*s.mirror);
    if (s.transition) j["passage"] = transition(*s.transition);
    if (s.total_reflection)
      j["total_reflection"] = {{"passage", passage_json(s.total_reflection->transition)},
                               {"angle", degrees(s.total_reflection->cosine)},
                               {"ray", ray(*s.total_reflection->ray)}};
    return j;
  }

  static json pattern(const PatternReading& r) {
    json j{{"property", r.property}, {"pattern", r.noun}, {"depth", r.depth}, {"point", to_json(r.point)}};
    if (r.in_stops) j["value"] = r.in_stops->value, j["place"] = r.in_stops->place, j["share"] = r.in_stops->share;
    j["shown"] = to_json(r.shown);
    return j;
  }

  json light(const LightNode& node) const {
    const LightRecord& r = node.record;
    const scene::Light& light = answer_.scene.lights[r.light];
    json j = with_place(answer_.scene, {{"light", explain::name_of(answer_.scene, light)}}, light.origin);
    j["distance"] = to_json(r.sample.distance);
    j["fade"] = to_json(r.sample.fade);
    j["cone"] = to_json(r.sample.spot);
    j["n_dot_l"] = to_json(r.cos_light);
    j["highlight_cosine"] = to_json(r.reflected.cos_highlight);
    j["filter"] = to_json(r.filter);
    if (r.left_out > 0) j["left_out"] = r.left_out;
    json in_the_way = json::array();
    for (const InTheWay& w : node.in_the_way)
      in_the_way.push_back({{"objects", objects_json(answer_.scene, w.path)},
                            {"distance", w.distance},
                            {"lets_by", to_json(w.transmittance)}});
    j["in_the_way"] = std::move(in_the_way);
    j["diffuse"] = to_json(r.reflected.diffuse);
    j["highlight"] = to_json(r.reflected.highlight);
    return j;
  }

  json mirror(const MirrorNode& node) const {
    json j{{"weight", to_json(node.rho)},
           {"angle", degrees(node.cosine)},
           {"fresnel", node.reflectance},
           {"eta", node.eta}};
    if (node.left_out) j["left_out"] = node.left_out->weight, j["estimate"] = to_json(node.left_out->estimate);
    if (node.ray) j["ray"] = ray(*node.ray);
    return j;
  }

  json transition(const TransitionNode& node) const {
    json j{{"weight", to_json(node.tau)},
           {"passage", passage_json(node.transition)},
           {"angle", degrees(node.cosine)},
           {"angle_behind", degrees(node.cosine_behind)}};
    if (node.left_out) j["left_out"] = node.left_out->weight, j["estimate"] = to_json(node.left_out->estimate);
    if (node.ray) j["ray"] = ray(*node.ray);
    return j;
  }

  const Answer& answer_;
  const Detail& detail_;
};

} // namespace

json why_json(const Answer& answer, const Detail& detail) {
  const Color seen = answer.tree->radiance;
  json j{{"about", answer.ray.name},
         {"scene", answer.file},
         {"radiance", to_json(seen)},
         {"shown", shown(seen, scene::tone_mapping(answer.scene))},
         {"sum_of_terms", to_json(answer.sum.total)}};
  if (answer.pixel)
    j["pixel"] = {{"samples", scene::whitted_samples(answer.scene)},
                  {"radiance", to_json(*answer.pixel)},
                  {"shown", shown(*answer.pixel, scene::tone_mapping(answer.scene))}};
  json terms = json::array();
  for (const NamedTerm& term : named_terms(answer))
    terms.push_back({{"value", to_json(term.value)}, {"what", term.text}});
  j["terms"] = std::move(terms);
  j["because"] = verdict(answer);
  j["tree"] = TreeJson(answer, detail).ray(*answer.tree);
  return j;
}

} // namespace rt::tools::explain
