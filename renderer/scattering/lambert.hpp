#pragma once

#include "renderer/sampling/mappings.hpp"
#include "renderer/scattering/bsdf_sample.hpp"

#include <numbers>

namespace rt {

/// A matte surface: its albedo, the same in all directions. Directions are on the viewer's side.
struct LambertLobe {
  Color albedo = black;

  Color evaluate() const { return albedo * std::numbers::inv_pi; }
  static double density(const Vec3& wi) { return std::max(0.0, wi.z) * std::numbers::inv_pi; }
  static Vec3 sample(double u, double v) { return to_cosine_hemisphere(u, v); }
};

} // namespace rt
