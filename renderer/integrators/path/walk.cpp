#include "renderer/integrators/path/walk.hpp"

#include "renderer/shading/materials.hpp"

namespace rt {
namespace {

Medium medium_of(const Surface& surface) {
  return {surface.order, surface.ior, surface.medium_material_id};
}

} // namespace

Walk Walker::start(const Ray& ray, std::span<const Medium> inside) {
  media_.release(0);
  return {ray, media_.make(inside)};
}

Walk Walker::start_like(const Walker& other, const Walk& walk) {
  if (walk.contact.is_inside()) [[unlikely]] {
    media_ = other.media_;
    contacts_ = other.contacts_;
    return walk;
  }
  Walk same = walk;
  media_.release(0);
  same.inside = media_.make({other.media_.begin(walk.inside), walk.inside.size});
  return same;
}

RayHit Walker::nearest(const Walk& walk) {
  if (walk.contact.is_inside()) [[unlikely]]
    return {};
  return walk.meets_casting_only ? scene_.nearest_casting(walk.ray, OwnRules::hit_range(), scratch_)
                                 : scene_.nearest(walk.ray, OwnRules::hit_range(), scratch_);
}

std::optional<Intersection> Walker::intersect(Walk& walk, RayHit hit) {
  const bool has_come = !walk.contact.is_inside();
  for (Interval rest = OwnRules::hit_range(); !walk.contact.is_inside();) {
    if (!hit) return std::nullopt;
    if (!hit.is_contested) [[likely]]
      return Intersection{hit, hit.t, scene_.surface(walk.ray, hit)};
    walk.contact = contacts_.intersect(scene_, walk.ray, rest, hit, walk.inside, media_, 0, scratch_,
                                       walk.meets_casting_only ? Touching::casting : Touching::all);
    if (walk.contact.is_inside()) break;
    rest.lower = contacts_.end();
    hit = walk.meets_casting_only ? scene_.nearest_casting(walk.ray, rest, scratch_)
                                  : scene_.nearest(walk.ray, rest, scratch_);
  }
  const ContactSurface& met = contacts_.surface(walk.contact);
  if (walk.contact.count == 1) walk.contact = {};
  return Intersection{met.hit, has_come ? met.hit.t : 0, met.surface};
}

Color Walker::left_after(const Walk& walk, double length) const {
  if (!scene_.absorbs()) [[likely]]
    return white;
  const Medium* medium = media_.top(walk.inside);
  if (!medium || scene_.absorption(*medium).is_clear()) return white;
  return scene_.absorption(*medium).left_after(length);
}

double Walker::eta(const Walk& walk, const Surface& surface, const MaterialValues& values) const {
  if (values.refract > 0 && !values.thin)
    return 1 / (walk.contact.is_inside() ? contacts_.transition(walk.contact, media_)
                                         : media_.transition(walk.inside, medium_of(surface)))
                   .eta();
  return values.fresnel ? media_.fresnel_eta(walk.inside, medium_of(surface)) : 1;
}

void Walker::leave(Walk& walk, const Surface& surface, bool is_boundary, const Vec3& direction) {
  const Vec3& n = surface.normal;
  const bool crosses = dot(walk.ray.direction, n) * dot(direction, n) > 0;
  if (walk.contact.is_inside()) [[unlikely]] {
    const Contacts::Position met = walk.contact;
    const MediumStacks::List list = crosses ? contacts_.behind(met) : walk.inside;
    walk.contact = contacts_.after(met, direction);
    walk.inside = walk.contact.is_inside() ? list : contacts_.leave(met, list, media_, 0);
  } else if (crosses && is_boundary) {
    walk.inside = media_.after(walk.inside, medium_of(surface), 0);
  }
  walk.ray = OwnRules::leave(surface, direction);
}

} // namespace rt
