#include "tests/renderer/scattering/surfaces.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>

using namespace rt;
using namespace rt::tests;

namespace {

constexpr int rows = 32, columns = 64; // of the cosine, of the azimuth: cells of equal solid angle
constexpr double cell_size = 4 * std::numbers::pi / (rows * columns);

/// The integral of the density over a cell, by n × n points.
double integrate_cell(const Bsdf& bsdf, int row, int column, int n) {
  double sum = 0;
  for (int i = 0; i < n * n; ++i) {
    const double z = -1 + 2 * (row + (i / n + 0.5) / n) / rows, turns = (column + (i % n + 0.5) / n) / columns;
    sum += bsdf.density(direction(z, turns));
  }
  return sum * cell_size / (n * n);
}

/// Of every cell, so well that the error is nothing beside the noise of so many draws.
std::vector<double> integrate_cells(const Bsdf& bsdf, int draws) {
  std::vector<double> cells;
  for (int i = 0; i < rows * columns; ++i) {
    const int coarse = draws > 100'000 ? 16 : 4;
    double integral = integrate_cell(bsdf, i / columns, i % columns, coarse);
    for (int n = 2 * coarse; n <= 128; n *= 2) {
      const double before = std::exchange(integral, integrate_cell(bsdf, i / columns, i % columns, n));
      if (std::abs(integral - before) * draws <= 0.05 * std::sqrt(integral * draws) + 0.01) break;
    }
    cells.push_back(integral);
  }
  return cells;
}

std::size_t cell_of(const Vec3& w) {
  const double turns = std::atan2(w.y, w.x) / (2 * std::numbers::pi);
  const int row = std::min(rows - 1, static_cast<int>((w.z + 1) / 2 * rows));
  const int column = std::min(columns - 1, static_cast<int>((turns < 0 ? turns + 1 : turns) * columns));
  return static_cast<std::size_t>(row * columns + column);
}

/// The probability that a χ² of so many degrees of freedom is exceeded (E. Wilson, M. Hilferty, 1931; they are many).
double exceeded(double chi2, double freedom) {
  const double spread = 2 / (9 * freedom);
  const double z = (std::cbrt(chi2 / freedom) - (1 - spread)) / std::sqrt(spread);
  return std::erfc(z / std::numbers::sqrt2) / 2;
}

/// Pearson's test of draws against the density; what is perfect or lost is a cell of its own. Cells of which less than
/// 5 are expected are pooled.
double p_value(const Bsdf& bsdf, int draws, std::uint64_t seed) {
  std::vector<double> expected = integrate_cells(bsdf, draws);
  double spread = 0;
  for (const double cell : expected) spread += cell;
  expected.push_back(std::max(0.0, 1 - spread));
  std::vector<int> found(expected.size());
  SplitMix64 random(seed);
  for (int i = 0; i < draws; ++i) {
    const double u = random.unit(), v = random.unit(), choice = random.unit();
    const auto sample = bsdf.sample(u, v, choice);
    ++found[sample && !sample->is_perfect ? cell_of(sample->wi) : found.size() - 1];
  }
  double chi2 = 0, pooled_expected = 0, pooled_found = 0;
  int cells = 0;
  const auto add = [&](double wanted, double got) { chi2 += (got - wanted) * (got - wanted) / wanted, ++cells; };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double wanted = expected[i] * draws;
    if (wanted >= 5)
      add(wanted, found[i]);
    else
      pooled_expected += wanted, pooled_found += found[i];
  }
  if (pooled_expected >= 5) add(pooled_expected, pooled_found);
  return cells > 1 ? exceeded(chi2, cells - 1) : 1;
}

/// With a chance of 1 % to fail if all is right, over all of its tests (Z. Šidák, 1967).
void check_samplers(int draws) {
  constexpr double cosines[] = {0.15, 0.6, 0.97};
  const std::vector<Surface> all = surfaces();
  const double least = 1 - std::pow(0.99, 1.0 / static_cast<double>(all.size() * std::size(cosines)));
  std::uint64_t seed = 2023;
  for (const Surface& surface : all) {
    const TabulatedSurface tabulated(surface);
    for (const double cosine : cosines) {
      INFO(surface.name << ", cosine " << cosine);
      CHECK(p_value(tabulated.bsdf(direction(cosine)), draws, ++seed) > least);
    }
  }
}

} // namespace

TEST_CASE("sampling: the directions of every lobe have the density that it tells") {
  check_samplers(50'000);
}

TEST_CASE("sampling: the directions of every lobe have the density that it tells, a million of each", "[.slow]") {
  check_samplers(1'000'000);
}

TEST_CASE("sampling: a density's integral and what is lost or perfect are one") {
  for (const Surface& surface : surfaces()) {
    const TabulatedSurface tabulated(surface);
    for (const double cosine : {0.2, 0.9}) {
      const Bsdf bsdf = tabulated.bsdf(direction(cosine));
      double spread = 0;
      for (const double cell : integrate_cells(bsdf, 1'000'000)) spread += cell;
      double elsewhere = 0;
      const int count = 5'000;
      const Color all = mean_of_samples(bsdf, count, [&](const BsdfSample& sample) {
        elsewhere += sample.is_perfect ? 1.0 / count : 0;
        return white;
      });
      INFO(surface.name << ", cosine " << cosine);
      CHECK(spread + elsewhere + (1 - all.r) == Approx(1).margin(4e-3));
    }
  }
}

TEST_CASE("sampling: the weight is the light by the density, and the light of one sampler is that of another") {
  for (const Surface& surface : surfaces()) {
    const TabulatedSurface tabulated(surface);
    const Bsdf bsdf = tabulated.bsdf(direction(0.5));
    if (!bsdf.has_spread()) continue;
    // ∫ f cos³ dω by the lobes' own directions, and by all directions alike.
    const Color own = mean_of_samples(bsdf, 20'000, [](const BsdfSample& sample) {
      return sample.is_perfect ? black : sample.weight * (sample.wi.z * sample.wi.z);
    });
    Color even = black;
    const int n = 200;
    for (int i = 0; i < n * n; ++i) {
      const Vec3 wi = direction(-1 + 2 * (i / n + 0.5) / n, (i % n + 0.5) / n);
      even += bsdf.evaluate(wi) * (std::abs(wi.z) * wi.z * wi.z * 4 * std::numbers::pi / (n * n));
    }
    INFO(surface.name);
    CHECK(own.r == Approx(even.r).epsilon(5e-3));
    CHECK(own.b == Approx(even.b).epsilon(5e-3));
  }
}
