// What is no shape, and how that is said.

#include "renderer/math/degrees.hpp"
#include "renderer/shapes/flat/outline.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::scene;

namespace {

/// The field that is blamed and the message, "field: message", or nothing.
template <class S>
std::string problem(const S& shape) {
  const auto found = check(shape);
  return found ? std::string(found->field) + ": " + found->message : "";
}

std::string problem(std::vector<Vec3> points) {
  Polygon polygon;
  polygon.points = std::move(points);
  return problem(polygon);
}

} // namespace

TEST_CASE("check: what every shape is without a word is a shape") {
  ShapeKinds::for_each([]<class S>() {
    if constexpr (!std::is_same_v<S, Combination>) CHECK(problem(S{}) == "");
  });
}

TEST_CASE("check: a cylinder needs both ends, and apart") {
  Cylinder c;
  c.from = Vec3{1, 2, 3};
  CHECK(problem(c) == "from: a cylinder with `from` needs `to`, the centre of its other end");
  c.to = c.from;
  CHECK(problem(c) == "to: `from` and `to` are the same point: the cylinder has no length");
  c.from.reset();
  CHECK(problem(c) == "to: a cylinder with `to` needs `from`, the centre of its other end");
}

TEST_CASE("check: a cone needs a length and a radius") {
  CHECK(problem(Cone{{1, 1, 1}, {1, 1, 1}, 1, 0, false}) ==
        "to: `from` and `to` are the same point: the cone has no length");
  CHECK(problem(Cone{{}, {0, 1, 0}, 0, 0, false}) ==
        "radius: `radius` and `top_radius` are both 0: the cone has no surface");
  CHECK(problem(Cone{{}, {0, 1, 0}, 0, 2, false}) == "");
  CHECK(problem(Cone{{}, {0, 1, 0}, 2, 2, false}) == "");
}

TEST_CASE("check: a box needs both corners, and a size along each axis") {
  Box b;
  b.from = Vec3{1, 2, 3};
  CHECK(problem(b) == "from: a box with `from` needs `to`, the opposite corner");
  b.to = Vec3{2, 2, 4};
  CHECK(problem(b) == "to: `from` and `to` have the same y: the box has no size along y");
  b.to = Vec3{0, 0, 0};
  CHECK(problem(b) == "");
}

TEST_CASE("check: a disc's hole is no larger than the disc") {
  CHECK(problem(Disc{{0, 1, 0}, 1, 1}) == "");
  CHECK(problem(Disc{{0, 1, 0}, 1, 1.5}) == "hole: `hole` is larger than `radius`: the disc is empty");
}

TEST_CASE("check: a triangle has an area, and no normals or three") {
  Triangle t;
  t.points = {Vec3{0, 0, 0}, Vec3{1, 2, 3}, Vec3{2, 4, 6}};
  CHECK(problem(t) == "points: the three points lie on one line: there is no area between them");
  t.points = {Vec3{0.1, 0.1, 0.1}, Vec3{0.3, 0.3, 0.3}, Vec3{0.7, 0.7, 0.7}}; // up to rounding
  CHECK(problem(t) != "");
  t.points = {Vec3{1, 1, 1}, Vec3{1, 1, 1}, Vec3{2, 4, 6}};
  CHECK(problem(t) != "");
  t.points = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0.5, 1e-12, 0}}; // a sliver is a triangle
  CHECK(problem(t) == "");
  t.normals = {{0, 1, 0}, {0, 1, 0}};
  CHECK(problem(t) == "normals: a triangle has three normals, one for each corner, or none; here are 2");
  t.normals = {{0, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  CHECK(problem(t) == "normals: a normal must have a direction: it cannot be [0, 0, 0]");
}

TEST_CASE("check: a tiny triangle far away is one still") {
  Triangle t;
  t.points = {Vec3{1e6, 1e6, 1e6}, Vec3{1e6 + 1e-6, 1e6, 1e6}, Vec3{1e6, 1e6 + 1e-6, 1e6}};
  CHECK(problem(t) == "");
}

TEST_CASE("check: a quad's forms are whole") {
  Quad q;
  q.edge_u = Vec3{1, 0, 0};
  CHECK(problem(q) == "edge_u: a quad with edges needs `corner`, where they start");
  q.corner = Vec3{0, 0, 0};
  CHECK(problem(q) == "corner: a quad with `corner` needs `edge_u` and `edge_v`: `edge_v` is missing");
  q.edge_v = Vec3{-3, 0, 0};
  CHECK(problem(q) == "edge_v: `edge_u` and `edge_v` are parallel: there is no area between them");
  q.edge_v = Vec3{-3, 0, 1e-6};
  CHECK(problem(q) == "");
  Quad points;
  points.points = std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.25}};
  CHECK(problem(points).starts_with("points: the points are not coplanar: point "));
}

