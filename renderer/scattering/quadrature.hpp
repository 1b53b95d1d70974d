#pragma once

#include "renderer/scattering/ggx.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rt {

/// Points and weights on [0, 1] that integrate polynomials of degree 2n − 1 exactly.
class GaussLegendre {
public:
  explicit GaussLegendre(int n);
  /// ∫₀¹ f.
  template <class F>
  auto integrate(F&& f) const {
    auto sum = f(points_[0].first) * points_[0].second;
    for (std::size_t i = 1; i < points_.size(); ++i) sum += f(points_[i].first) * points_[i].second;
    return sum;
  }

private:
  std::vector<std::pair<double, double>> points_;
};

/// Integrals over the facets of a GGX surface.
class FacetQuadrature {
public:
  /// The number of points along a facet's tilt and around the normal. The default gives the directional albedo to 10⁻⁴,
  /// to 10⁻³ below a cosine of 0.02.
  explicit FacetQuadrature(int along = 12, int around = 32);

  /// The fraction of light that the facets, seen from a direction of this cosine, reflect upwards; `reflectance` is
  /// that of a facet, a function of the cosine to its normal that may have a kink at one.
  template <class F>
  auto reflected(double alpha, double cosine, F&& reflectance, double bend = 0) const {
    const Ggx ggx(alpha);
    const double slant_o = ggx.slant(cosine);
    // Up to this tangent a facet, leaning to the viewer by `lean`, reflects the view direction above the horizon.
    const auto steepest = [&](double lean) {
      const double root = std::sqrt(lean * lean + cosine * cosine);
      return lean > 0 ? (lean + root) / cosine : cosine / (root - lean);
    };
    return over_facets(alpha, cosine, bend, steepest, [&](double cos_facet, double cos_h) {
      const double cos_i = std::max(0.0, 2 * cos_facet * cos_h - cosine);
      const double seen = 2 * cos_facet * cos_i / (cosine * ggx.slant(cos_i) + cos_i * slant_o);
      return reflectance(cos_facet) * seen;
    });
  }

  /// The fraction that they transmit; `eta` is the ior of the other side divided by that of this one, `transmittance`
  /// as above and 0 on total internal reflection.
  template <class F>
  auto transmitted(double alpha, double cosine, double eta, F&& transmittance) const {
    const Ggx ggx(alpha);
    const double slant_o = ggx.slant(cosine);
    const auto steepest = [&](double lean) { return lean < 0 ? cosine / -lean : 1e9; }; // to face the viewer
    const double critical = eta < 1 ? std::sqrt(1 - eta * eta) : 0;
    return over_facets(alpha, cosine, critical, steepest, [&](double cos_facet, double cos_h) {
      const double cos2_behind = 1 - (1 - cos_facet * cos_facet) / (eta * eta);
      if (cos2_behind < 0) return transmittance(cos_facet) * 0;
      const double cos_i = cosine / eta - (cos_facet / eta - std::sqrt(cos2_behind)) * cos_h; // to −z
      const double seen = 4 * cos_facet * cos_i / ((cosine + slant_o) * (cos_i + ggx.slant(cos_i)));
      return transmittance(cos_facet) * (cos_i > 0 ? seen : 0);
    });
  }

private:
  // ∫ D·f dω over the facets up to the tangent that `steepest` gives, f(cosine to the viewer, cosine to the normal), in
  // pieces that end where the former is `bend`.
  template <class Steepest, class F>
  auto over_facets(double alpha, double cosine, double bend, Steepest&& steepest, F&& f) const {
    const double sine = std::sqrt(1 - cosine * cosine);
    auto sum = f(cosine, 1.0) * 0;
    for (const double around : around_) {
      const double lean = sine * around, most = steepest(lean);
      double from = 0;
      for (const double bent : tangents_at(bend, lean, cosine)) {
        if (!(bent > from && bent < most)) continue;
        sum += between(alpha, lean, cosine, from, bent, f);
        from = bent;
      }
      sum += between(alpha, lean, cosine, from, most, f);
    }
    return sum * (1 / static_cast<double>(around_.size()));
  }

  // The tangents of the facets that the viewer sees at this cosine, the smaller first; not positive if there is none.
  static std::array<double, 2> tangents_at(double seen, double lean, double cosine) {
    const double a = lean * lean - seen * seen, b = lean * cosine, c = cosine * cosine - seen * seen;
    const double root = b * b - a * c;
    if (seen == 0 || root < 0 || a == 0) return {0, 0};
    const double x = (-b - std::sqrt(root)) / a, y = (-b + std::sqrt(root)) / a;
    return {std::min(x, y), std::max(x, y)};
  }

  // For one azimuth, between two tangents of the tilt. They are α·tan ψ, and the rational parameter of ψ is clustered
  // towards both ends, where masking and Fresnel's curve bend.
  template <class F>
  auto between(double alpha, double lean, double cosine, double from, double to, F&& f) const {
    const auto parameter = [alpha](double tangent) { // tan of half of ψ
      const double x = tangent / alpha;
      return x / (1 + std::sqrt(1 + x * x));
    };
    const double begin = parameter(from), size = parameter(to) - begin;
    return along_.integrate([&](double x) {
      const double t = begin + size * x * x * (3 - 2 * x), dt = size * 6 * x * (1 - x);
      const double sin_psi = 2 * t / (1 + t * t), cos_psi = (1 - t * t) / (1 + t * t);
      const double tangent = alpha * sin_psi / cos_psi, cos_h = 1 / std::sqrt(1 + tangent * tangent);
      const double measure = 4 * sin_psi * cos_psi / (1 + t * t) * dt / cos_h;
      return f(std::min(1.0, (lean * tangent + cosine) * cos_h), cos_h) * measure;
    });
  }

  GaussLegendre along_;
  std::vector<double> around_; // cosines of azimuths, half a turn by symmetry
};

} // namespace rt
