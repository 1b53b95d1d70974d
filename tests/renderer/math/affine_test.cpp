#include "renderer/math/affine.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using rt::tests::near;
using rt::tests::Random;

TEST_CASE("maps: those that keep shapes similar are known with their factor") {
  CHECK(similarity_scale(Affine{}) == 1.0);
  CHECK(similarity_scale(Affine::scaling({2, -2, 2})) == 2.0);
  CHECK_FALSE(similarity_scale(Affine::scaling({2, 2, 2.000001})));
  CHECK_FALSE(similarity_scale(Affine::scaling({0, 0, 0})));
  CHECK_FALSE(similarity_scale(Affine{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {}}));
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    Affine map;
    for (int k = 0; k < 4; ++k) {
      const Vec3 axis = random.direction();
      map = Affine::rotating(axis, random.between(-180, 180)) * map;
    }
    const double scale = random.magnitude(1e-6, 1e6);
    map = Affine::translating(random.vector(-1e6, 1e6)) * map * Affine::scaling({scale, scale, -scale});
    const auto found = similarity_scale(map);
    REQUIRE(found);
    CHECK(*found == Approx(scale).epsilon(1e-14));
  }
}

TEST_CASE("maps: normals stay perpendicular to the surface, and outward") {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Affine map{random.vector(-2, 2), random.vector(-2, 2), random.vector(-2, 2), {}};
    const Vec3 n = random.direction(), along = reject(random.direction(), n);
    const Vec3 image = map.normal(n);
    CHECK(std::abs(dot(image, map.vector(along))) < 1e-13);
    CHECK(dot(image, map.vector(n)) >= 0);
    const auto back = inverse(map);
    if (back) CHECK(near(normalize(image), normalize(back->transposed_vector(n)), 1e-11));
  }
}

// The source notes' maps.
TEST_CASE("maps: rotation about y by 30° and translation by (−6, 4, 5)") {
  const double h = std::sqrt(3.0) / 2;
  const Affine turn = Affine::rotating({0, 1, 0}, 30);
  CHECK(near(turn.point({1, 0, 0}), {h, 0, -0.5}));
  CHECK(near(turn.point({0, 0, 1}), {0.5, 0, h}));
  CHECK(Affine::translating({-6, 4, 5}).point({1, 1, 1}) == Vec3{-5, 5, 6});
}

TEST_CASE("maps: right-handed rotations of 90° are exact") {
  CHECK(Affine::rotating({1, 0, 0}, 90).point({0, 1, 0}) == Vec3{0, 0, 1});
  CHECK(Affine::rotating({0, 1, 0}, 90).point({0, 0, 1}) == Vec3{1, 0, 0});
  CHECK(Affine::rotating({0, 0, 1}, 90).point({1, 0, 0}) == Vec3{0, 1, 0});
  CHECK(Affine::rotating_xyz({90, 0, 90}).point({0, 1, 0}) == Vec3{0, 0, 1}); // about x: z; about z: stays
}

TEST_CASE("maps: the inverse undoes the map, and a flattening one has none") {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Affine map{random.vector(-2, 2), random.vector(-2, 2), random.vector(-2, 2), random.vector(-9, 9)};
    const Vec3 p = random.vector(-1, 1);
    const auto back = inverse(map);
    REQUIRE(back);
    CHECK(near(back->point(map.point(p)), p, 1e-13 / std::min(1.0, std::abs(map.determinant()))));
  }
  CHECK_FALSE(inverse(Affine::scaling({1, 0, 1})));
  CHECK_FALSE(inverse(Affine{{1, 1, 0}, {2, 2, 0}, {0, 0, 1}, {}}));
}

TEST_CASE("maps: a row tells how far an image reaches along an axis") {
  const Affine map{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {}};
  CHECK(map.row(1) == Vec3{2, 5, 8});
}

TEST_CASE("maps: boxes are mapped to the smallest boxes, infinite sides stay infinite") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Box3 box =
      transform_box(Affine::translating({1, 0, 0}) * Affine::rotating({0, 0, 1}, 90), {{0, 0, 0}, {1, 2, 3}});
  CHECK(box == Box3{{-1, 0, 0}, {1, 1, 3}});
  const Box3 half = transform_box(Affine::scaling({2, -1, 1}), {{-infinity, 1, 0}, {3, infinity, 0}});
  CHECK(half == Box3{{-infinity, -infinity, 0}, {6, -1, 0}});
  CHECK(transform_box(Affine::scaling({2, 2, 2}), Box3{}).is_empty());
}
