#include "renderer/bvh/bvh.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

namespace {

using namespace rt;

struct NearestLeaf : bvh::Query {
  using Query::Query;
  std::uint32_t leaf = 0xffffffff;
};

struct AnyLeaf : bvh::Query {
  using Query::Query;
  bool ends_it = true;
  std::vector<std::uint32_t> met;
};

// Small horizontal squares: a ray meets one where it crosses its height.
struct Squares {
  struct Square {
    Vec3 center;
    double half;
  };
  std::vector<Square> all;

  std::uint32_t size() const { return static_cast<std::uint32_t>(all.size()); }
  Box3 bounds(std::uint32_t i) const {
    const Vec3 reach{all[i].half, 0, all[i].half};
    return {all[i].center - reach, all[i].center + reach};
  }
  bool meets(std::uint32_t i, const bvh::Query& query, double& t) const {
    const Square& s = all[i];
    t = (s.center.y - query.ray.origin.y) / query.ray.direction.y;
    const Vec3 off = abs(query.ray.at(t) - s.center);
    return t >= query.interval.lower && t <= query.interval.upper && off.x <= s.half && off.z <= s.half;
  }
  void nearest(std::uint32_t i, NearestLeaf& query) const {
    double t = 0;
    if (!meets(i, query, t) || (t == query.interval.upper && i > query.leaf)) return;
    query.interval.upper = t;
    query.leaf = i;
  }
  bool blocks(std::uint32_t i, AnyLeaf& query) const {
    double t = 0;
    if (!meets(i, query, t)) return false;
    query.met.push_back(i);
    return query.ends_it;
  }
};

} // namespace

TEST_CASE("tree: queries in a packet find what each finds alone") {
  const bvh::Builder builder = GENERATE(bvh::Builder::embree, bvh::Builder::portable);
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] {
    const double x = place(engine), y = place(engine), z = place(engine);
    return Vec3{x, y, z};
  };
  Squares squares;
  Box3 box;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    squares.all.push_back({point(), 0.06});
    box.extend(squares.bounds(i));
  }
  const bvh::Device device(1, builder);
  bvh::Tree tree(device, box);
  tree.add<NearestLeaf, AnyLeaf>(squares);
  tree.build();

  int hits = 0, blocked = 0;
  for (std::size_t round = 0; round < 400; ++round) {
    const std::size_t count = 1 + round % bvh::packet_size; // packets of every size
    // From outside, some of them passing by, and from inside.
    const Vec3 eye = round % 3 == 0 ? point() : Vec3{0, 4, 1};
    std::vector<NearestLeaf> nearest;
    std::vector<AnyLeaf> any;
    for (std::size_t i = 0; i < count; ++i) {
      const Ray ray{eye, normalize(point() * 1.5 - eye)};
      nearest.push_back({ray, {}});
      any.emplace_back(ray, Interval{0, 4});
      any.back().ends_it = round % 2 == 0;
    }
    std::vector<bvh::Query*> nearest_packet, any_packet;
    for (std::size_t i = 0; i < count; ++i) {
      nearest_packet.push_back(&nearest[i]);
      any_packet.push_back(&any[i]);
    }
    tree.nearest(nearest_packet);
    const auto answers = tree.blocks(any_packet);
    for (std::size_t i = 0; i < count; ++i) {
      NearestLeaf alone(nearest[i].ray, {});
      tree.nearest(alone);
      REQUIRE(nearest[i].leaf == alone.leaf);
      REQUIRE(nearest[i].interval.upper == alone.interval.upper);
      AnyLeaf alone_any(any[i].ray, {0, 4});
      alone_any.ends_it = any[i].ends_it;
      REQUIRE(answers[i] == tree.blocks(alone_any));
      if (!any[i].ends_it) {
        // Every leaf is shown once.
        std::sort(any[i].met.begin(), any[i].met.end());
        std::sort(alone_any.met.begin(), alone_any.met.end());
        REQUIRE(any[i].met == alone_any.met);
      }
      hits += alone.leaf != 0xffffffff;
      blocked += answers[i];
    }
  }
  CHECK(hits > 1000);
  CHECK(blocked > 250);
}
