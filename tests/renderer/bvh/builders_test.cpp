// Embree's tree and our own must give the same answers, to the last bit.

#include "renderer/bvh/bvh.hpp"
#include "tests/support/shapes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace rt;

namespace {

constexpr std::uint32_t none = 0xffffffff;

struct NearestBall : bvh::Query {
  using Query::Query;
  std::uint32_t id = none;
};

struct BlockingBalls : bvh::Query {
  BlockingBalls(const Ray& r, const Interval& i, bool first) : Query(r, i), ends_at_first(first) {}
  bool ends_at_first;
  std::set<std::uint32_t> met;
};

// Balls that are hit where a ray enters them; with equal t the one of the smallest id counts.
struct Balls {
  struct Ball {
    Vec3 center;
    double radius;
    std::uint32_t id;
  };
  std::vector<Ball> all;

  std::uint32_t size() const { return static_cast<std::uint32_t>(all.size()); }
  Box3 bounds(std::uint32_t i) const {
    const Vec3 r{all[i].radius, all[i].radius, all[i].radius};
    return {all[i].center - r, all[i].center + r};
  }
  bool meets(std::uint32_t i, const bvh::Query& query, double& t) const {
    const Vec3 to_center = all[i].center - query.ray.origin;
    const double middle = dot(to_center, query.ray.direction) * query.inverse_square;
    const Vec3 off = to_center - query.ray.direction * middle;
    const double half_squared = (all[i].radius * all[i].radius - dot(off, off)) * query.inverse_square;
    if (half_squared < 0) return false;
    t = middle - std::sqrt(half_squared);
    return query.interval.contains(t);
  }
  void nearest(std::uint32_t i, NearestBall& query) const {
    double t = 0;
    if (!meets(i, query, t) || (t == query.interval.upper && all[i].id > query.id)) return;
    query.interval.upper = t;
    query.id = all[i].id;
  }
  bool blocks(std::uint32_t i, BlockingBalls& query) const {
    double t = 0;
    if (!meets(i, query, t)) return false;
    query.met.insert(all[i].id);
    return query.ends_at_first;
  }
};

// The same balls in two sets, each ball in both of them or in one.
struct Forest {
  Balls first, second;
  bvh::Device device;
  bvh::Tree tree;

  Forest(Balls a, Balls b, bvh::Builder builder) : first(std::move(a)), second(std::move(b)), device(1, builder) {
    Box3 box;
    for (const Balls* set : {&first, &second})
      for (std::uint32_t i = 0; i < set->size(); ++i) box.extend(set->bounds(i));
    tree = bvh::Tree(device, box);
    tree.add<NearestBall, BlockingBalls>(first);
    tree.add<NearestBall, BlockingBalls>(second);
    tree.build();
  }
};

} // namespace

TEST_CASE("bvh: both builders find the same leaves, ties and packets included") {
  tests::Random random(11);
  for (const std::uint32_t count : {1u, 2u, 3u, 40u, 3000u}) {
    for (const double distance : {2.0, 1e4}) {
      const double radius = 0.5 / std::cbrt(count);
      Balls first, second;
      for (std::uint32_t id = 0; id < count; ++id) {
        const Balls::Ball ball{random.vector(-1, 1), radius * random.between(0.2, 2), id};
        first.all.push_back(ball);
        if (id % 3 == 0) second.all.push_back({ball.center, ball.radius, count + id}); // meets every ray at the same t
        if (id % 7 == 0) second.all.push_back({random.vector(-1, 1), 0, count + id});
      }
      const Forest embree(first, second, bvh::Builder::embree), portable(first, second, bvh::Builder::portable);
      std::size_t hits = 0, blocked = 0;
      for (int round = 0; round < 100; ++round) {
        const Vec3 eye = round % 2 == 0 ? random.vector(-1, 1) : normalize(random.vector(-1, 1)) * distance;
        const double length = std::pow(10, random.between(-3, 3));
        std::vector<NearestBall> ours, theirs;
        std::vector<BlockingBalls> blocking;
        for (std::size_t i = 0; i < bvh::packet_size; ++i) {
          const Vec3 target = first.all[static_cast<std::size_t>(random.between(0, count - 0.01))].center;
          Vec3 direction = (target + random.vector(-radius, radius) - eye) * length;
          if (round % 5 == 0) direction = {0, 0, direction.z}; // along an axis
          const Ray ray{eye, direction};
          const Interval range{0, round % 4 == 0 ? 1 / length : std::numeric_limits<double>::max()};
          ours.emplace_back(ray, range), theirs.emplace_back(ray, range);
          blocking.emplace_back(ray, range, round % 3 == 0);
        }
        std::vector<bvh::Query*> packet, blocking_packet;
        for (NearestBall& query : ours) packet.push_back(&query);
        portable.tree.nearest(packet);
        for (BlockingBalls& query : blocking) blocking_packet.push_back(&query);
        const auto answers = portable.tree.blocks(blocking_packet);
        for (std::size_t i = 0; i < bvh::packet_size; ++i) {
          embree.tree.nearest(theirs[i]);
          REQUIRE(ours[i].id == theirs[i].id);
          REQUIRE(ours[i].interval.upper == theirs[i].interval.upper);
          BlockingBalls alone(blocking[i].ray, blocking[i].interval, blocking[i].ends_at_first);
          REQUIRE(answers[i] == embree.tree.blocks(alone));
          if (!alone.ends_at_first) REQUIRE(blocking[i].met == alone.met);
          hits += ours[i].id != none;
          blocked += answers[i];
        }
      }
      CHECK(hits > 300);
      CHECK(blocked > 100);
    }
  }
}

TEST_CASE("bvh: both builders find all that a whole line passes, before its origin too") {
  tests::Random random(11);
  Balls balls;
  for (std::uint32_t id = 0; id < 500; ++id) balls.all.push_back({random.vector(-1, 1), 0.05, id});
  const Forest embree(balls, {}, bvh::Builder::embree), portable(balls, {}, bvh::Builder::portable);
  constexpr double most = std::numeric_limits<double>::max();
  std::size_t behind = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{random.vector(-2, 2), random.vector(-1, 1)};
    BlockingBalls ours(ray, {-most, most}, false), theirs(ray, {-most, most}, false);
    portable.tree.blocks(ours);
    embree.tree.blocks(theirs);
    REQUIRE(ours.met == theirs.met);
    for (const std::uint32_t id : ours.met) behind += dot(balls.all[id].center - ray.origin, ray.direction) < 0;
  }
  CHECK(behind > 100);
}
