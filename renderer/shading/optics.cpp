#include "renderer/shading/optics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {

double fresnel_reflectance(double cos_incident, double eta) {
  const double c = cos_incident;
  const double g2 = eta * eta + c * c - 1;
  if (g2 <= 0) return 1;
  const double g = std::sqrt(g2);
  const double parallel = (g - c) / (g + c);
  const double ratio = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5 * parallel * parallel * (1 + ratio * ratio);
}

double metallic_falloff(double cosine) {
  const double x = std::acos(std::clamp(cosine, -1.0, 1.0)) / (std::numbers::pi / 2);
  return std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
}

} // namespace rt
