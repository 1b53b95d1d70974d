// Objects of many leaves: a cube of twelve triangles, between two spheres.

#include "renderer/compile/aggregate.hpp"

#include <catch2/catch.hpp>

using namespace rt;

namespace {

constexpr BindingId any_binding{0};

// The face whose normal points along an axis, or against it, as two triangles that share the diagonal from its lowest
// corner to its highest.
void add_face(AggregateBuilder& builder, std::size_t axis, double side, LeafTag tag) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto corner = [&](double a, double b) {
    Vec3 p;
    p[axis] = side, p[u] = a, p[v] = b;
    return p;
  };
  const Vec3 lowest = corner(-1, -1), highest = corner(1, 1);
  builder.add_shape(TriangleGeometry{{lowest, corner(1, -1), highest}}, {}, tag);
  builder.add_shape(TriangleGeometry{{lowest, highest, corner(-1, 1)}}, {}, tag);
}

struct CubeBetweenSpheres {
  bvh::Device device;
  Aggregate aggregate;

  explicit CubeBetweenSpheres(bvh::Builder kind) : device(1, kind) {
    AggregateBuilder builder(aggregate);
    builder.add_shape(SphereGeometry{{0, 0, -4}, 1}, {}, LeafTag(builder.add_object(0, 0), any_binding, true));
    const LeafTag cube(builder.add_object(0, 1), any_binding, true);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0}) add_face(builder, axis, side, cube);
    builder.add_shape(SphereGeometry{{0, 0, 4}, 1}, {}, LeafTag(builder.add_object(0, 2), any_binding, true));
    builder.build(device);
  }

  RayHit nearest(const Ray& ray, const Interval& range = {}) const {
    RayHit hit;
    TraceScratch scratch;
    NearestQuery query(ray, range, {}, aggregate, 0, hit, scratch);
    aggregate.nearest(query);
    return hit;
  }
};

std::uint32_t slot(const RayHit& hit) {
  REQUIRE(hit);
  return hit.kind->tag(hit.leaves, hit.index).slot;
}

// A solid whose line may cross six surfaces, and one that has no such limit.
struct ThreeSlabs {};
CrossingList<6> crossings(const ThreeSlabs&, const Ray& ray) {
  CrossingList<6> found;
  for (int slab = 0; slab < 3; ++slab)
    found.add({(2 * slab - ray.origin.x) / ray.direction.x, 0}, {(2 * slab + 1 - ray.origin.x) / ray.direction.x, 1});
  return found;
}
[[maybe_unused]] bool contains(const ThreeSlabs&, const Vec3&) {
  return false;
}
struct AnyMesh {};
[[maybe_unused]] std::vector<Hit> crossings(const AnyMesh&, const Ray&) {
  return {};
}
[[maybe_unused]] bool contains(const AnyMesh&, const Vec3&) {
  return false;
}
static_assert(Solidlike<ThreeSlabs> && Solidlike<AnyMesh> && Solidlike<SphereGeometry> && !Solidlike<TriangleGeometry>);

} // namespace

TEST_CASE("aggregate: an object of many leaves is one object") {
  const CubeBetweenSpheres scene(GENERATE(bvh::Builder::embree, bvh::Builder::portable));
  const Aggregate& aggregate = scene.aggregate;
  CHECK(aggregate.object_count() == 3);
  CHECK(aggregate.box() == Box3{{-1, -1, -5}, {1, 1, 5}});

  const RayHit top = scene.nearest({{0.5, -0.25, 10}, {0, 0, -1}});
  CHECK(top.t == 10 - 4 - std::sqrt(1 - 0.3125));
  CHECK(aggregate.order(slot(top)) == 2);
  CHECK(aggregate.path(slot(top)) == std::vector<std::uint32_t>{2});
  const RayHit below = scene.nearest({{0.5, -0.25, 10}, {0, 0, -1}}, {10, 20});
  CHECK(below.t == 11); // the cube's lower face
  CHECK(aggregate.order(slot(below)) == 1);
  const RayHit side = scene.nearest({{3, 0.5, 0.25}, {-1, 0, 0}});
  CHECK(side.t == 2);
  CHECK(aggregate.order(slot(side)) == 1);
  CHECK(aggregate.path(slot(side)) == std::vector<std::uint32_t>{1});
  const RayHit bottom = scene.nearest({{0, 0, -10}, {0, 0, 1}});
  CHECK(bottom.t == 5);
  CHECK(aggregate.order(slot(bottom)) == 0);
  CHECK_FALSE(scene.nearest({{3, 3, -10}, {0, 0, 1}}));
}

TEST_CASE("aggregate: of one object's leaves that are hit at the same place the first one counts") {
  const CubeBetweenSpheres embree(bvh::Builder::embree), portable(bvh::Builder::portable);
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const std::uint32_t first = 4 * axis + (side < 0 ? 0 : 2); // of the face's two, in the order they were added
      for (const double across : {-0.5, 0.0, 0.25, 0.75}) {
        Vec3 origin{across, across, across}, direction;
        origin[axis] = 2.5 * side, direction[axis] = -side; // between the cube and the spheres, at the face's diagonal
        for (const CubeBetweenSpheres* scene : {&embree, &portable}) {
          const RayHit hit = scene->nearest({origin, direction});
          CHECK(slot(hit) == 1);
          CHECK(hit.t == 1.5);
          CHECK(hit.index == first);
        }
      }
    }
  }
}

TEST_CASE("crossings: as many as a solid declares") {
  const auto found = crossings(ThreeSlabs{}, Ray{{-1, 0, 0}, {0.5, 0, 0}});
  std::vector<double> ts;
  for (const Hit& hit : found) ts.push_back(hit.t);
  CHECK(ts == std::vector<double>{2, 4, 6, 8, 10, 12});
}