TEST_CASE("check: an outline closes itself") {
  CHECK(problem({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}) ==
        "points: the last point repeats the first: leave it out, the outline closes itself");
  CHECK(problem({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == "points: points 2 and 3 are the same");
  CHECK(problem({{0, 0, 0}, {1, 0, 0}}) == "points: at least three points are needed");
}

TEST_CASE("check: an outline is flat and has an area") {
  CHECK(problem({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}) ==
        "points: all points are collinear: the shape has no area");
  CHECK(problem({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 3, 0.5}, {0, 2, 0}}).ends_with("away from the plane"));
  // A hexagon that was turned: flat up to rounding.
  const Affine turn = Affine::translating({100, -300, 7}) * Affine::rotating({1, 2, 3}, 71);
  std::vector<Vec3> hexagon;
  for (int i = 0; i < 6; ++i) hexagon.push_back(turn.point({cos_degrees(60.0 * i), sin_degrees(60.0 * i), 0}));
  CHECK(problem(hexagon) == "");
  hexagon[2] = hexagon[2] + turn.vector({0, 0, 1e-8});
  CHECK(problem(hexagon) != "");
}

TEST_CASE("check: an outline does not cross itself") {
  CHECK(problem({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}) ==
        "points: the outline crosses itself: write the points in order around it");
  CHECK(problem({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 2, 0}}) ==
        "points: the outline crosses itself: the edge from point 1 to 2 meets the one from 3 to 4");
  CHECK(problem({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, -1, 0}, {0, 4, 0}}) != "");
  CHECK(problem({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}) == "");
  // Backwards as well, and in another plane.
  CHECK(problem({{0, 0, 2}, {0, 2, 0}, {0, 2, 2}, {0, 0, 0}, {0, -1, 3}}) != "");
}

TEST_CASE("check: an outline may touch itself, so that a seam leads to a hole, but not turn back") {
  CHECK(problem({{0, 0, 0},
                 {4, 0, 0},
                 {4, 4, 0},
                 {0, 4, 0},
                 {0, 0, 0},
                 {1, 1, 0},
                 {1, 3, 0},
                 {3, 3, 0},
                 {3, 1, 0},
                 {1, 1, 0}}) == "");
  CHECK(problem({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 6, 0}, {4, 4, 0}, {0, 4, 0}}) ==
        "points: the outline turns back on itself at point 4");
  CHECK(problem({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}}) == ""); // a straight corner is one
}

TEST_CASE("check: a long outline is checked in good time") {
  std::vector<Vec3> points;
  for (int i = 0; i < 50000; ++i) points.push_back({cos_degrees(i * 360.0 / 50000), sin_degrees(i * 360.0 / 50000), 0});
  CHECK(problem(points) == "");
  // A zigzag, whose edges all overlap along one axis, in either direction.
  for (const bool is_upright : {false, true}) {
    points.clear();
    for (int i = 0; i < 50000; ++i) points.push_back({i % 2 == 0 ? 0.0 : 100.0, i * 0.01, 0});
    points.push_back({-1, 501, 0});
    points.push_back({-1, 0, 0});
    if (is_upright) {
      for (Vec3& p : points) std::swap(p.x, p.y);
    }
    CHECK(problem(points) == "");
  }
}

TEST_CASE("check: a combination of nothing is nothing, but not every one") {
  using Operation = Combination::Operation;
  CHECK(problem(Combination{Operation::unite, {}}) == "");
  CHECK(problem(Combination{Operation::intersect, {}}) == ": an intersection needs at least one solid");
  CHECK(problem(Combination{Operation::subtract, {}}) == ": a difference needs a solid to subtract from");
  CHECK(problem(Combination{Operation::subtract, {Object{}}}) == "");
}
