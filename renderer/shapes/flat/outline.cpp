#include "renderer/shapes/flat/outline.hpp"

#include <fmt/format.h>

namespace rt {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double largest_coordinate(std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, max_component(abs(p)));
  return largest;
}

} // namespace

Vec3 newell_normal(std::span<const Vec3> points) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) sum += cross(points[i] - points[0], points[i + 1] - points[0]);
  return sum;
}

bool is_line(std::span<const Vec3> points) {
  const std::span<const Vec3> others = points.subspan(1);
  Vec3 far; // the point farthest from the first
  for (const Vec3& p : others) {
    const Vec3 step = p - points[0];
    if (dot(step, step) > dot(far, far)) far = step;
  }
  const double reach = length(far);
  const double tolerance = 4 * epsilon * (reach + largest_coordinate(points));
  for (const Vec3& p : others) {
    if (length(cross(p - points[0], far)) > tolerance * reach) return false;
  }
  return true;
}

double outline_extent(std::span<const Vec3> points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) low = min(low, p), high = max(high, p);
  return length(high - low);
}

Box3 outline_bounds(std::span<const Vec3> points, const Affine& map) {
  Box3 box;
  for (const Vec3& p : points) box.extend(map.point(p));
  return box;
}

} // namespace rt

namespace rt::scene {
namespace {

struct Point2 {
  double x = 0, y = 0;
};

/// Twice the signed area of the triangle abc. Exactly 0 if two of the points are equal.
double area(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether the open segments ab and cd cross; touching is not crossing.
bool cross_each_other(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return area(a, b, c) * area(a, b, d) < 0 && area(c, d, a) * area(c, d, b) < 0;
}

/// Along the axis closest to the normal, so that shapes keep as much of their area as possible.
std::vector<Point2> flattened(std::span<const Vec3> points, const Vec3& normal) {
  const Vec3 n = abs(normal);
  const std::size_t dropped = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
  const std::size_t u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  std::vector<Point2> flat;
  flat.reserve(points.size());
  for (const Vec3& p : points) flat.push_back({p[u], p[v]});
  return flat;
}

/// How many edges overlap at one x, on average.
double crowding(const std::vector<Point2>& p, double Point2::*x) {
  double low = p[0].*x, high = low, sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    low = std::min(low, p[i].*x), high = std::max(high, p[i].*x);
    sum += std::abs(p[(i + 1) % p.size()].*x - p[i].*x);
  }
  return sum / (high - low);
}

/// The first pair of edges found to cross, by the indices of their first points.
std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(std::vector<Point2> p) {
  const std::size_t n = p.size();
  if (crowding(p, &Point2::y) < crowding(p, &Point2::x)) {
    for (Point2& q : p) std::swap(q.x, q.y);
  }
  const auto left = [&](std::size_t i) { return std::min(p[i].x, p[(i + 1) % n].x); };
  const auto right = [&](std::size_t i) { return std::max(p[i].x, p[(i + 1) % n].x); };
  std::vector<std::size_t> order(n); // from left to right: only edges that overlap in x are compared
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return left(i) < left(j); });
  for (std::size_t a = 0; a < n; ++a) {
    const std::size_t i = order[a];
    for (std::size_t b = a + 1; b < n && left(order[b]) <= right(i); ++b) {
      const std::size_t j = order[b];
      if (cross_each_other(p[i], p[(i + 1) % n], p[j], p[(j + 1) % n])) return std::minmax(i, j);
    }
  }
  return std::nullopt;
}

Problem problem(std::string message) {
  return {"points", std::move(message)};
}

std::optional<Problem> check_steps(std::span<const Vec3> points) {
  const std::size_t n = points.size();
  if (points[0] == points[n - 1])
    return problem("the last point repeats the first: leave it out, the outline closes itself");
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (points[i] == points[i + 1]) return problem(fmt::format("points {} and {} are the same", i + 1, i + 2));
  }
  return std::nullopt;
}

std::optional<Problem> check_plane(std::span<const Vec3> points, const Vec3& unit_normal) {
  const double tolerance = 1e-9 * outline_extent(points) + 8 * epsilon * largest_coordinate(points);
  std::size_t worst = 0;
  double distance = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = std::abs(dot(points[i] - points[0], unit_normal));
    if (d > distance) distance = d, worst = i;
  }
  if (distance <= tolerance) return std::nullopt;
  return problem(fmt::format("the points are not coplanar: point {} of {} is {:.3g} away from the plane", worst + 1,
                             points.size(), distance));
}

std::optional<Problem> check_turns(const std::vector<Point2>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
    const double forward = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    if (area(a, b, c) == 0 && forward < 0)
      return problem(fmt::format("the outline turns back on itself at point {}", (i + 1) % n + 1));
  }
  return std::nullopt;
}

} // namespace

std::optional<Problem> check_outline(std::span<const Vec3> points) {
  if (points.size() < 3) return problem("at least three points are needed");
  if (auto found = check_steps(points)) return found;
  if (is_line(points)) return problem("all points are collinear: the shape has no area");
  const Vec3 normal = newell_normal(points);
  const double size = outline_extent(points);
  if (length(normal) <= 4 * epsilon * size * (size + largest_coordinate(points)))
    return problem("the outline crosses itself: write the points in order around it");
  if (auto found = check_plane(points, normalize(normal))) return found;
  const std::vector<Point2> flat = flattened(points, normal);
  if (const auto pair = crossing_edges(flat)) {
    const auto next = [&](std::size_t i) { return (i + 1) % points.size() + 1; };
    return problem(fmt::format("the outline crosses itself: the edge from point {} to {} meets the one from {} to {}",
                               pair->first + 1, next(pair->first), pair->second + 1, next(pair->second)));
  }
  return check_turns(flat);
}

} // namespace rt::scene
