#include "renderer/render/pixel_filter.hpp"

#include "renderer/math/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr int intervals = 256;
constexpr double bell_radius = 1.5;

// F. Harris, On the Use of Windows for Harmonic Analysis, 1978: the minimum 4-term window.
double blackman_harris(double share) {
  constexpr double a[] = {0.35875, 0.48829, 0.14128, 0.01168};
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const double turns = share * k;
    sum += (k % 2 == 0 ? a[k] : -a[k]) * sine_cosine_of_turns(turns - std::floor(turns)).cosine;
  }
  return sum;
}

// A Gaussian with a standard deviation of half a pixel, less its value at the edge, so that it ends at 0.
double gaussian(double x) {
  constexpr double deviation = 0.5;
  const auto bell = [](double y) { return exponential_decay(y * y / (2 * deviation * deviation)); };
  return bell(x) - bell(bell_radius);
}

double density(scene::PixelFilter filter, double x) {
  switch (filter) {
  case scene::PixelFilter::box:
    return 1;
  case scene::PixelFilter::gaussian:
    return gaussian(x);
  case scene::PixelFilter::blackman_harris:
    return blackman_harris((x / bell_radius + 1) / 2);
  }
  return 1;
}

} // namespace

FilterSampler::FilterSampler(scene::PixelFilter filter)
    : radius_(filter == scene::PixelFilter::box ? 0.5 : bell_radius) {
  for (int i = 0; i <= intervals; ++i) {
    density_.push_back(std::max(0.0, density(filter, radius_ * (2.0 * i / intervals - 1))));
    cumulative_.push_back(i == 0 ? 0 : cumulative_.back() + (density_[density_.size() - 2] + density_.back()) / 2);
  }
}

double FilterSampler::offset(double u) const {
  const double aim = u * cumulative_.back();
  const auto after = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, aim);
  const auto i = static_cast<std::size_t>(after - cumulative_.begin()) - 1;
  // Within the interval: a·s + (b − a)·s²/2 = rest, without a difference that cancels.
  const double a = density_[i], b = density_[i + 1], rest = std::max(0.0, aim - cumulative_[i]);
  const double root = std::sqrt(std::max(0.0, a * a + 2 * (b - a) * rest));
  const double s = a + root > 0 ? std::min(1.0, 2 * rest / (a + root)) : 0;
  return radius_ * (2 * (static_cast<double>(i) + s) / intervals - 1);
}

} // namespace rt
