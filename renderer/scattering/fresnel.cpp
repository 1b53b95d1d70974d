#include "renderer/scattering/fresnel.hpp"

#include "renderer/math/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {

double conductor_reflectance(double cosine, double n, double k) {
  const double cos2 = cosine * cosine, sin2 = 1 - cos2;
  const double real = n * n - k * k - sin2;
  const double size = std::sqrt(real * real + 4 * n * n * k * k); // a² + b²
  const double twice_a_cos = 2 * cosine * std::sqrt(std::max(0.0, (size + real) / 2));
  const double perpendicular = (size + cos2 - twice_a_cos) / (size + cos2 + twice_a_cos);
  const double outer = cos2 * size + sin2 * sin2, inner = twice_a_cos * sin2;
  return 0.5 * perpendicular * (1 + (outer - inner) / (outer + inner));
}

double exact_metallic_falloff(double cosine) {
  const double x = arc_cosine(std::clamp(cosine, -1.0, 1.0)) / (std::numbers::pi / 2);
  return std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
}

Color FresnelCurve::at(double cosine) const {
  switch (kind) {
  case Kind::one:
    break;
  case Kind::dielectric:
    return grey(fresnel_reflectance(cosine, eta));
  case Kind::sheet: {
    const double f = fresnel_reflectance(cosine, eta);
    return grey(2 * f / (1 + f));
  }
  case Kind::schlick:
    return grey(schlick_weight(cosine));
  case Kind::conductor:
    return {conductor_reflectance(cosine, n.r, k.r), conductor_reflectance(cosine, n.g, k.g),
            conductor_reflectance(cosine, n.b, k.b)};
  }
  return white;
}

SheetTerms sheet_terms(const Color& side, const Color& inner) {
  const auto reflected = [](double r, double a) {
    const double passed = (1 - r) * a;
    return r < 1 ? r + passed * passed * r / (1 - r * r * a * a) : 1;
  };
  const auto transmitted = [](double r, double a) { return r < 1 ? (1 - r) * (1 - r) * a / (1 - r * r * a * a) : 0; };
  return {{reflected(side.r, inner.r), reflected(side.g, inner.g), reflected(side.b, inner.b)},
          {transmitted(side.r, inner.r), transmitted(side.g, inner.g), transmitted(side.b, inner.b)}};
}

} // namespace rt
