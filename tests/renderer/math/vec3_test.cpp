#include "renderer/math/vec3.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using rt::tests::near;

// The examples of the source notes.
TEST_CASE("vectors: dot and cross products, unit vector and angle") {
  CHECK(cross({1, 3, 4}, {2, 7, -5}) == Vec3{-43, 13, 1});
  CHECK(near(normalize(Vec3{2, -1, -2}), Vec3{2, -1, -2} / 3));
  // The angle between (2, 2, −1) and (5, −3, 2): cos θ = 2 / (3 √38).
  CHECK(dot(normalize(Vec3{2, 2, -1}), normalize(Vec3{5, -3, 2})) == Approx(2 / (3 * std::sqrt(38.0))).epsilon(1e-15));
}

TEST_CASE("vectors: the part perpendicular to an axis") {
  CHECK(near(reject({3, 4, 5}, {0, 1, 0}), {3, 0, 5}));
  CHECK(near(reject({1, 1, 0}, Vec3{3, 4, 0} / 5), {4.0 / 25, -3.0 / 25, 0}));
}
