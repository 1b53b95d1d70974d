#include "tools/diff/diff.hpp"

#include "renderer/math/color.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace rt::tools {
namespace {

std::array<double, 3> channels(const Rgb32& c) {
  return {c.r, c.g, c.b};
}

// What is sent to a screen: sRGB from 0 to 1. NaN is shown as black.
std::array<double, 3> shown(const Rgb32& c) {
  std::array<double, 3> values = channels(c);
  for (double& v : values) v = std::isnan(v) ? 0 : linear_to_srgb(std::clamp(v, 0.0, 1.0));
  return values;
}

double largest(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double result = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) continue;
    const double d = std::abs(a[i] - b[i]);
    result = std::max(result, std::isnan(d) ? std::numeric_limits<double>::infinity() : d);
  }
  return result;
}

// Luma by ITU-R BT.601, as is usual for structural similarity.
double luma(const std::array<double, 3>& c) {
  return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
}

double angle(const Xyz32& a, const Xyz32& b) {
  const Vec3 u{a.x, a.y, a.z}, v{b.x, b.y, b.z};
  return std::atan2(length(cross(u, v)), dot(u, v));
}

Difference::Layers compare_layers(const Film& a, const Film& b) {
  Difference::Layers layers;
  for (std::size_t i = 0; i < a.depth.size(); ++i) {
    layers.other_object += a.object_id[i] != b.object_id[i];
    if (!std::isfinite(a.depth[i]) || !std::isfinite(b.depth[i])) continue;
    layers.depth_max = std::max(layers.depth_max, std::abs(a.depth[i] - b.depth[i]) / b.depth[i]);
    layers.normal_max = std::max(layers.normal_max, angle(a.normal[i], b.normal[i]));
  }
  return layers;
}

std::vector<double> gaussian(int size) {
  constexpr double deviation = 1.5;
  std::vector<double> weights(static_cast<std::size_t>(size));
  double sum = 0;
  for (int i = 0; i < size; ++i) {
    const double x = i - (size - 1) / 2.0;
    sum += weights[static_cast<std::size_t>(i)] = std::exp(-x * x / (2 * deviation * deviation));
  }
  for (double& w : weights) w /= sum;
  return weights;
}

struct Grid {
  int width = 0, height = 0;
  std::vector<double> values;
};

// The weighted mean at every position where the window fits, columns first, then rows.
Grid windowed(const Grid& in, const std::vector<double>& across, const std::vector<double>& down) {
  const auto n = [](const std::vector<double>& w) { return static_cast<int>(w.size()); };
  const auto at = [](const Grid& g, int x, int y) {
    return g.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(g.width) + static_cast<std::size_t>(x)];
  };
  Grid rows{in.width - n(across) + 1, in.height, {}};
  for (int y = 0; y < rows.height; ++y)
    for (int x = 0; x < rows.width; ++x) {
      double sum = 0;
      for (int i = 0; i < n(across); ++i) sum += across[static_cast<std::size_t>(i)] * at(in, x + i, y);
      rows.values.push_back(sum);
    }
  Grid out{rows.width, in.height - n(down) + 1, {}};
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      double sum = 0;
      for (int i = 0; i < n(down); ++i) sum += down[static_cast<std::size_t>(i)] * at(rows, x, y + i);
      out.values.push_back(sum);
    }
  return out;
}

} // namespace

double structural_similarity(const std::vector<double>& a, const std::vector<double>& b, int width, int height,
                             double range) {
  constexpr int window = 11;
  const std::vector<double> across = gaussian(std::min(window, width)), down = gaussian(std::min(window, height));
  const auto mean_of = [&](auto&& product) {
    Grid grid{width, height, std::vector<double>(a.size())};
    for (std::size_t i = 0; i < a.size(); ++i) grid.values[i] = product(a[i], b[i]);
    return windowed(grid, across, down).values;
  };
  const auto mean_a = mean_of([](double x, double) { return x; }), mean_b = mean_of([](double, double y) { return y; });
  const auto aa = mean_of([](double x, double) { return x * x; }), bb = mean_of([](double, double y) { return y * y; });
  const auto ab = mean_of([](double x, double y) { return x * y; });
  const double c1 = 0.01 * range * 0.01 * range, c2 = 0.03 * range * 0.03 * range;
  double sum = 0;
  for (std::size_t i = 0; i < ab.size(); ++i) {
    const double m = mean_a[i], n = mean_b[i];
    const double variance_a = aa[i] - m * m, variance_b = bb[i] - n * n, covariance = ab[i] - m * n;
    sum += (2 * m * n + c1) * (2 * covariance + c2) / ((m * m + n * n + c1) * (variance_a + variance_b + c2));
  }
  return sum / static_cast<double>(ab.size());
}

Difference difference(const Film& a, const Film& b) {
  assert(a.width == b.width && a.height == b.height && !a.color.empty());
  Difference d;
  d.width = a.width;
  d.height = a.height;
  std::vector<double> luma_a, luma_b;
  double squares = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const std::size_t i = a.index(x, y);
      const double error = largest(channels(a.color[i]), channels(b.color[i]));
      const auto p = shown(a.color[i]), q = shown(b.color[i]);
      d.color_error.push_back(static_cast<float>(error));
      d.color_equal += error <= 1e-5;
      d.color_within_8bit += largest(p, q) <= 1.0 / 255 + 1e-7; // values one step apart differ by 1/255 plus rounding
      if (error > d.color_max) d.color_max = error, d.color_max_x = x, d.color_max_y = y;
      for (std::size_t c = 0; c < 3; ++c) squares += (p[c] - q[c]) * (p[c] - q[c]);
      luma_a.push_back(luma(p));
      luma_b.push_back(luma(q));
    }
  d.rmse = std::sqrt(squares / (3 * static_cast<double>(a.color.size())));
  d.psnr = -20 * std::log10(d.rmse);
  d.ssim = structural_similarity(luma_a, luma_b, a.width, a.height);
  if (a.has_layers() && b.has_layers()) d.layers = compare_layers(a, b);
  return d;
}

} // namespace rt::tools
