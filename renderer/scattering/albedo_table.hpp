#pragma once

#include "renderer/math/color.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rt {

/// The roughnesses that a table holds: one, or if a pattern gives the roughness r (α = r²) 32, evenly from 0 to 1.
class RoughnessAxis {
public:
  static constexpr int steps = 32;

  static RoughnessAxis constant(double alpha) { return RoughnessAxis({alpha}); }
  static RoughnessAxis patterned(double least_alpha) {
    std::vector<double> alphas;
    for (int i = 0; i < steps; ++i) {
      const double r = i / (steps - 1.0);
      alphas.push_back(std::max(least_alpha, r * r));
    }
    return RoughnessAxis(std::move(alphas));
  }

  const std::vector<double>& alphas() const { return alphas_; }

  /// A place between two rows.
  struct Place {
    std::size_t row = 0;
    double fraction = 0;
  };
  Place find(double alpha) const {
    if (alphas_.size() == 1) return {};
    const double x = std::sqrt(std::clamp(alpha, 0.0, 1.0)) * (steps - 1);
    const std::size_t row = std::min<std::size_t>(steps - 2, static_cast<std::size_t>(x));
    return {row, x - static_cast<double>(row)};
  }

private:
  explicit RoughnessAxis(std::vector<double> alphas) : alphas_(std::move(alphas)) {}
  std::vector<double> alphas_;
};

/// A function of roughness and of a direction's cosine μ, linear between values at μ = t⁴ for evenly spaced t: such
/// albedos curve most towards grazing angles. T is a number or a colour.
template <class T>
class AlbedoTable {
public:
  static constexpr int cosines = 64;
  using Place = RoughnessAxis::Place;

  AlbedoTable() = default;
  /// `f(alpha, cosine)` is evaluated for each of them.
  template <class F>
  AlbedoTable(const RoughnessAxis& axis, F&& f) {
    for (const double alpha : axis.alphas()) {
      for (int i = 0; i < cosines; ++i) {
        const double t = std::max(1e-3, i / (cosines - 1.0)); // an albedo's limit at μ = 0
        values_.push_back(f(alpha, t * t * t * t));
      }
      means_.push_back(mean_of_row(values_.data() + values_.size() - cosines));
    }
  }

  T at(Place place, double cosine) const {
    const double x = std::sqrt(std::sqrt(std::clamp(cosine, 0.0, 1.0))) * (cosines - 1);
    const std::size_t column = std::min<std::size_t>(cosines - 2, static_cast<std::size_t>(x));
    const double fraction = x - static_cast<double>(column);
    const auto in_row = [&](std::size_t row) {
      const T* const v = values_.data() + row * cosines + column;
      return v[0] * (1 - fraction) + v[1] * fraction;
    };
    if (place.fraction == 0) return in_row(place.row);
    return in_row(place.row) * (1 - place.fraction) + in_row(place.row + 1) * place.fraction;
  }

  /// The cosine-weighted mean over the hemisphere: 2∫ f μ dμ, exact for what `at` returns.
  T mean(Place place) const {
    if (place.fraction == 0) return means_[place.row];
    return means_[place.row] * (1 - place.fraction) + means_[place.row + 1] * place.fraction;
  }

private:
  // 8 ∫ f t⁷ dt, interval by interval.
  static T mean_of_row(const T* row) {
    T sum = row[0] * 0;
    for (int i = 0; i + 1 < cosines; ++i) {
      const double a = i / (cosines - 1.0), b = (i + 1) / (cosines - 1.0);
      const double whole = power8(b) - power8(a); // 8 ∫ t⁷
      const double upper = (8.0 / 9 * (power8(b) * b - power8(a) * a) - a * whole) / (b - a);
      sum += row[i] * (whole - upper) + row[i + 1] * upper;
    }
    return sum;
  }
  static double power8(double x) {
    const double x2 = x * x, x4 = x2 * x2;
    return x4 * x4;
  }

  std::vector<T> values_, means_; // row by row
};

} // namespace rt
