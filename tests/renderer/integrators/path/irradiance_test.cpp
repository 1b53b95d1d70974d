// Irradiance at a point by closed forms, `max_depth: 0`: lamps of radiance 1 that are shapes of every kind.

#include "renderer/math/degrees.hpp"
#include "tests/support/estimates.hpp"

#include <functional>

using namespace rt;
using namespace rt::tests;
using std::numbers::pi;

namespace {

struct Bench : SceneBuilder {
  Bench() { scene.max_depth = 0; }
};

// sin and cos of degrees, as an observer's normal tilted away from straight up.
Vec3 tilted(double degrees) {
  return {sin_degrees(degrees), cos_degrees(degrees), 0};
}

scene::Quad square(double size) {
  scene::Quad quad;
  quad.size = size, quad.normal = Vec3{0, 1, 0};
  return quad;
}

} // namespace

// A ball of sin² = 1/9 that is all above the horizon: π·cos/9. The others by quadrature.
TEST_CASE("path irradiance: a ball, seen whole and in parts") {
  for (const auto& [degrees, expected] :
       {std::pair{0.0, pi / 9}, {60.0, 0.1745329}, {80.0, 0.0652218}, {90.0, 0.0255672}, {100.0, 0.0046072}}) {
    Bench k;
    k.add(k.sphere().at({0, 3, 0}).with(k.glow(1)));
    check_estimate(irradiance(k, {}, tilted(degrees), 1 << 12), expected, 1e-3);
  }
}

// E = (π/2)(1 − (h² + a² − R²)/√((h² + a² + R²)² − 4R²a²)).
TEST_CASE("path irradiance: a disc, on its axis and aside") {
  for (const auto& [aside, expected] :
       {std::pair{0.0, pi / 5}, {0.5, 0.5802637}, {1.0, 0.4600756}, {1.5, 0.3213351}, {3.0, 0.0806081}}) {
    Bench k;
    k.add(k.shape(scene::Disc{}).at({aside, 2, 0}).with(k.glow(1)));
    check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 12), expected, 2e-3);
  }
}

TEST_CASE("path irradiance: a square, near, far and aside; and in two triangles, and as a polygon") {
  for (const auto& [height, aside, expected] :
       {std::tuple{1.0, 0.0, 1.7408395}, {2.0, 0.0, 0.7522747}, {2.0, 1.5, 0.4046234}}) {
    Bench k, l, m;
    k.add(k.shape(square(2)).at({aside, height, 0}).with(k.glow(1)));
    check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 13), expected, 1e-3);
    scene::Triangle one, other;
    one.points = {Vec3{-1, 0, -1}, Vec3{1, 0, -1}, Vec3{1, 0, 1}};
    other.points = {Vec3{-1, 0, -1}, Vec3{-1, 0, 1}, Vec3{1, 0, 1}};
    l.add(l.shape(one).at({aside, height, 0}).with(l.glow(1)));
    l.add(l.shape(other).at({aside, height, 0}).with(l.glow(1)));
    check_estimate(irradiance(l, {}, {0, 1, 0}, 1 << 13), expected, 2e-3);
    scene::Polygon diamond_cut; // the square with one more corner: no parallelogram to draw from
    diamond_cut.points = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 0}, {1, 0, 1}, {-1, 0, 1}};
    m.add(m.shape(diamond_cut).at({aside, height, 0}).with(m.glow(1)));
    check_estimate(irradiance(m, {}, {0, 1, 0}, 1 << 13), expected, 1e-3);
  }
}

// A box of which only the lower face is seen is a square; so is a cylinder a disc, and a wide cone too.
TEST_CASE("path irradiance: the faces of solids") {
  Bench k, l, m;
  k.add(k.box({-1, 2, -1}, {1, 3, 1}).with(k.glow(1)));
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 13), 0.7522747, 2e-3);
  scene::Cylinder cylinder;
  cylinder.from = Vec3{0, 2, 0}, cylinder.to = Vec3{0, 5, 0};
  l.add(l.shape(cylinder).with(l.glow(1)));
  check_estimate(irradiance(l, {}, {0, 1, 0}, 1 << 13), pi / 5, 2e-3);
  scene::Cone cone;
  cone.from = {0, 2, 0}, cone.to = {0, 3, 0};
  m.add(m.shape(cone).with(m.glow(1)));
  check_estimate(irradiance(m, {}, {0, 1, 0}, 1 << 13), pi / 5, 2e-3);
}

// An ellipsoid seen from below along its axis looks like the cone that touches it: for half-axes a across and b along,
// at the distance d, tan² = a²/(d² − b²), and E = π sin².
TEST_CASE("path irradiance: a ball that is stretched") {
  Bench k;
  k.add(k.sphere().at({0, 4, 0}).transformed(k.scaled({1.5, 2, 1.5})).with(k.glow(1)));
  const double tan2 = 2.25 / (16 - 4);
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 13), pi * tan2 / (1 + tan2), 2e-3);
}

