#include "renderer/sampling/sobol.hpp"
#include "renderer/shapes/box.hpp"
#include "renderer/shapes/cone.hpp"
#include "renderer/shapes/cylinder.hpp"
#include "renderer/shapes/disc.hpp"
#include "renderer/shapes/polygon.hpp"
#include "renderer/shapes/quad.hpp"
#include "renderer/shapes/sphere.hpp"
#include "renderer/shapes/triangle.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace rt;
using std::numbers::pi;

namespace {

// The mean of f(point) over points drawn from the surface, evenly spread.
template <class L, class F>
double mean(const L& surface, F&& f) {
  constexpr std::uint32_t count = 1 << 14;
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto numbers = SampleStream(1, 2, 3, 2 * i).group(0);
    sum += f(point_by_area(surface, numbers[0], numbers[1]));
  }
  return sum / count;
}

// A ray that comes against the point's normal meets the shape there, with that normal.
template <class G>
void check_points(const G& shape) {
  const auto surface = lamp_surface(shape);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const auto numbers = SampleStream(4, 0, 0, i).group(0);
    const AreaPoint p = point_by_area(surface, numbers[0], numbers[1]);
    const Ray ray{p.position + p.normal * 0.5, -p.normal};
    Hit hit;
    REQUIRE(intersect(shape, ray, {}, hit));
    CHECK(hit.t == Approx(0.5).epsilon(1e-12));
    CHECK(dot(surface_point(shape, ray, hit).normal, p.normal) == Approx(1).epsilon(1e-12));
  }
}

} // namespace

TEST_CASE("area: a ball's is 4πr², evenly drawn") {
  const SphereGeometry ball{{1, 2, 3}, 2};
  CHECK(area(ball) == Approx(16 * pi));
  check_points(ball);
  CHECK(mean(ball, [](const AreaPoint& p) { return p.position.x; }) == Approx(1).epsilon(1e-3));
}

// Of a ring from r to R about the origin the mean squared distance is (R² + r²)/2.
TEST_CASE("area: a disc's is that of the ring, evenly drawn") {
  const DiscGeometry disc{{0, 1, 0}, normalize(Vec3{1, 2, 2}), 3, 2};
  CHECK(area(disc) == Approx(5 * pi));
  check_points(disc);
  const auto squared = [](const AreaPoint& p) { return dot(p.position - Vec3{0, 1, 0}, p.position - Vec3{0, 1, 0}); };
  CHECK(mean(disc, squared) == Approx(6.5).epsilon(1e-3));
  const DiscGeometry whole{{0, 1, 0}, {0, 1, 0}, 3, 0};
  CHECK(mean(whole, squared) == Approx(4.5).epsilon(1e-3));
}

TEST_CASE("area: triangles and parallelograms are drawn evenly, by halves and thirds") {
  const TriangleGeometry triangle{{Vec3{0, 0, 0}, Vec3{3, 0, 0}, Vec3{0, 4, 0}}};
  CHECK(area(triangle) == Approx(6));
  check_points(triangle);
  CHECK(mean(triangle, [](const AreaPoint& p) { return p.position.x; }) == Approx(1).epsilon(1e-3));
  scene::Quad q;
  q.corner = Vec3{1, 0, 0}, q.edge_u = Vec3{2, 0, 0}, q.edge_v = Vec3{1, 3, 0};
  const QuadGeometry quad = geometry(q);
  CHECK(area(lamp_surface(quad)) == Approx(6));
  check_points(quad);
  CHECK(mean(lamp_surface(quad), [](const AreaPoint& p) { return p.position.x; }) == Approx(2.5).epsilon(1e-3));
}

// An L of three unit squares: the square around it has the area 4, of which it holds three quarters.
TEST_CASE("area: what is no parallelogram is drawn from a rectangle around it") {
  scene::Polygon l;
  l.points = {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}};
  const PolygonGeometry polygon = geometry(l);
  CHECK(area(lamp_surface(polygon)) == Approx(4));
  const double inside = mean(lamp_surface(polygon), [&](const AreaPoint& p) {
    Hit hit;
    return intersect(polygon, {p.position + p.normal, -p.normal}, {}, hit) ? 1.0 : 0.0;
  });
  CHECK(inside == Approx(0.75).epsilon(1e-3));
}

// Faces of 6, 3 and 2 (each twice): the upper one along x has a share of 6/22.
TEST_CASE("area: a box's faces are drawn by their areas") {
  const BoxGeometry box{{0, 0, 0}, {1, 2, 3}};
  CHECK(area(box) == Approx(22));
  check_points(box);
  CHECK(mean(box, [](const AreaPoint& p) { return p.normal.x == 1 ? 1.0 : 0.0; }) == Approx(6.0 / 22).epsilon(1e-3));
  CHECK(mean(box, [](const AreaPoint& p) { return p.position.z; }) == Approx(1.5).epsilon(1e-3));
}

TEST_CASE("area: a cylinder's side and ends are drawn by their areas, and an endless one has none to draw") {
  scene::Cylinder c;
  c.from = Vec3{0, 0, 0}, c.to = Vec3{0, 2, 0};
  const CylinderGeometry closed = geometry(c);
  CHECK(area(closed) == Approx(6 * pi)); // 2·2π and 2·π
  check_points(closed);
  CHECK(mean(closed, [](const AreaPoint& p) { return p.normal.y < -0.5 ? 1.0 : 0.0; }) ==
        Approx(1.0 / 6).epsilon(1e-3));
  CHECK(mean(closed, [](const AreaPoint& p) { return p.position.y; }) == Approx(1).epsilon(1e-3));
  c.open = true;
  CHECK(area(geometry(c)) == Approx(4 * pi));
  check_points(geometry(c));
  c.open = false, c.infinite = true;
  CHECK(std::isinf(area(geometry(c))));
}

// Radii 3 and 1, height 2: the slant is √8, the side π·4·√8; the mean height of the side is h(R + 2r)/(3(R + r)) = 5/6.
TEST_CASE("area: a cone's side is drawn evenly, more of it where it is wide") {
  scene::Cone c;
  c.to = {0, 2, 0}, c.radius = 3, c.top_radius = 1, c.open = true;
  const ConeGeometry open = geometry(c);
  CHECK(area(open) == Approx(4 * std::sqrt(8.0) * pi));
  check_points(open);
  CHECK(mean(open, [](const AreaPoint& p) { return p.position.y; }) == Approx(5.0 / 6).epsilon(1e-3));
  c.open = false;
  CHECK(area(geometry(c)) == Approx(4 * std::sqrt(8.0) * pi + 10 * pi));
  check_points(geometry(c));
  c.top_radius = 0; // a point
  check_points(geometry(c));
}
