#include "renderer/sampling/sobol.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace rt;

namespace {

double fraction(std::uint32_t reversed) {
  return reverse_bits(reversed) * 0x1p-32;
}

std::array<double, 4> sobol(std::uint32_t index) {
  const auto point = reversed_sobol(reverse_bits(index));
  return {fraction(point[0]), fraction(point[1]), fraction(point[2]), fraction(point[3])};
}

// Whether each cell of a grid of columns × rows holds one point.
bool is_one_each(const std::vector<std::array<double, 2>>& points, std::size_t columns, std::size_t rows) {
  std::vector<int> counts(columns * rows);
  for (const auto& p : points)
    ++counts[static_cast<std::size_t>(p[0] * static_cast<double>(columns)) * rows +
             static_cast<std::size_t>(p[1] * static_cast<double>(rows))];
  return std::all_of(counts.begin(), counts.end(), [](int n) { return n == 1; });
}

} // namespace

// By hand, from the direction numbers: v1 = ½ each; v2 = ¼, ¾, ¾, ¾; v3 = ⅛, ⅝, ⅜, ⅛; points are exclusive sums.
TEST_CASE("sobol: the first points are those of Joe and Kuo's table") {
  CHECK(sobol(0) == std::array{0.0, 0.0, 0.0, 0.0});
  CHECK(sobol(1) == std::array{0.5, 0.5, 0.5, 0.5});
  CHECK(sobol(3) == std::array{0.75, 0.25, 0.25, 0.25});
  CHECK(sobol(6) == std::array{0.375, 0.375, 0.625, 0.875});
}

TEST_CASE("sobol: scrambling permutes numbers, and blocks of them") {
  for (const std::uint32_t seed : {0u, 1u, 0xdeadbeefu}) {
    std::vector<bool> is_met(1 << 12);
    for (std::uint32_t i = 0; i < is_met.size(); ++i) {
      // The upper 20 bits go the same way for all: what is left runs through all values.
      const std::uint32_t low = reverse_bits(scramble_reversed(reverse_bits(i), seed)) % (1 << 12);
      CHECK_FALSE(is_met[low]);
      is_met[low] = true;
    }
  }
}

TEST_CASE("sample stream: the first two numbers of a group fill every elementary interval at every power of two") {
  for (const std::uint32_t group : {0u, 2u, 3u, 17u}) {
    for (std::uint32_t log = 0; log <= 10; ++log) {
      for (std::uint32_t half = 0; half < 2; ++half) {
        std::vector<std::array<double, 2>> points;
        for (std::uint32_t i = 0; i < 1u << log; ++i) {
          const auto numbers = SampleStream(5, 100, 7, 2 * i + half).group(group);
          points.push_back({numbers[0], numbers[1]});
        }
        for (std::uint32_t columns = 0; columns <= log; ++columns)
          CHECK(is_one_each(points, std::size_t{1} << columns, std::size_t{1} << (log - columns)));
      }
    }
  }
}

TEST_CASE("sample stream: each number by itself is spread evenly, never 0 or 1") {
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<std::array<double, 2>> points;
    for (std::uint32_t n = 0; n < 1024; ++n) {
      const double number = SampleStream(0, 3, 4, 2 * n).group(9)[i];
      CHECK((number > 0 && number < 1));
      points.push_back({number, 0});
    }
    CHECK(is_one_each(points, 1024, 1));
  }
}

// Of 2¹² independent pairs the mean of (u − ½)(v − ½) has the standard deviation 1/12/64 = 0.0013: five of them are
// exceeded once in 1.7 million times.
TEST_CASE("sample stream: groups, halves, pixels and seeds have nothing to do with each other") {
  const auto correlation = [](auto&& first, auto&& second) {
    double sum = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) sum += (first(i) - 0.5) * (second(i) - 0.5);
    return std::abs(sum / 4096);
  };
  const auto number = [](std::uint64_t seed, int x, int y, std::uint32_t half, std::uint32_t group, std::size_t i) {
    return [=](std::uint32_t n) { return SampleStream(seed, x, y, 2 * n + half).group(group)[i]; };
  };
  const auto one = number(0, 10, 20, 0, 2, 0);
  CHECK(correlation(one, number(0, 10, 20, 0, 3, 0)) < 0.0065);
  CHECK(correlation(one, number(0, 10, 20, 0, 4, 2)) < 0.0065);
  CHECK(correlation(one, number(0, 10, 20, 1, 2, 0)) < 0.0065);
  CHECK(correlation(one, number(0, 11, 20, 0, 2, 0)) < 0.0065);
  CHECK(correlation(one, number(0, 20, 10, 0, 2, 0)) < 0.0065);
  CHECK(correlation(one, number(1, 10, 20, 0, 2, 0)) < 0.0065);
}
