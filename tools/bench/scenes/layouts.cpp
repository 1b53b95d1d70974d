#include "renderer/math/degrees.hpp"
#include "tools/bench/scenes/layout.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

namespace rt::tools::bench {
namespace {

constexpr double pi = 3.14159265358979323846;

// Uniform numbers in [0, 1) that are the same with every standard library.
class Random {
public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_()) * 0x1p-32; }
  double between(double low, double high) { return low + (high - low) * (*this)(); }
  Vec3 point(double low, double high) {
    const double x = between(low, high), y = between(low, high), z = between(low, high);
    return {x, y, z};
  }
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((*this)() * n); }

private:
  std::mt19937 engine_;
};

std::vector<BenchLight> two_lights(const Vec3& eye, double distance) {
  const Vec3 right = normalize(cross(-eye, {0, 1, 0}));
  return {{normalize(eye - right * length(eye) * 0.6 + Vec3{0, length(eye), 0}) * distance, {0.7, 0.7, 0.7}},
          {normalize(eye * 0.5 + right * length(eye) + Vec3{0, 0.3 * length(eye), 0}) * distance, {0.4, 0.4, 0.5}}};
}

// Eight colours, every other one a mirror.
std::vector<Finish> palette() {
  std::vector<Finish> finishes;
  const std::array<Color, 8> colors = {Color{0.8, 0.2, 0.15}, {0.2, 0.6, 0.25}, {0.2, 0.3, 0.8}, {0.85, 0.7, 0.2},
                                       {0.6, 0.3, 0.7},       {0.3, 0.7, 0.7},  {0.8, 0.5, 0.3}, {0.7, 0.7, 0.7}};
  for (std::size_t i = 0; i < colors.size(); ++i)
    finishes.push_back({.color = colors[i], .reflect = i % 2 == 0 ? 0.3 : 0});
  return finishes;
}

// Two unit vectors that are perpendicular to the unit vector n and to each other.
std::array<Vec3, 2> across(const Vec3& n) {
  const Vec3 u = normalize(cross(std::abs(n.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, n));
  return {u, cross(n, u)};
}

void add_flake(Layout& layout, const Vec3& center, double radius, const Vec3& axis, int depth) {
  layout.balls.push_back({center, radius, 1});
  if (depth == 0) return;
  const auto [u, v] = across(axis);
  for (int i = 0; i < 9; ++i) {
    const double around = i < 6 ? 60 * i : 30 + 120 * (i - 6), up = i < 6 ? 0 : 55;
    const Vec3 direction =
        (u * cos_degrees(around) + v * sin_degrees(around)) * cos_degrees(up) + axis * sin_degrees(up);
    add_flake(layout, center + direction * (radius * 4 / 3), radius / 3, direction, depth - 1);
  }
}

Layout sphereflake(int depth) {
  Layout layout;
  layout.eye = {3.8, 3.1, 4.6};
  layout.target = {0, -0.1, 0};
  layout.fov = 40;
  layout.background = {0.08, 0.36, 0.72};
  layout.lights = two_lights(layout.eye, 20);
  layout.finishes = {{.color = {1, 0.75, 0.33}, .specular = 0},
                     {.color = {1, 0.9, 0.7}, .diffuse = 0.5, .reflect = 0.5}};
  layout.floors = {{-1.1, 0}};
  add_flake(layout, {0, 0, 0}, 1, {0, 1, 0}, depth);
  return layout;
}

// A dodecahedron of tubes with spheres at its corners; `size` is the distance of the corners from the centre.
void add_cage(Layout& layout, const Vec3& center, double size, std::uint32_t finish) {
  const double phi = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3> corners;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0}) {
      for (const double c : {-1.0, 1.0}) corners.push_back({a, b, c});
      corners.insert(corners.end(), {{0, a / phi, b * phi}, {a / phi, b * phi, 0}, {a * phi, 0, b / phi}});
    }
  const double edge = 2 / phi, scale = size / std::sqrt(3.0);
  for (const Vec3& corner : corners) layout.balls.push_back({center + corner * scale, size * 0.11, finish});
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(length(corners[i] - corners[j]) - edge) < 1e-6)
        layout.tubes.push_back({center + corners[j] * scale, center + corners[i] * scale, size * 0.07, finish});
}

// A pyramid of cages.
Layout rings() {
  constexpr int layers = 18;
  Layout layout;
  layout.eye = {26, 15, 30};
  layout.target = {0.5, 7.2, 0};
  layout.fov = 29;
  layout.background = {0.08, 0.36, 0.72};
  layout.lights = two_lights(layout.eye, 100);
  layout.finishes = palette();
  layout.finishes.push_back({.color = {0.8, 0.78, 0.7}, .specular = 0});
  layout.floors = {{0, 8}};
  for (int layer = 0; layer < layers; ++layer) {
    const int rows = layers - layer;
    for (int row = 0; row < rows; ++row)
      for (int place = 0; place <= row; ++place) {
        const double z = row - (rows - 1) * 2 / 3.0, x = place - row * 0.5;
        add_cage(layout, {x * 1.2, 0.6 + layer * 0.95, z * 1.05}, 0.57,
                 static_cast<std::uint32_t>(layer + row * 3 + place * 5) % 8);
      }
  }
  return layout;
}

