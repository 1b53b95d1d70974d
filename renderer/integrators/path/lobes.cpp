#include "renderer/integrators/path/lobes.hpp"

#include "renderer/math/elementary.hpp"

#include <algorithm>
#include <numbers>

namespace rt {
namespace {

// `metallic_falloff` with an arc cosine that is the same on every machine.
double falloff(double cosine) {
  const double x = arc_cosine(std::min(cosine, 1.0)) / (std::numbers::pi / 2);
  return std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
}

Color tint(const MaterialValues& v, double cosine) {
  if (v.metallic == 0) return white;
  return white + (v.color - white) * (v.metallic * (1 - falloff(cosine)));
}

// The greatest sum of the weights in one channel: the mirror takes on the colour's tint or, at grazing angles, none;
// and where Fresnel's equations hold, any share of its weight.
double greatest_sum(double diffuse, double mirror, double transmission, bool has_fresnel) {
  if (!has_fresnel) return diffuse + mirror + transmission;
  return diffuse + std::max(transmission, mirror + transmission * std::max(0.0, 1 - mirror));
}

Color scale(const WhittedBsdf& bsdf, const Color& diffuse) {
  const MaterialValues& v = bsdf.values();
  const Color transmission = v.color * v.refract, tinted = tint(v, 1);
  const auto channel = [&](double d, double reflect, double tint_at_normal, double t) {
    return 1 / std::max(1.0, greatest_sum(d, reflect * std::max(1.0, tint_at_normal), t, v.fresnel));
  };
  return {channel(diffuse.r, v.reflect.r, tinted.r, transmission.r),
          channel(diffuse.g, v.reflect.g, tinted.g, transmission.g),
          channel(diffuse.b, v.reflect.b, tinted.b, transmission.b)};
}

Color rest_of(const Color& share) {
  return {std::max(0.0, 1 - share.r), std::max(0.0, 1 - share.g), std::max(0.0, 1 - share.b)};
}

} // namespace

Lobes lobes(const WhittedBsdf& bsdf, double cosine, double eta, double fresnel_eta) {
  const MaterialValues& v = bsdf.values();
  const Color diffuse = bsdf.body() * v.diffuse, scaling = scale(bsdf, diffuse);
  Lobes result{diffuse * scaling, black, black, eta};
  if (bsdf.is_transparent()) {
    result.is_bent = std::abs(eta - 1) >= 1e-10;
    const double cos2_behind = result.is_bent ? cos2_refracted(cosine, eta) : 1;
    if (cos2_behind < 0) { // total internal reflection
      result.mirror = rest_of(result.diffuse);
      return result;
    }
    result.cos_behind = std::sqrt(cos2_behind);
    result.transmission = v.color * v.refract * scaling;
  }
  if (bsdf.is_mirror()) {
    const Color mirror = v.reflect * tint(v, cosine) * (v.fresnel ? fresnel_reflectance(cosine, fresnel_eta) : 1);
    result.mirror = mirror * scaling;
    if (v.fresnel) result.transmission *= rest_of(mirror);
  }
  return result;
}

} // namespace rt
