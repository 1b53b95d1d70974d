#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/elementary.hpp"
#include "renderer/math/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Multiple scattering between the facets of a rough surface: what single scattering loses, 1 − E in each direction, is
/// returned as f ∝ (1 − E(μo))(1 − E(μi)). C. Kulla and A. Conty, Revisiting Physically Based Shading at Imageworks,
/// SIGGRAPH course 2017; for mirrors also E. Turquin, Practical Multiple Scattering Compensation, 2019.
namespace rt {

/// The fraction of the lost light that is returned if a facet reflects `mean` on average, passes `again` of what it
/// receives to the outside or other facets, and `energy` is the mean of E: the sum over all bounces, mean·again·E/(1 −
/// again·(1 − E)). For a metal `again` is `mean`.
inline Color returned_share(const Color& mean, const Color& again, double energy) {
  const auto share = [energy](double f, double a) { return f * a * energy / std::max(1e-12, 1 - a * (1 - energy)); };
  return {share(mean.r, again.r), share(mean.g, again.g), share(mean.b, again.b)};
}

/// The fraction of the lost light that leaves clear glass on the other side, where `mean` is a facet's mean reflectance
/// on this side, and `energy`, `energy_behind` are the means of E on either. 1 − `mean` itself would violate
/// reciprocity: n²·share·(1 − energy) must equal that of the other side.
inline double transmitted_share(double mean, double energy, double energy_behind) {
  const double lost = 1 - energy, lost_behind = 1 - energy_behind;
  return lost > 0 ? (1 - mean) * std::min(lost, lost_behind) / lost : 0;
}

/// Samples directions about +z for such light: with a density of (½ + cos θ)/2π, halfway between the cosine, which the
/// roughest surfaces need, and uniform: smoother ones lose most light near the horizon.
inline Vec3 sample_several_bounces(double u, double v) {
  const double cosine = (std::sqrt(1 + 8 * v) - 1) / 2, sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const SineCosine around = sine_cosine_of_turns(u);
  return {sine * around.cosine, sine * around.sine, cosine};
}
inline double several_bounces_density(double cosine) {
  return (0.5 + cosine) * std::numbers::inv_pi / 2;
}

} // namespace rt
