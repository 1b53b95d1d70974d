#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"

#include <cmath>

/// The physics of Whitted's model, a formula each. `n` is a unit normal opposing the unit direction `d`.
namespace rt {

/// The reflected direction.
constexpr Vec3 reflect(const Vec3& d, const Vec3& n) {
  return d - n * (2 * dot(d, n));
}

/// cos² of the angle of refraction by Snell's law, `eta` being the ior before the surface divided by that behind it;
/// negative on total internal reflection.
constexpr double cos2_refracted(double cos_incident, double eta) {
  return 1 - eta * eta * (1 - cos_incident * cos_incident);
}

/// The refracted direction; `cos_refracted` is the root of cos2_refracted.
constexpr Vec3 refract(const Vec3& d, const Vec3& n, double eta, double cos_incident, double cos_refracted) {
  return d * eta + n * (eta * cos_incident - cos_refracted);
}

/// The cosine raised to a highlight's exponent. Most are whole numbers, for which a few multiplications suffice.
inline double to_power(double cosine, double shininess) {
  constexpr double most = 256; // each unit adds a rounding
  if (!(shininess >= 1 && shininess <= most && shininess == std::floor(shininess))) return std::pow(cosine, shininess);
  double result = 1;
  for (auto rest = static_cast<unsigned>(shininess);; cosine *= cosine) {
    if (rest % 2 == 1) result *= cosine;
    if ((rest /= 2) == 0) return result;
  }
}

/// A smooth dielectric's reflectance for unpolarised light; `eta` is the ior of the other side divided by that of this
/// one. 1 on total internal reflection. Cook and Torrance, A Reflectance Model for Computer Graphics, 1982.
double fresnel_reflectance(double cos_incident, double eta);

/// How far a metal's own colour turns to white towards grazing angles, 0 (at the normal) to 1: Blinn's rational fit to
/// Fresnel's curve, as used by POV-Ray.
double metallic_falloff(double cosine);

/// The factor on the highlight or reflection of a surface of this colour: white for a non-metal.
inline Color metallic_tint(double metallic, double cosine, const Color& color) {
  if (metallic == 0) return white;
  return white + (color - white) * (metallic * (1 - metallic_falloff(cosine)));
}

} // namespace rt
