#pragma once

#include "renderer/math/color.hpp"
#include "renderer/shading/optics.hpp"

namespace rt {

/// The share of unpolarised light that a metal of refractive index n + ik mirrors in vacuum. M. Born and E. Wolf,
/// Principles of Optics, 14.2.
double conductor_reflectance(double cosine, double n, double k);

/// (1 − cosine)⁵: C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994.
constexpr double schlick_weight(double cosine) {
  const double x = 1 - cosine;
  return x * x * x * x * x;
}

/// `metallic_falloff` in arithmetic that is the same on every machine.
double exact_metallic_falloff(double cosine);

/// A curve over the cosine between a ray and a smooth facet, from 0 to 1.
struct FresnelCurve {
  enum class Kind {
    one,        ///< 1
    dielectric, ///< Fresnel's for `eta`, the ior of the other side by that of this one
    sheet,      ///< of a clear sheet with all inner reflections, 2F/(1 + F)
    schlick,    ///< (1 − cosine)⁵
    conductor,  ///< Fresnel's for `n` and `k`
  };
  Kind kind = Kind::one;
  double eta = 1;
  Color n = black, k = black;

  Color at(double cosine) const;
};

/// The reflectance of a facet: constant + weight·curve + tint·curve·(1 − metallic_falloff). That it is linear in its
/// colours lets what is tabulated of the curve serve whatever colours a pattern gives.
struct Reflectance {
  FresnelCurve curve{};
  Color constant = black, weight = black, tint = black;

  Color at(double cosine) const {
    const Color shape = curve.at(cosine);
    const Color plain = constant + weight * shape;
    return tint == black ? plain : plain + tint * shape * (1 - exact_metallic_falloff(cosine));
  }
};

/// What a sheet with parallel sides gives back and lets by, all reflections inside it summed, if one side mirrors
/// `side` and one way through leaves `inner` of the light.
struct SheetTerms {
  Color reflected, transmitted;
};
SheetTerms sheet_terms(const Color& side, const Color& inner);

} // namespace rt
