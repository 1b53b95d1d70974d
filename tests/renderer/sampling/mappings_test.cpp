#include "renderer/sampling/mappings.hpp"
#include "renderer/sampling/sobol.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace rt;

namespace {

// The mean of f(u, v) over evenly spread points.
template <class F>
double mean(F&& f) {
  constexpr std::uint32_t count = 1 << 14;
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto numbers = SampleStream(1, 2, 3, 2 * i).group(0);
    sum += f(numbers[0], numbers[1]);
  }
  return sum / count;
}

} // namespace

// Of the unit disc: the mean of x² is ¼, of (x² + y²)² ⅓, and a quarter of it lies in x > 0, y > 0.
TEST_CASE("mappings: the disc is filled evenly") {
  CHECK(mean([](double u, double v) { return to_disc(u, v).x; }) == Approx(0).margin(1e-4));
  CHECK(mean([](double u, double v) { return std::pow(to_disc(u, v).x, 2); }) == Approx(0.25).epsilon(1e-3));
  CHECK(mean([](double u, double v) {
          const Vec2 d = to_disc(u, v);
          return std::pow(d.x * d.x + d.y * d.y, 2);
        }) == Approx(1.0 / 3).epsilon(1e-3));
  CHECK(mean([](double u, double v) {
          const Vec2 d = to_disc(u, v);
          return d.x > 0 && d.y > 0 ? 1.0 : 0.0;
        }) == Approx(0.25).epsilon(2e-3));
  CHECK(to_disc(0.5, 0.5).x == 0);
}

// With the density cos θ/π: the mean of cos θ is ⅔, of cos² θ ½, of x² ¼.
TEST_CASE("mappings: the hemisphere has its density in proportion to the cosine") {
  CHECK(mean([](double u, double v) { return to_cosine_hemisphere(u, v).z; }) == Approx(2.0 / 3).epsilon(1e-3));
  CHECK(mean([](double u, double v) { return std::pow(to_cosine_hemisphere(u, v).z, 2); }) ==
        Approx(0.5).epsilon(1e-3));
  CHECK(mean([](double u, double v) { return std::pow(to_cosine_hemisphere(u, v).x, 2); }) ==
        Approx(0.25).epsilon(1e-3));
}

// By Archimedes each coordinate of an even sphere is even over −1 to 1; over a cap, z is.
TEST_CASE("mappings: sphere and cone are filled evenly with unit vectors") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CHECK(mean([&](double u, double v) { return to_sphere(u, v)[axis]; }) == Approx(0).margin(1e-3));
    CHECK(mean([&](double u, double v) { return std::pow(to_sphere(u, v)[axis], 2); }) ==
          Approx(1.0 / 3).epsilon(2e-3));
    CHECK(mean([&](double u, double v) { return std::pow(to_sphere(u, v)[axis], 4); }) ==
          Approx(1.0 / 5).epsilon(2e-3));
  }
  CHECK(mean([](double u, double v) { return length(to_sphere(u, v)); }) == Approx(1).epsilon(1e-14));
  CHECK(mean([](double u, double v) { return length(to_cone(u, v, 1e-9)); }) == Approx(1).epsilon(1e-14));
  CHECK(mean([](double u, double v) { return to_cone(u, v, 0.5).z; }) == Approx(0.75).epsilon(1e-4));
  CHECK(mean([](double u, double v) { return to_cone(u, v, 0.5).z < 0.5 ? 1.0 : 0.0; }) == 0);
}

// The mean of a corner's weight is ⅓, of its square ⅙.
TEST_CASE("mappings: the triangle is filled evenly") {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    CHECK(mean([&](double u, double v) { return to_triangle(u, v)[corner]; }) == Approx(1.0 / 3).epsilon(1e-3));
    CHECK(mean([&](double u, double v) { return std::pow(to_triangle(u, v)[corner], 2); }) ==
          Approx(1.0 / 6).epsilon(2e-3));
  }
}

TEST_CASE("mappings: a frame is right-handed, at right angles, whatever its z") {
  for (const Vec3& z : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{0.6, 0, 0.8}, Vec3{0, 1, 0}, Vec3{0.48, -0.6, -0.64}}) {
    const TangentFrame frame(z);
    const Vec3 x = frame.vector({1, 0, 0}), y = frame.vector({0, 1, 0});
    CHECK(length(frame.vector({0, 0, 1}) - z) == 0);
    CHECK(length(cross(x, y) - z) < 1e-15);
    CHECK(dot(x, y) == Approx(0).margin(1e-15));
    CHECK(length(x) == Approx(1).epsilon(1e-15));
  }
}
