#pragma once

#include "renderer/math/elementary.hpp"
#include "renderer/math/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {

/// A microfacet surface with the GGX distribution (B. Walter et al., Microfacet Models for Refraction through Rough
/// Surfaces, 2007) and Smith's masking. Directions are unit vectors about +z, on its side unless stated otherwise.
class Ggx {
public:
  /// Below this roughness α a surface counts as perfectly smooth.
  static constexpr double least_alpha = 1e-3;

  Ggx() = default;
  explicit Ggx(double alpha) : alpha_(alpha), alpha2_(alpha * alpha) {}

  double alpha() const { return alpha_; }
  bool is_smooth() const { return alpha_ < least_alpha; }

  /// D: the area of the facets with this normal, per area of the surface and solid angle.
  double distribution(const Vec3& h) const {
    const double spread = h.z * h.z * (alpha2_ - 1) + 1;
    return alpha2_ / (std::numbers::pi * spread * spread);
  }

  /// cosine·(1 + 2Λ): the building block of Smith's functions, finite down to the horizon.
  double slant(double cosine) const { return std::sqrt(cosine * cosine * (1 - alpha2_) + alpha2_); }

  /// G₂/(4·cos·cos) for a reflection, with height-correlated masking and shadowing (E. Heitz, Understanding the
  /// Masking-Shadowing Function in Microfacet-Based BRDFs, JCGT 2014, section 6.2).
  double reflected_visibility(double cos_o, double cos_i) const {
    return 0.5 / (cos_o * slant(cos_i) + cos_i * slant(cos_o));
  }
  /// G₂/(cos·cos) for a transmission: what is high is visible from above and hidden from below, so the separable form
  /// is nearer to the truth than the height-correlated one. `cos_i` is that to −z.
  double transmitted_visibility(double cos_o, double cos_i) const {
    return 4 / ((cos_o + slant(cos_o)) * (cos_i + slant(cos_i)));
  }

  /// The density of `sample_visible` per solid angle of h: the distribution of visible normals.
  double visible_density(const Vec3& wo, const Vec3& h) const {
    return 2 * std::max(0.0, dot(wo, h)) * distribution(h) / (wo.z + slant(wo.z));
  }

  /// The normal of a facet visible from `wo`. J. Dupuy and A. Benyoub, Sampling Visible GGX Normals with Spherical
  /// Caps, 2023.
  Vec3 sample_visible(const Vec3& wo, double u, double v) const {
    const Vec3 o = normalize({alpha_ * wo.x, alpha_ * wo.y, wo.z});
    const double z = 1 - v * (1 + o.z), sine = std::sqrt(std::max(0.0, 1 - z * z));
    const SineCosine around = sine_cosine_of_turns(u);
    const Vec3 h = Vec3{sine * around.cosine, sine * around.sine, z} + o;
    return normalize({alpha_ * h.x, alpha_ * h.y, std::max(0.0, h.z)});
  }

private:
  double alpha_ = 0, alpha2_ = 0;
};

} // namespace rt
