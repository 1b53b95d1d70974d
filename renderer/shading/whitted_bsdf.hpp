#pragma once

#include "renderer/shading/materials.hpp"
#include "renderer/shading/optics.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

/// How much of a light's illumination a surface reflects to the viewer, term by term.
struct ReflectedLight {
  double cos_highlight = 0; ///< n·h, or r·l for Phong's form
  Color tint = white;       ///< of a metal's highlight
  Color diffuse, highlight; ///< the terms themselves
  Color sum() const { return diffuse + highlight; }
};

/// How a smooth surface reflects and refracts a ray.
struct SpecularTerms {
  Color rho = black;           ///< weight of the reflected ray
  Color tau = black;           ///< weight of the refracted ray
  double reflectance = 1;      ///< the Fresnel reflectance in ρ; 1 if not used
  double cos_behind = 1;       ///< between the refracted ray and the normal
  bool is_transparent = false; ///< there is a refracted ray, if only with weight 0
  bool is_bent = false;        ///< the refracted ray changes its direction
  bool is_total = false;       ///< total internal reflection replaces both: everything is reflected
};

/// How a surface scatters light: Lambert's diffuse reflection, Blinn's or Phong's highlight, a mirror and refraction,
/// weighted as in Whitted's model. Directions are unit vectors; `n` is the shading normal, facing the viewer.
class WhittedBsdf {
public:
  WhittedBsdf() = default;
  /// The values must outlive it.
  explicit WhittedBsdf(const MaterialValues& values) : values_(&values), body_(values.color * (1 - values.refract)) {}

  const MaterialValues& values() const { return *values_; }
  /// The fraction of the colour that is not transparent.
  const Color& body() const { return body_; }

  bool is_mirror() const { return values_->reflect != black || values_->coat > 0; }
  bool is_transparent() const { return values_->refract > 0; }

  /// What is reflected against `ray`, the direction of the viewer's ray, for light arriving from `to_light` with n·l =
  /// `cos_light` > 0.
  [[gnu::always_inline]] ReflectedLight evaluate(const Color& arriving, const Vec3& ray, const Vec3& n,
                                                 const Vec3& to_light, double cos_light, bool has_highlight) const {
    const MaterialValues& v = *values_;
    ReflectedLight result;
    result.diffuse = arriving * body_ * v.diffuse * cos_light;
    if (has_highlight && v.specular > 0) {
      result.cos_highlight =
          v.highlight == scene::Highlight::blinn ? dot(n, normalize(to_light - ray)) : dot(reflect(ray, n), to_light);
      if (result.cos_highlight > 0) {
        result.tint = metallic_tint(v.metallic, cos_light, v.color);
        result.highlight = arriving * result.tint * (v.specular * to_power(result.cos_highlight, v.shininess));
      }
    }
    return result;
  }

  /// Reflection and, if it is transparent, refraction, for a ray at this `cosine` to the normal. `eta` is the ior
  /// before the surface divided by that behind it; `fresnel_eta` is as `fresnel_reflectance` takes it, and only matters
  /// with `fresnel`.
  [[gnu::always_inline]] SpecularTerms specular(double cosine, double eta, double fresnel_eta) const {
    const MaterialValues& v = *values_;
    SpecularTerms terms;
    if (is_transparent()) {
      terms.is_bent = !v.thin && std::abs(eta - 1) >= 1e-10;
      const double cos2_behind = terms.is_bent ? cos2_refracted(cosine, eta) : 1;
      if (cos2_behind < 0 && v.color != black) { // what is black lets nothing by and mirrors nothing
        terms.rho = white;
        terms.is_total = true;
        return terms;
      }
      terms.cos_behind = std::sqrt(std::max(cos2_behind, 0.0));
    }
    if (is_mirror()) {
      if (v.fresnel) terms.reflectance = fresnel_reflectance(cosine, fresnel_eta);
      terms.rho = v.reflect * metallic_tint(v.metallic, cosine, v.color) * terms.reflectance;
      if (v.coat > 0) terms.rho += grey(v.coat * fresnel_reflectance(cosine, v.coat_ior));
    }
    if (is_transparent()) {
      terms.is_transparent = true;
      terms.tau = v.color * v.refract;
      // What is reflected is not transmitted.
      if (v.fresnel)
        terms.tau *= {std::min(1.0, 1 - terms.rho.r), std::min(1.0, 1 - terms.rho.g), std::min(1.0, 1 - terms.rho.b)};
    }
    return terms;
  }

private:
  const MaterialValues* values_ = nullptr;
  Color body_{};
};

} // namespace rt
