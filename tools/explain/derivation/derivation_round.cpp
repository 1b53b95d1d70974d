// Spheres, cylinders and cones: quadratic equations.

#include "tools/explain/derivation/derivation_steps.hpp"
#include "tools/explain/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::tools::explain {

void derive_shape(Steps& steps, const SphereGeometry& sphere) {
  const Vec3 &o = steps.ray().origin, &d = steps.ray().direction;
  steps.equation("|o + t·d − C|² = r²");
  steps.put("center", "C", sphere.center).put("radius", "r", sphere.radius).so();
  const Vec3 from_center = o - sphere.center;
  const double a = dot(d, d), b = 2 * dot(d, from_center),
               c = dot(from_center, from_center) - sphere.radius * sphere.radius;
  steps.put("a", "a = d·d", a).put("b", "b = 2·d·(o − C)", b).put("c", "c = |o − C|² − r²", c);
  const bool is_on_it = std::abs(c) <= 1e-9 * sphere.radius * sphere.radius;
  steps.so(is_on_it ? "up to rounding 0: the ray starts on it"
           : c > 0  ? "> 0: the ray starts outside"
                    : "< 0: the ray starts inside");
  const auto roots = steps.solve(a, b, c, "the sphere");
  if (roots.count == 1) return steps.choose({{roots.first, "t", true}});
  steps.choose({{roots.first, "t₁", true}, {roots.second, "t₂", true}});
}

namespace {

// The ray relative to an axis: heights along it, and parts perpendicular to it.
struct Axial {
  double height, climb;  // of the origin above the base, and per unit of t
  Vec3 across, sideways; // the parts of the origin (from the base) and the direction perpendicular to the axis

  Axial(const Ray& ray, const Vec3& base, const Vec3& axis)
      : height(dot(ray.origin - base, axis)), climb(dot(ray.direction, axis)), across(reject(ray.origin - base, axis)),
        sideways(reject(ray.direction, axis)) {}
  double height_at(double t) const { return height + t * climb; }
  double distance_at(double t) const { return length(across + sideways * t); }
  bool is_along(const Ray& ray) const { return dot(sideways, sideways) <= 1e-24 * dot(ray.direction, ray.direction); }
};

void put_projection(Steps& steps, const Axial& axial) {
  steps.put("o_across", "across the axis: o⊥ = (o − B) − ((o − B)·u)·u", axial.across)
      .put("d_across", "d⊥ = d − (d·u)·u", axial.sideways)
      .so();
}

// Whether a root is between the ends.
std::string place_between(double height, double top, bool& counts) {
  const double slack = 1e-9 * top;
  counts = height >= -slack && height <= top + slack;
  if (counts) return "between the ends";
  return height < 0 ? "below the one end" : "beyond the other end";
}

void add_side(Steps& steps, const Axial& axial, double t, int number, double top,
              std::vector<Steps::Candidate>& candidates) {
  bool counts = false;
  const double height = axial.height_at(t);
  const std::string place = place_between(height, top, counts);
  steps
      .put(fmt::format("h{}", number), fmt::format("height at t{}: h = (o − B)·u + t·d·u", number == 1 ? "₁" : "₂"),
           height)
      .so(place);
  candidates.push_back({t, fmt::format("the side at t{}", number == 1 ? "₁" : "₂"), counts});
}

// The plane of one end, and whether the ray hits the disc in it.
void add_end(Steps& steps, const Axial& axial, double at, double radius, bool is_open, std::string_view key,
             std::string_view name, std::vector<Steps::Candidate>& candidates) {
  const double t = (at - axial.height) / axial.climb;
  const double distance = axial.distance_at(t);
  const bool is_within = distance <= radius * (1 + 1e-9);
  steps.put(fmt::format("t_{}", key), fmt::format("{} at t = ({} − (o − B)·u) / d·u", name, number_text(at)), t)
      .put(fmt::format("distance_{}", key), "distance from the axis", distance)
      .so(is_open     ? "it is open there: no disc"
          : is_within ? fmt::format("≤ {}: within the disc", number_text(radius))
                      : fmt::format("> {}: past the disc", number_text(radius)));
  candidates.push_back({t, std::string(name), is_within && !is_open});
}

} // namespace

