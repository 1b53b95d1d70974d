#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"

#include <cmath>

/// The physics of Whitted's model, one formula each. `n` is a unit normal turned against the unit direction `d`.
namespace rt {

/// The mirrored direction.
constexpr Vec3 reflect(const Vec3& d, const Vec3& n) {
  return d - n * (2 * dot(d, n));
}

/// 1 − sin² of the angle behind the surface by Snell's law, `eta` being the ior before it by the ior behind it;
/// negative on total internal reflection.
constexpr double cos2_refracted(double cos_incident, double eta) {
  return 1 - eta * eta * (1 - cos_incident * cos_incident);
}

/// The refracted direction; `cos_refracted` is the root of cos2_refracted.
constexpr Vec3 refract(const Vec3& d, const Vec3& n, double eta, double cos_incident, double cos_refracted) {
  return d * eta + n * (eta * cos_incident - cos_refracted);
}

/// A highlight's cosine to the power of its sharpness. Most are whole numbers, and then some multiplications do.
inline double to_power(double cosine, double shininess) {
  constexpr double most = 256; // each unit adds a rounding
  if (!(shininess >= 1 && shininess <= most && shininess == std::floor(shininess))) return std::pow(cosine, shininess);
  double result = 1;
  for (auto rest = static_cast<unsigned>(shininess);; cosine *= cosine) {
    if (rest % 2 == 1) result *= cosine;
    if ((rest /= 2) == 0) return result;
  }
}

/// The share of unpolarised light that a smooth dielectric reflects; `eta` is the ior of the other side by that of this
/// one. 1 on total internal reflection. Cook and Torrance, A Reflectance Model for Computer Graphics, 1982.
double fresnel_reflectance(double cos_incident, double eta);

/// How far a metal's own colour gives way to white towards grazing angles, 0 (at the normal) to 1: Blinn's rational fit
/// to Fresnel's curve as POV-Ray uses it.
double metallic_falloff(double cosine);

/// The factor on the highlight or mirror of a surface of this colour: white for no metal.
inline Color metallic_tint(double metallic, double cosine, const Color& color) {
  if (metallic == 0) return white;
  return white + (color - white) * (metallic * (1 - metallic_falloff(cosine)));
}

} // namespace rt
