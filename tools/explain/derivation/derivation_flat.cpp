// Planes, and the faces that are cut out of them; boxes, which are bounded by six.

#include "tools/explain/derivation/derivation_steps.hpp"
#include "tools/explain/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt::tools::explain {
namespace {

// Where the ray hits the plane n·p = k: the t, and the point there.
struct OnPlane {
  double t;
  Vec3 point;
};

OnPlane meet_plane(Steps& steps, const Vec3& normal, double numerator, std::string_view formula) {
  const double denominator = dot(normal, steps.ray().direction);
  steps.put("numerator", fmt::format("numerator {}", formula), numerator)
      .put("denominator", "denominator N·d", denominator)
      .so(denominator < 0 ? "< 0: against the normal" : "> 0: from behind, along the normal");
  const double t = numerator / denominator;
  steps.put("t_plane", "t = numerator / denominator", t);
  return {t, steps.ray().at(t)};
}

OnPlane meet_plane_of(Steps& steps, const Vec3& normal, const Vec3& corner) {
  return meet_plane(steps, normal, dot(normal, corner - steps.ray().origin), "N·(P₁ − o)");
}

std::string label_of(std::size_t i) {
  static constexpr std::string_view small[] = {"₁", "₂", "₃", "₄"};
  return i < 4 ? std::string(small[i]) : fmt::format("{}", i + 1);
}

// How far the point is on the inner side of each edge, times the edge's length.
std::vector<double> sides_of(std::span<const Vec3> corners, const Vec3& normal, const Vec3& p) {
  std::vector<double> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3& from = corners[i];
    sides.push_back(dot(normal, cross(corners[(i + 1) % corners.size()] - from, p - from)));
  }
  return sides;
}

bool is_convex(std::span<const Vec3> corners, const Vec3& normal) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()], &c = corners[(i + 2) % corners.size()];
    if (dot(normal, cross(b - a, c - b)) < 0) return false;
  }
  return true;
}

void put_sides(Steps& steps, std::span<const double> sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::string from = label_of(i), to = label_of((i + 1) % sides.size());
    steps.put(fmt::format("side{}", i + 1),
              fmt::format("s{} = {}", from, i == 0 ? fmt::format("N·((P{} − P{}) × (P − P{}))", to, from, from) : "…"),
              sides[i]);
  }
}

// Whether a point of the plane is on the outline, up to rounding.
bool is_on_edge(std::span<const Vec3> corners, const Vec3& p, double extent) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &a = corners[i], edge = corners[(i + 1) % corners.size()] - a;
    const double s = std::clamp(dot(p - a, edge) / dot(edge, edge), 0.0, 1.0);
    if (length(p - (a + edge * s)) <= 1e-9 * extent) return true;
  }
  return false;
}

// How often a line outwards from the point crosses the outline, in the plane of the two coordinates that remain when
// the normal's largest one is dropped.
int count_crossings(std::span<const Vec3> corners, const Vec3& normal, const Vec3& p) {
  const Vec3 size = abs(normal);
  const std::size_t drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t u = (drop + 1) % 3, v = (drop + 2) % 3;
  int count = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((a[v] > p[v]) == (b[v] > p[v])) continue;
    count += p[u] < a[u] + (b[u] - a[u]) * (p[v] - a[v]) / (b[v] - a[v]);
  }
  return count;
}

void derive_outline(Steps& steps, std::span<const Vec3> corners, const Vec3& normal, double extent) {
  steps.equation("N·(p − P₁) = 0, inside of the outline");
  steps.put("normal", "N", normal);
  for (std::size_t i = 0; i < std::min<std::size_t>(corners.size(), 4); ++i)
    steps.put(fmt::format("p{}", i + 1), fmt::format("P{}", label_of(i)), corners[i]);
  steps.so(corners.size() > 4 ? fmt::format("and {} more corners", corners.size() - 4) : "");
  const OnPlane on = meet_plane_of(steps, normal, corners.front());
  steps.put("point", "P = o + t·d", on.point).so();
  const bool is_edge = is_on_edge(corners, on.point, extent);
  if (corners.size() == 4 && is_convex(corners, normal)) {
    put_sides(steps, sides_of(corners, normal, on.point));
    steps.so(is_edge ? "inside test: P is on the outline, which counts as inside"
                     : "inside test: none is negative, so P is inside of all four edges");
  } else {
    const int crossings = count_crossings(corners, normal, on.point);
    steps.put("crossings", "inside test: a line from P outwards crosses the outline this often",
              static_cast<double>(crossings));
    steps.so(is_edge ? "P is on the outline, which belongs to the face"
                     : fmt::format("{}: P is {}", crossings % 2 == 1 ? "odd" : "even",
                                   crossings % 2 == 1 ? "inside" : "outside"));
  }
  steps.choose({{on.t, "t", true}});
}

} // namespace