void derive_shape(Steps& steps, const CylinderGeometry& cylinder) {
  const bool is_infinite = cylinder.extent == CylinderGeometry::Extent::infinite;
  const bool is_open = cylinder.extent == CylinderGeometry::Extent::open;
  const Axial axial(steps.ray(), cylinder.base, cylinder.axis);
  steps.equation(is_infinite ? "|o⊥ + t·d⊥|² = r²" : "|o⊥ + t·d⊥|² = r² for 0 ≤ h ≤ H, and the ends");
  steps.put("base", "B", cylinder.base).put("axis", "axis u", cylinder.axis).put("radius", "r", cylinder.radius);
  if (!is_infinite) steps.put("height", "H", cylinder.height);
  steps.so();
  put_projection(steps, axial);
  std::vector<Steps::Candidate> candidates;
  const double a = dot(axial.sideways, axial.sideways), b = 2 * dot(axial.across, axial.sideways),
               c = dot(axial.across, axial.across) - cylinder.radius * cylinder.radius;
  steps.put("a", "a = d⊥·d⊥", a).put("b", "b = 2·o⊥·d⊥", b).put("c", "c = o⊥·o⊥ − r²", c);
  if (axial.is_along(steps.ray())) {
    steps.so("a = 0: the ray is parallel to the axis, and can only hit the ends");
  } else {
    steps.so();
    const auto roots = steps.solve(a, b, c, "the infinite side");
    for (int i = 1; i <= roots.count; ++i) {
      const double t = i == 1 ? roots.first : roots.second;
      if (is_infinite)
        candidates.push_back({t, fmt::format("t{}", i == 1 ? "₁" : "₂"), true});
      else
        add_side(steps, axial, t, i, cylinder.height, candidates);
    }
  }
  if (!is_infinite && axial.climb != 0) {
    add_end(steps, axial, 0, cylinder.radius, is_open, "base", "the end at B", candidates);
    add_end(steps, axial, cylinder.height, cylinder.radius, is_open, "top", "the other end", candidates);
  } else if (!is_infinite) {
    steps.put("climb", "d·u", 0.0).so("the ray is perpendicular to the axis: it does not hit the ends");
  }
  steps.choose(std::move(candidates));
}

void derive_shape(Steps& steps, const ConeGeometry& cone) {
  const Axial axial(steps.ray(), cone.base, cone.axis);
  steps.equation("|o⊥ + t·d⊥|² = (ρ + t·ρ')² for 0 ≤ h ≤ H, and the ends");
  steps.put("base", "B", cone.base).put("axis", "axis u", cone.axis).put("height", "H", cone.height);
  steps.put("radius", "radii", cone.radius).put("top_radius", "and", cone.top_radius).so();
  put_projection(steps, axial);
  const double rho = cone.radius + cone.slope * axial.height, widening = cone.slope * axial.climb;
  steps.put("rho", "the radius at the ray's height: ρ", rho).put("rho_step", "ρ'", widening).so();
  const double a = dot(axial.sideways, axial.sideways) - widening * widening,
               b = 2 * (dot(axial.across, axial.sideways) - rho * widening),
               c = dot(axial.across, axial.across) - rho * rho;
  steps.put("a", "a = d⊥·d⊥ − ρ'²", a).put("b", "b = 2·(o⊥·d⊥ − ρ·ρ')", b).put("c", "c = o⊥·o⊥ − ρ²", c);
  std::vector<Steps::Candidate> candidates;
  const double speed = dot(steps.ray().direction, steps.ray().direction);
  if (std::abs(a) > 1e-14 * speed) {
    steps.so();
    const auto roots = steps.solve(a, b, c, "the infinite double cone");
    for (int i = 1; i <= roots.count; ++i)
      add_side(steps, axial, i == 1 ? roots.first : roots.second, i, cone.height, candidates);
  } else if (b != 0) {
    steps.so("a = 0: the ray runs parallel to a line of the side, and meets it once");
    steps.put("t1", "t₁ = −c / b", -c / b).so();
    add_side(steps, axial, -c / b, 1, cone.height, candidates);
  } else {
    steps.so("a = b = 0: the ray does not meet the side");
  }
  if (axial.climb != 0) {
    if (cone.radius > 0) add_end(steps, axial, 0, cone.radius, cone.is_open, "base", "the end at B", candidates);
    if (cone.top_radius > 0)
      add_end(steps, axial, cone.height, cone.top_radius, cone.is_open, "top", "the other end", candidates);
  }
  steps.choose(std::move(candidates));
}

} // namespace rt::tools::explain