constexpr Vec3 cube_eye{20, 14, 24};

// A hundred thousand each of spheres, open tubes and triangles, scattered over a cube.
Layout mixed() {
  constexpr int each = 100'000;
  Layout layout;
  layout.eye = cube_eye;
  layout.background = {0.05, 0.08, 0.15};
  layout.lights = two_lights(layout.eye, 100);
  layout.finishes = palette();
  Random random(1);
  for (int i = 0; i < each; ++i) {
    const Vec3 center = random.point(-8, 8);
    layout.balls.push_back({center, random.between(0.03, 0.09), random.below(8)});
  }
  for (int i = 0; i < each; ++i) {
    const Vec3 from = random.point(-8, 8), to = from + random.point(-0.35, 0.35);
    layout.tubes.push_back({from, to, random.between(0.02, 0.05), random.below(8)});
  }
  for (int i = 0; i < each; ++i) {
    const Vec3 a = random.point(-8, 8), b = a + random.point(-0.25, 0.25), c = a + random.point(-0.25, 0.25);
    layout.triangles.push_back({{a, b, c}, random.below(8)});
  }
  return layout;
}

// Equal spheres that fill 4 % of a cube, whatever their number.
Layout random_balls(int count) {
  Layout layout;
  layout.eye = cube_eye;
  layout.background = {0.05, 0.08, 0.15};
  layout.lights = two_lights(layout.eye, 100);
  layout.finishes = palette();
  const double radius = 16 * std::cbrt(0.04 * 3 / (4 * pi * count));
  Random random(2);
  for (int i = 0; i < count; ++i) {
    const Vec3 center = random.point(-8, 8);
    layout.balls.push_back({center, radius, random.below(8)});
  }
  return layout;
}

// After the picture in Whitted's paper (An Improved Illumination Model for Shaded Display, 1980): a glass sphere in
// front of a mirror, over a checkered floor. The floor is made of triangles; a few more spheres are added.
Layout whitted() {
  Layout layout;
  layout.eye = {0, 1.6, 7.5};
  layout.target = {0, 0.6, 0};
  layout.fov = 42;
  layout.background = {0.2, 0.35, 0.7};
  layout.lights = {{{-6, 9, 6}, {0.8, 0.8, 0.8}}, {{7, 6, 3}, {0.4, 0.4, 0.35}}};
  layout.finishes = {{.color = {0.9, 0.15, 0.1}, .specular = 0},
                     {.color = {0.9, 0.8, 0.15}, .specular = 0},
                     {.color = white, .diffuse = 0.2, .specular = 0.6, .reflect = 0.1, .refract = 0.85, .ior = 1.5},
                     {.color = {0.8, 0.85, 0.9}, .diffuse = 0.3, .specular = 0.6, .reflect = 0.6},
                     {.color = {0.2, 0.5, 0.25}, .reflect = 0.1}};
  for (int row = -10; row < 5; ++row)
    for (int column = -8; column < 8; ++column) {
      const double x = column, z = row;
      const Vec3 a{x, -0.6, z}, b{x + 1, -0.6, z}, c{x + 1, -0.6, z + 1}, d{x, -0.6, z + 1};
      const std::uint32_t finish = (column + row) % 2 == 0 ? 0 : 1;
      layout.triangles.push_back({{a, b, c}, finish});
      layout.triangles.push_back({{a, c, d}, finish});
    }
  layout.balls = {
      {{-0.3, 0.75, 1.8}, 0.9, 2}, {{1.1, 0.5, -0.6}, 1.0, 3}, {{-2.2, 0.1, -0.8}, 0.7, 4}, {{2.5, -0.2, 1.6}, 0.4, 4}};
  return layout;
}

Layout build(std::string_view name) {
  if (name == "sphereflake_4") return sphereflake(4);
  if (name == "sphereflake_6") return sphereflake(6);
  if (name == "rings") return rings();
  if (name == "mixed") return mixed();
  if (name == "random_10k") return random_balls(10'000);
  if (name == "random_1m") return random_balls(1'000'000);
  if (name == "whitted") return whitted();
  throw std::invalid_argument("there is no scene `" + std::string(name) + "`");
}

} // namespace

Layout make_layout(std::string_view name) {
  Layout layout = build(name);
  layout.name = name;
  return layout;
}

} // namespace rt::tools::bench
