#include "renderer/shapes/quad.hpp"
#include "renderer/shapes/triangle.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

namespace {

const TriangleGeometry right{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 3, 0}}};

/// A closed surface: an octahedron whose faces are split again and again, every corner put on a lumpy ball.
std::vector<TriangleGeometry> lumpy_ball(const Vec3& center, int splits) {
  std::vector<TriangleGeometry> faces;
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      for (const double z : {1.0, -1.0}) faces.push_back({{Vec3{x, 0, 0}, Vec3{0, y, 0}, Vec3{0, 0, z}}});
    }
  }
  for (int i = 0; i < splits; ++i) {
    std::vector<TriangleGeometry> finer;
    for (const auto& [p] : faces) {
      const Vec3 ab = (p[0] + p[1]) * 0.5, bc = (p[1] + p[2]) * 0.5, ca = (p[2] + p[0]) * 0.5;
      finer.push_back({{p[0], ab, ca}});
      finer.push_back({{ab, p[1], bc}});
      finer.push_back({{ca, bc, p[2]}});
      finer.push_back({{ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  for (auto& [p] : faces) {
    for (Vec3& corner : p) {
      const Vec3 n = normalize(corner);
      corner = center + n * (1 + 0.2 * std::sin(5 * n.x) * std::sin(7 * n.y + n.z));
    }
  }
  return faces;
}

bool is_hit(const std::vector<TriangleGeometry>& faces, const Ray& ray) {
  Hit hit;
  return std::any_of(faces.begin(), faces.end(), [&](const auto& face) { return intersect(face, ray, {}, hit); });
}

} // namespace

TEST_CASE("triangle: a ray meets it at its plane") {
  const Ray ray{{1, 1, 5}, {0, 0, -2}};
  CHECK(distances(right, ray) == std::vector<double>{2.5});
  CHECK(near(first_point(right, ray).position, {1, 1, 0}));
  CHECK(near(first_point(right, ray).normal, {0, 0, 1}));
  CHECK(near(distances(right, {{1, 1, -5}, {0, 0, 2}}), {2.5})); // from behind as well
  CHECK(near(distances(right, {{0, 0, 2}, {0.5, 0.25, -0.5}}), {4}));
  CHECK(distances(right, {{1, 1, 5}, {0, 0, 2}}).empty());
  CHECK(distances(right, {{3, 2, 5}, {0, 0, -2}}).empty());
  CHECK(distances(right, {{-0.1, 1, 5}, {0, 0, -2}}).empty());
  CHECK(distances(right, {{1, -0.1, 5}, {0, 0, -2}}).empty());
}

TEST_CASE("triangle: edges and corners belong to it") {
  CHECK(distances(right, {{2, 0, 5}, {0, 0, -1}}) == std::vector<double>{5});
  CHECK(distances(right, {{0, 2, 5}, {0, 0, -1}}) == std::vector<double>{5});
  CHECK(distances(right, {{2, 1.5, 5}, {0, 0, -1}}) == std::vector<double>{5});
  for (const Vec3& corner : right.points) CHECK(distances(right, {corner + Vec3{0, 0, 5}, {0, 0, -1}}).size() == 1);
  CHECK(distances(right, {{2, -0x1p-50, 5}, {0, 0, -1}}).empty());
}

TEST_CASE("triangle: seen edge-on it is not hit") {
  CHECK(distances(right, {{-1, 1, 0}, {1, 0, 0}}).empty());
  CHECK(distances(right, {{-1, -1, 0}, {1, 1, 0}}).empty());
}

TEST_CASE("triangle: almost edge-on the hit is still between its corners") {
  Random random(7);
  int count = 0;
  for (int i = 0; i < 20000; ++i) {
    const TriangleGeometry t{{random.vector(-1, 1), random.vector(-1, 1), random.vector(-1, 1)}};
    const Vec3 normal = normalize(cross(t.points[1] - t.points[0], t.points[2] - t.points[0]));
    const Vec3 inside = (t.points[0] + t.points[1] + t.points[2]) / 3;
    const Vec3 along = normalize(reject(random.direction(), normal));
    const Ray ray{inside - along * 10, along + normal * random.signed_magnitude(1e-20, 1e-12)};
    for (const double distance : distances(t, ray)) {
      CHECK(std::abs(distance - 10) < 4);
      ++count;
    }
  }
  CHECK(count > 2000);
}

TEST_CASE("triangle: the notes' plane through three points is 6x + 10y + 7z = 50") {
  const TriangleGeometry t{{Vec3{1, 3, 2}, Vec3{3, -1, 6}, Vec3{5, 2, 0}}};
  const Ray ray{{0, 0, 0}, {1, 0.5, 0.875}}; // 6 + 5 + 6.125 = 17.125
  CHECK(near(distances(t, ray), {50 / 17.125}, 4e-16));
  CHECK(near(first_point(t, ray).normal, Vec3{6, 10, 7} / std::sqrt(185.0)));
}

TEST_CASE("triangle: weights and interpolated normals") {
  CHECK(near(barycentric(right, {1, 1, 0}), {1 - 0.25 - 1.0 / 3, 0.25, 1.0 / 3}));
  CHECK(near(barycentric(right, {4, 0, 0}), {0, 1, 0}));
  const SmoothTriangleGeometry smooth{right, {Vec3{0, 0, 1}, Vec3{2, 0, 0}, Vec3{0, 0.5, 0}}};
  const Vec3 geometric{0, 0, -1};
  CHECK(near(interpolated_normal(smooth, {0, 3, 0}).value(geometric), {0, 1, 0}));
  CHECK(near(interpolated_normal(smooth, {2, 0, 0}).value(geometric), Vec3{1, 0, 1} / std::sqrt(2.0)));
  CHECK(near(interpolated_normal(smooth, {4.0 / 3, 1, 0}).value(geometric), Vec3{1, 1, 1} / std::sqrt(3.0)));
}

TEST_CASE("triangle: corner normals that cancel out leave the geometric one") {
  const SmoothTriangleGeometry smooth{right, {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}}};
  CHECK(interpolated_normal(smooth, {2, 0, 0}).value({0, 0, 1}) == Vec3{0, 0, 1});
}

TEST_CASE("triangle: far origins and a place far from the world's origin") {
  CHECK(near(distances(right, {{1, 1, 1e6}, {0, 0, -4}}), {2.5e5}));
  TriangleGeometry far = right;
  for (Vec3& p : far.points) p = p + Vec3{1e6, -1e6, 1e6};
  CHECK(distances(far, {{1e6 + 1, -1e6 + 1, 1e6 + 0.5}, {0, 0, -0.25}}) == std::vector<double>{2});
}

TEST_CASE("triangle: no ray slips through an edge or a corner that faces share") {
  for (const Vec3& center : {Vec3{0, 0, 0}, Vec3{1000, -2000, 500}}) {
    const auto faces = lumpy_ball(center, 3);
    Random random(11);
    for (int i = 0; i < 4000; ++i) {
      const auto& [p] = faces[random.bits() % faces.size()];
      const double share = i % 3 == 0 ? 0 : random.between(0, 1); // corners as well
      const Vec3 target = p[0] + (p[1] - p[0]) * share;
      const Vec3 inside = center + random.vector(-0.2, 0.2);
      if (!is_hit(faces, {inside, target - inside})) FAIL_CHECK("a ray leaks out at number " << i);
    }
  }
}

TEST_CASE("triangle: no ray slips between triangles and quads either") {
  // A strip: a quad, then two triangles, along an edge that lies oblique to all axes.
  const Vec3 a{0.1, 0.2, 0.3}, b{1.3, 1.1, 0.7}, out{0.3, -0.9, 0.4}, back{-0.2, 0.8, 0.35};
  scene::Quad raw;
  raw.points = std::vector<Vec3>{a, b, b + out, a + out};
  const QuadGeometry quad = geometry(raw);
  const TriangleGeometry one{{b, a, a + back}}, two{{b, a + back, b + back}};
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 origin = random.vector(-3, 3);
    // Seen from here the edge must not be a silhouette: both sides show the same face.
    if (dot(origin - a, cross(b - a, out)) * dot(origin - a, cross(back, b - a)) <= 0) continue;
    const Ray ray{origin, a + (b - a) * random.between(0.01, 0.99) - origin};
    Hit hit;
    if (!intersect(quad, ray, {}, hit) && !intersect(one, ray, {}, hit) && !intersect(two, ray, {}, hit))
      FAIL_CHECK("a ray slips through at number " << i);
  }
}