void derive_shape(Steps& steps, const PlaneGeometry& plane) {
  steps.equation("N·p = k");
  steps.put("normal", "N", plane.normal).put("offset", "k", plane.offset).so();
  const OnPlane on = meet_plane(steps, plane.normal, plane.offset - dot(plane.normal, steps.ray().origin), "k − N·o");
  steps.so();
  steps.choose({{on.t, "t", true}});
}

void derive_shape(Steps& steps, const DiscGeometry& disc) {
  steps.equation(disc.hole > 0 ? "N·(p − C) = 0 and hole ≤ |p − C| ≤ r" : "N·(p − C) = 0 and |p − C| ≤ r");
  steps.put("center", "C", disc.center).put("normal", "N", disc.normal).put("radius", "r", disc.radius);
  if (disc.hole > 0) steps.put("hole", "hole", disc.hole);
  steps.so();
  const OnPlane on = meet_plane(steps, disc.normal, dot(disc.normal, disc.center - steps.ray().origin), "N·(C − o)");
  steps.put("point", "P = o + t·d", on.point).so();
  steps.put("distance", "distance from the middle |P − C|", length(on.point - disc.center));
  steps.so(disc.hole > 0
               ? fmt::format("between {} and {}: on the disc", number_text(disc.hole), number_text(disc.radius))
               : fmt::format("≤ {}: on the disc", number_text(disc.radius)));
  steps.choose({{on.t, "t", true}});
}

void derive_shape(Steps& steps, const TriangleGeometry& triangle) {
  const auto& corners = triangle.points;
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  steps.equation("N·(p − P₁) = 0 with N = (P₂ − P₁) × (P₃ − P₁), inside of all three edges");
  for (std::size_t i = 0; i < 3; ++i) steps.put(fmt::format("p{}", i + 1), fmt::format("P{}", label_of(i)), corners[i]);
  steps.put("normal", "N", normal).so();
  const OnPlane on = meet_plane_of(steps, normal, corners.front());
  steps.put("point", "P = o + t·d", on.point).so();
  const std::vector<double> sides = sides_of(corners, normal, on.point);
  put_sides(steps, sides);
  const bool is_edge = is_on_edge(corners, on.point, length(corners[1] - corners[0]) + length(corners[2] - corners[0]));
  steps.so(is_edge ? "inside test: P is on an edge, which belongs to the face"
                   : "inside test: none is negative, so P is on the inner side of all three edges");
  const double whole = dot(normal, normal);
  steps.put("weights", "the corners' weights s/|N|²", Vec3{sides[1] / whole, sides[2] / whole, sides[0] / whole}).so();
  steps.choose({{on.t, "t", true}});
}

void derive_shape(Steps& steps, const QuadGeometry& quad) {
  derive_outline(steps, quad.points, quad.normal, quad.extent);
}

void derive_shape(Steps& steps, const PolygonGeometry& polygon) {
  derive_outline(steps, polygon.points, polygon.normal, polygon.extent);
}

void derive_shape(Steps& steps, const BoxGeometry& box) {
  static constexpr std::string_view axes[] = {"x", "y", "z"};
  const Vec3 &o = steps.ray().origin, &d = steps.ray().direction;
  steps.equation("between two planes on each axis (slabs)");
  steps.put("lower", "from", box.lower).put("upper", "to", box.upper).so();
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  std::string enter_face, leave_face;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view axis = axes[i];
    if (d[i] == 0) {
      steps.put(fmt::format("o_{}", axis), fmt::format("{}: the ray keeps its {}", axis, axis), o[i])
          .so("between the faces");
      continue;
    }
    const bool falls = d[i] < 0;
    const double near = ((falls ? box.upper : box.lower)[i] - o[i]) / d[i];
    const double far = ((falls ? box.lower : box.upper)[i] - o[i]) / d[i];
    steps.put(fmt::format("near_{}", axis), fmt::format("{}: from t = ({} − o) / d", axis, falls ? "to" : "from"), near)
        .put(fmt::format("far_{}", axis), fmt::format("to t = ({} − o) / d", falls ? "from" : "to"), far)
        .so();
    if (near > enter) enter = near, enter_face = fmt::format("the face of {} {}", falls ? "greatest" : "least", axis);
    if (far < leave) leave = far, leave_face = fmt::format("the face of {} {}", falls ? "least" : "greatest", axis);
  }
  steps.put("enter", "within all from the greatest of the first, t", enter)
      .put("leave", "to the least of the second, t", leave)
      .so(fmt::format("in by {}, out by {}", enter_face, leave_face));
  steps.choose({{enter, "the way in", true}, {leave, "the way out", true}});
}

} // namespace rt::tools::explain