// What a difference leaves of a flat cone, its upper half with a disc as its lower face, is seen as that disc by who is
// below; the half that is cut away and the cutter's own surface are drawn in vain.
TEST_CASE("path irradiance: a lamp cut out of solids, in a group that stands twice") {
  Bench k;
  scene::Cone cone;
  cone.from = {0, -0.2, 0}, cone.to = {0, 0.2, 0}, cone.radius = 2;
  const scene::Object lamp = k.subtract({k.shape(cone), k.box({-3, -1, -3}, {3, 0, 3})}).with(k.glow(1));
  const Thing group = k.group({lamp});
  k.add(Thing(group).at({0, 2, 0}));
  k.add(Thing(group).at({3, 2, 0}));
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 13), pi / 5 + 0.0806081, 1e-2);
}

// The lamp of a room: inside a ball of radiance 1 every direction shows 1.
TEST_CASE("path irradiance: from within a shining ball, box and cylinder it is π") {
  Bench k, l, m;
  k.add(k.sphere(2).with(k.glow(1)));
  check_estimate(irradiance(k, {0.5, 0.7, 0}, tilted(30), 1 << 12), pi, 1e-2);
  l.add(l.box({-1, -1, -2}, {1, 3, 1}).with(l.glow(1)));
  check_estimate(irradiance(l, {0.5, 0.7, 0}, tilted(30), 1 << 12), pi, 1e-2);
  scene::Cylinder cylinder;
  cylinder.from = Vec3{0, -1, 0}, cylinder.to = Vec3{0, 5, 0}, cylinder.radius = 2;
  m.add(m.shape(cylinder).with(m.glow(1)));
  check_estimate(irradiance(m, {0.5, 0.7, 0}, tilted(30), 1 << 12), pi, 1e-2);
}

// A lamp x ∈ [−1, 1], z ∈ [−½, ½] at the height 4, an opaque half plane x < 0 at 1: at (X, 0, 0) the visible part is
// x > −3X. Corner of a rectangle a × b at height h, A = a/h, B = b/h: E = ½(A/√(1 + A²)·atan(B/√(1 + A²)) + the same
// with A and B exchanged).
TEST_CASE("path irradiance: a penumbra") {
  for (const auto& [x, expected] : {std::pair{-0.2, 0.0219089},
                                    {-0.1, 0.0402659},
                                    {0.0, 0.0594292},
                                    {0.1, 0.0784643},
                                    {0.2, 0.0964376},
                                    {1.0 / 3, 0.1174437},
                                    {-0.34, 0.0}}) {
    Bench k;
    scene::Quad lamp, screen;
    lamp.corner = Vec3{-1, 4, -0.5}, lamp.edge_u = Vec3{2, 0, 0}, lamp.edge_v = Vec3{0, 0, 1};
    screen.corner = Vec3{-100, 1, -100}, screen.edge_u = Vec3{100, 0, 0}, screen.edge_v = Vec3{0, 0, 200};
    k.add(k.shape(lamp).with(k.glow(1)));
    k.add(k.shape(screen));
    check_estimate(irradiance(k, {x, 0, 0}, {0, 1, 0}, 1 << 13), expected, 3e-4);
  }
}

// Two lamps of which one is a hundred times as strong, and many small ones: choosing changes no mean.
TEST_CASE("path irradiance: several lamps give the sum of what each gives") {
  Bench k;
  k.add(k.shape(scene::Disc{}).at({0, 2, 0}).with(k.glow(1)));
  k.add(k.shape(scene::Disc{}).at({3, 2, 0}).with(k.glow(100)));
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 13), pi / 5 + 8.06081, 2e-2);
  Bench many; // 25 tiles of a square 2 × 2 at the height 1
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      many.add(many.shape(square(0.4)).at({0.4 * (i - 2), 1, 0.4 * (j - 2)}).with(many.glow(1)));
  check_estimate(irradiance(many, {}, {0, 1, 0}, 1 << 13), 1.7408395, 8e-3);
}

TEST_CASE("path irradiance: what casts no shadow neither hides a lamp nor is one") {
  Bench k;
  k.add(k.shape(scene::Disc{}).at({0, 2, 0}).with(k.glow(1)));
  k.add(k.shape(square(10)).at({0, 1, 0}).without_shadow());
  k.add(k.shape(square(10)).at({0, 0.5, 0}).with(k.glow(5)).without_shadow());
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 12), pi / 5, 2e-3);
}

// Panes that do not bend the light: each takes half of it. What bends it is looked through by chance alone.
TEST_CASE("path irradiance: a lamp behind glass") {
  Bench k, l;
  k.add(k.shape(scene::Disc{}).at({0, 2, 0}).with(k.glow(1)));
  k.add(k.shape(square(10)).at({0, 1, 0}).with(k.clear(1, 0.5)));
  k.add(k.box({-5, 0.4, -5}, {5, 0.6, 5}).with(k.clear(1, 0.5)));
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 12), pi / 5 / 8, 5e-4);
  l.scene.max_depth = 4;
  l.scene.background = white;
  l.add(l.sphere().at({0, 2, 0}).with(l.clear(1.5)));
  check_estimate(irradiance(l, {}, {0, 1, 0}, 1 << 12), pi, 1e-2); // the furnace: glass shows what is around
}
