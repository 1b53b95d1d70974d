#include "renderer/integrators/contacts.hpp"

#include "renderer/shading/materials.hpp"

#include <algorithm>

namespace rt {

Contacts::Position Contacts::intersect(const CompiledScene& scene, const Ray& ray, const Interval& range,
                                       const RayHit& nearest, MediumStacks::List inside, MediumStacks& media,
                                       std::uint32_t free, TraceScratch& scratch, Touching which) {
  surfaces_.erase(surfaces_.begin() + free, surfaces_.end());
  find_touching(scene, ray, range, nearest, scratch, touching_, which);
  const std::span<MetSurface> met(touching_.surfaces.data(), touching_.count);
  const auto left = std::stable_partition(met.begin(), met.end(),
                                          [&](const MetSurface& m) { return !media.holds(inside, m.surface.order); });
  if (left - met.begin() > 1) sort_inside_out(scene, ray, {met.begin(), left});
  const auto place = [&](const MetSurface& m) { return media.place(inside, m.surface.order); };
  std::sort(left, met.end(), [&](const MetSurface& a, const MetSurface& b) { return place(a) < place(b); });

  MediumStacks::List list = inside;
  for (const MetSurface& m : met) {
    const MediumStacks::List before = list;
    const std::uint64_t id = m.surface.order;
    MaterialValues scratch_values;
    if (met.size() > 1 && !scene.values(m.surface, scratch_values).thin)
      list = media.holds(inside, id) ? media.without(list, id)
                                     : media.with(list, inside.size, {id, m.surface.ior, m.surface.medium_material_id});
    surfaces_.push_back({m, ray, before, list});
  }
  return {free, static_cast<std::uint32_t>(met.size())};
}

MediumTransition Contacts::transition(const Position& p, const MediumStacks& media) const {
  const ContactSurface& s = surface(p);
  return media.transition(p.is_backward ? s.behind : s.before, behind(p),
                          {s.surface.order, s.surface.ior, s.surface.medium_material_id});
}

Contacts::Position Contacts::after(const Position& p, const Vec3& direction) const {
  const ContactSurface& s = surface(p);
  const Vec3& n = s.surface.normal;
  const bool is_backward = dot(s.ray.direction, n) * dot(direction, n) < 0;
  if (p.next == (is_backward ? 0 : p.count - 1)) return {};
  return {p.begin, p.count, is_backward ? p.next - 1 : p.next + 1, is_backward};
}

Color Contacts::transmittance(const CompiledScene& scene, const Position& p, const Vec3& direction) const {
  Color left = white;
  for (Position at = after(p, direction); at.is_inside(); at = after(at, direction)) {
    const ContactSurface& s = surface(at);
    if (!scene.casts_shadow(s.hit)) continue;
    MaterialValues scratch;
    const MaterialValues& v = scene.values(s.surface, scratch);
    left *= v.color * v.refract;
  }
  return left;
}

MediumStacks::List Contacts::leave(const Position& p, MediumStacks::List list, MediumStacks& media,
                                   std::uint32_t owned_from) const {
  const ContactSurface& first = surfaces_[p.begin];
  if (first.behind.begin < owned_from) return list;
  return media.moved(list, first.before.begin < owned_from ? first.behind.begin : first.before.begin);
}

} // namespace rt
