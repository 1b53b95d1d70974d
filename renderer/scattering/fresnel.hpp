#pragma once

#include "renderer/math/color.hpp"
#include "renderer/shading/optics.hpp"

namespace rt {

/// The fraction of unpolarised light that a metal of refractive index n + ik reflects in vacuum. M. Born and E. Wolf,
/// Principles of Optics, 14.2.
double conductor_reflectance(double cosine, double n, double k);

/// (1 − cosine)⁵: C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994.
constexpr double schlick_weight(double cosine) {
  const double x = 1 - cosine;
  return x * x * x * x * x;
}

/// `metallic_falloff` in arithmetic that is the same on every machine.
double exact_metallic_falloff(double cosine);

/// A function of the cosine between a ray and a smooth facet, from 0 to 1.
struct FresnelCurve {
  enum class Kind {
    one,        ///< 1
    dielectric, ///< Fresnel's for `eta`, the ior of the other side divided by that of this one
    sheet,      ///< of a clear sheet with all internal reflections, 2F/(1 + F)
    schlick,    ///< (1 − cosine)⁵
    conductor,  ///< Fresnel's for `n` and `k`
  };
  Kind kind = Kind::one;
  double eta = 1;
  Color n = black, k = black;

  Color at(double cosine) const;
};

/// The reflectance of a facet: constant + weight·curve + tint·curve·(1 − metallic_falloff). Because it is linear in its
/// colours, what is tabulated for a curve serves for any colours that a pattern gives.
struct Reflectance {
  FresnelCurve curve{};
  Color constant = black, weight = black, tint = black;

  Color at(double cosine) const {
    const Color shape = curve.at(cosine);
    const Color plain = constant + weight * shape;
    return tint == black ? plain : plain + tint * shape * (1 - exact_metallic_falloff(cosine));
  }
};

/// What a sheet with parallel sides reflects and transmits, summed over all internal reflections, if one side reflects
/// `side` and one pass through it transmits `inner`.
struct SheetTerms {
  Color reflected, transmitted;
};
SheetTerms sheet_terms(const Color& side, const Color& inner);

} // namespace rt
