#pragma once

#include "renderer/math/vec3.hpp"

#include <cmath>

namespace rt {

/// The factor by which a shading normal `ns` other than the geometric one `ng` changes a light path's contribution:
/// light is weighted by the cosine to `ns`, but arrives with that to `ng`. `wi` is where the path comes from, `wo`
/// where it goes. E. Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997, section 5.3.
inline double shading_normal_factor(const Vec3& wi, const Vec3& wo, const Vec3& ns, const Vec3& ng) {
  const double arriving = std::abs(dot(wi, ng)), shaded = std::abs(dot(wo, ns));
  if (arriving == 0 || shaded == 0) return 0;
  return std::abs(dot(wi, ns)) * std::abs(dot(wo, ng)) / (arriving * shaded);
}

} // namespace rt
