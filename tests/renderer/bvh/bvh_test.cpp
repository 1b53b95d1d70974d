#include "renderer/bvh/bvh.hpp"
#include "tests/support/shapes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace rt;

namespace {

// Notes which boxes it is shown.
struct Watcher : bvh::Query {
  using Query::Query;
  std::vector<std::uint32_t> shown;
};

// Boxes that are hit where a ray enters them, or leaves if it starts inside.
struct Boxes {
  std::vector<Box3> boxes;

  std::uint32_t size() const { return static_cast<std::uint32_t>(boxes.size()); }
  Box3 bounds(std::uint32_t i) const { return boxes[i]; }
  void nearest(std::uint32_t i, Watcher& query) const {
    query.shown.push_back(i);
    const double t = hit(i, query.ray);
    if (query.interval.contains(t)) query.interval.upper = t;
  }
  bool blocks(std::uint32_t i, Watcher& query) const {
    query.shown.push_back(i);
    return false;
  }

  double hit(std::uint32_t i, const Ray& ray) const {
    double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double a = (boxes[i].lower[axis] - ray.origin[axis]) / ray.direction[axis];
      const double b = (boxes[i].upper[axis] - ray.origin[axis]) / ray.direction[axis];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    if (from > to || to <= 0) return -1;
    return from > 0 ? from : to;
  }
};

struct World {
  explicit World(Boxes b, bvh::Builder builder) : device(1, builder), boxes(std::move(b)) {
    Box3 all;
    for (const Box3& box : boxes.boxes) all.extend(box);
    tree = bvh::Tree(device, all);
    tree.add<Watcher, Watcher>(boxes);
    tree.build();
  }
  bvh::Device device;
  Boxes boxes;
  bvh::Tree tree;
};

} // namespace

TEST_CASE("tree: every box that a ray meets is shown, wherever the ray comes from") {
  const bvh::Builder builder = GENERATE(bvh::Builder::embree, bvh::Builder::portable);
  tests::Random random(7);
  for (const auto& [place, spread, size] : {std::tuple{0.0, 1.0, 1e-2},
                                            {0.0, 1.0, 0.0},
                                            {1e7, 1.0, 1e-3},
                                            {0.0, 1e5, 1.0},
                                            {0.0, 1e-20, 1e-22},
                                            {1e20, 1e19, 1e17}}) {
    Boxes boxes;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = Vec3{place, -place, 2 * place} + random.vector(-spread, spread),
                 half = abs(random.vector(-size, size));
      boxes.boxes.push_back({p - half, p + half});
    }
    const World world(boxes, builder);
    int hits = 0;
    for (int k = 0; k < 3000; ++k) {
      // At the middle of a box, and slightly off: from near, from far and from within.
      const auto target = static_cast<std::size_t>(random.between(0, 299.99));
      const Vec3 middle = boxes.boxes[target].center() + random.vector(-size * 0.3, size * 0.3);
      const double distance = spread * std::pow(10, random.between(-3, 3));
      const Vec3 origin = middle + random.vector(-distance, distance);
      const Ray ray{origin, (middle - origin) * std::pow(2, random.between(-20, 20))};
      Watcher line(ray, {}), near(ray, {});
      world.tree.blocks(line);
      world.tree.nearest(near);
      double best = std::numeric_limits<double>::max();
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const double t = boxes.hit(i, ray);
        if (t <= 0) continue;
        best = std::min(best, t);
        CHECK(std::find(line.shown.begin(), line.shown.end(), i) != line.shown.end());
        ++hits;
      }
      CHECK(near.interval.upper == best);
    }
    CHECK(hits > 1000);
  }
}

TEST_CASE("tree: what is beyond the interval is not looked for, what is at its end is") {
  const bvh::Builder builder = GENERATE(bvh::Builder::embree, bvh::Builder::portable);
  Boxes boxes;
  for (int i = 0; i < 20; ++i) boxes.boxes.push_back({{i * 10.0, -1, -1}, {i * 10.0 + 1, 1, 1}});
  const World world(boxes, builder);
  const Ray ray{{-5, 0, 0}, {1, 0, 0}};
  Watcher query(ray, {0, 25}); // as far as the third box's face
  world.tree.blocks(query);
  std::sort(query.shown.begin(), query.shown.end());
  CHECK(query.shown == std::vector<std::uint32_t>{0, 1, 2});
  Watcher none(ray, {0, 4.9});
  world.tree.blocks(none);
  CHECK(none.shown.empty());
  Watcher aside({{-5, 3, 0}, {1, 0, 0}}, {});
  world.tree.nearest(aside);
  CHECK(aside.shown.empty());
}

TEST_CASE("tree: boxes at the same place are all shown to one who looks for ties") {
  const bvh::Builder builder = GENERATE(bvh::Builder::embree, bvh::Builder::portable);
  Boxes boxes;
  for (int i = 0; i < 50; ++i) boxes.boxes.push_back({{-1, -1, 0}, {1, 1, 0}});
  const World world(boxes, builder);
  Watcher query({{0.1, 0.2, -3}, {0, 0, 1}}, {});
  world.tree.nearest(query);
  CHECK(query.interval.upper == 3);
  std::sort(query.shown.begin(), query.shown.end());
  query.shown.erase(std::unique(query.shown.begin(), query.shown.end()), query.shown.end());
  CHECK(query.shown.size() == 50);
}

TEST_CASE("tree: a single point is a tree as well") {
  const bvh::Builder builder = GENERATE(bvh::Builder::embree, bvh::Builder::portable);
  const World world(Boxes{{{{5, 5, 5}, {5, 5, 5}}}}, builder);
  Watcher query({{5, 5, 0}, {0, 0, 2}}, {});
  world.tree.nearest(query);
  CHECK(query.interval.upper == 2.5);
}
