#include "tools/povray/export/map.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::tools::povray;

namespace {

void check_near(const Vec3& a, const Vec3& b) {
  CHECK(a.x == Approx(b.x).margin(1e-15));
  CHECK(a.y == Approx(b.y).margin(1e-15));
  CHECK(a.z == Approx(b.z).margin(1e-15));
}

} // namespace

TEST_CASE("exporter's maps: rotations are right-handed and go x, then y, then z") {
  check_near(map_of(scene::RotateStep{{90, 0, 0}, {}}).vector({0, 1, 0}), {0, 0, 1});
  check_near(map_of(scene::RotateStep{{0, 90, 0}, {}}).vector({0, 0, 1}), {1, 0, 0});
  check_near(map_of(scene::RotateStep{{0, 0, 90}, {}}).vector({1, 0, 0}), {0, 1, 0});
  // y goes to z by the first turn, and z to x by the second.
  check_near(map_of(scene::RotateStep{{90, 90, 0}, {}}).vector({0, 1, 0}), {1, 0, 0});
}

TEST_CASE("exporter's maps: a rotation about the diagonal by a third of a turn permutes the axes") {
  const Map map = map_of(scene::RotateAxisStep{{2, 2, 2}, 120, {}});
  check_near(map.vector({1, 0, 0}), {0, 1, 0});
  check_near(map.vector({0, 1, 0}), {0, 0, 1});
  check_near(map.vector({0, 0, 1}), {1, 0, 0});
}

TEST_CASE("exporter's maps: a rotation by 30 degrees about y, with its known matrix") {
  const double h = std::sqrt(3) / 2;
  const Map map = map_of(scene::RotateAxisStep{{0, 5, 0}, 30, {}});
  check_near(map.vector({1, 0, 0}), {h, 0, -0.5});
  check_near(map.vector({0, 0, 1}), {0.5, 0, h});
}

TEST_CASE("exporter's maps: a mirror keeps its plane and turns its normal round") {
  const Map map = map_of(scene::MirrorStep{{1, 1, 0}, {1, 0, 0}});
  check_near(map.point({1, 0, 7}), {1, 0, 7});
  check_near(map.point({0, 1, -3}), {0, 1, -3});
  check_near(map.vector({1, 1, 0}), {-1, -1, 0});
  // The origin lies √½ before the plane x + y = 1.
  check_near(map.point({0, 0, 0}), {1, 1, 0});
}

TEST_CASE("exporter's maps: a shear adds multiples of the other coordinates") {
  const Map map = map_of(scene::ShearStep{2, 3, 5, 7, 11, 13, {}});
  // x' = x + 2y + 3z, y' = y + 5x + 7z, z' = z + 11x + 13y
  CHECK(map.point({1, 10, 100}) == Vec3{321, 715, 241});
}

TEST_CASE("exporter's maps: a placement scales, rotates, moves, then follows its chain, about fixed points") {
  scene::Placement placement{{2, 3, 4}, {0, 0, 90}, {1, 0, 0}, {}};
  check_near(map_of(placement).point({1, 1, 1}), {-2, 2, 4});
  placement.chain = {scene::ScaleStep{{2, 2, 2}, {-2, 2, 4}}, scene::MoveStep{{0, 0, 1}}};
  check_near(map_of(placement).point({1, 1, 1}), {-2, 2, 5});
  check_near(map_of(placement).point({0, 0, 0}), {4, -2, -3});
}

TEST_CASE("exporter's maps: the inverse undoes") {
  const Map map =
      map_of(scene::Placement{{2, -3, 0.5}, {10, 20, 30}, {4, 5, 6}, {scene::ShearStep{0.2, 0, 0.4, 0, 0, 0.1, {}}}});
  const Vec3 p{1.5, -2.5, 3.5};
  const Vec3 back = inverse(map).point(map.point(p));
  CHECK(back.x == Approx(p.x).epsilon(1e-14));
  CHECK(back.y == Approx(p.y).epsilon(1e-14));
  CHECK(back.z == Approx(p.z).epsilon(1e-14));
}
