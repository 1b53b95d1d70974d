#include "renderer/scene/builder.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::scene;
using rt::tests::near;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Object at(ShapeRef shape, const Vec3& where) {
  Object object;
  object.shape = shape, object.at = where;
  return object;
}

Object turned(Builder& build, ShapeRef shape, const Placement& placement) {
  Object object = at(shape, placement.at);
  object.transform = build.transform(placement).value();
  return object;
}

} // namespace

TEST_CASE("placement: scale, then rotate, then at, then the chain from left to right") {
  Builder build;
  const Scene& scene = build.scene;
  const ShapeRef sphere = build.shape(Sphere{});
  Placement p;
  p.scale = {2, 1, 1}, p.rotate = {0, 0, 90}, p.at = {10, 0, 0};
  p.chain = {MoveStep{{0, 1, 0}}, ScaleStep{{1, 2, 1}, {}}};
  const Object object = turned(build, sphere, p);
  // (1, 0, 0) → (2, 0, 0) → (0, 2, 0) → (10, 2, 0) → (10, 3, 0) → (10, 6, 0)
  CHECK(to_parent(scene, object).point({1, 0, 0}) == Vec3{10, 6, 0});
  CHECK(placement(scene, object).chain.size() == 2);
  CHECK(placement(scene, at(sphere, {1, 2, 3})).at == Vec3{1, 2, 3});
  CHECK(to_parent(scene, at(sphere, {1, 2, 3})) == Affine::translating({1, 2, 3}));
}

TEST_CASE("placement: a light goes through its own chain, then its composites', from the inside out") {
  Light light;
  light.chain = {MoveStep{{1, 0, 0}}};
  Placement inner, outer;
  inner.rotate = {0, 0, 90};
  outer.at = {0, 0, 5}, outer.scale = {3, 3, 3};
  light.enclosing = {inner, outer};
  // (1, 0, 0) → (2, 0, 0) → (0, 2, 0) → (0, 6, 5)
  CHECK(to_world(light).point({1, 0, 0}) == Vec3{0, 6, 5});
  CHECK(to_world(Light{}) == Affine{});
}

TEST_CASE("bounds: of objects, groups and instances") {
  Builder build;
  const Scene& scene = build.scene;
  const ShapeRef sphere = build.shape(Sphere{1});
  const ShapeRef pair = build.group({at(sphere, {-2, 0, 0}), at(sphere, {2, 0, 0})});
  Placement p;
  p.rotate = {0, 0, 90}, p.at = {0, 10, 0};
  build.scene.objects = {at(sphere, {0, 0, 7}), turned(build, pair, p)};
  CHECK(bounds(scene, scene.objects[0]) == Box3{{-1, -1, 6}, {1, 1, 8}});
  CHECK(near(bounds(scene, scene.objects[1]).lower, {-1, 7, -1}));
  CHECK(near(bounds(scene, scene.objects[1]).upper, {1, 13, 1}));
  CHECK(near(bounds(scene).lower, {-1, -1, -1}));
  CHECK(near(bounds(scene).upper, {1, 13, 8}));
  CHECK(finite_bounds(scene) == bounds(scene));
  CHECK(count_primitives(scene) == 3);
}

TEST_CASE("bounds: what is endless does not count where a picture is framed") {
  Builder build;
  const Scene& scene = build.scene;
  const ShapeRef sphere = build.shape(Sphere{1}), plane = build.shape(Plane{});
  Cylinder endless;
  endless.infinite = true;
  const ShapeRef column = build.shape(endless);
  const ShapeRef group = build.group({at(sphere, {5, 0, 0}), at(plane, {0, 0, 0})});
  build.scene.objects = {at(plane, {0, 0, 0}), at(column, {0, 0, 0}), at(group, {0, 1, 0})};
  CHECK(bounds(scene) == all_space());
  CHECK(finite_bounds(scene) == Box3{{4, 0, -1}, {6, 2, 1}});
  CHECK(count_primitives(scene) == 4);
  build.scene.objects.pop_back();
  CHECK(finite_bounds(scene).is_empty());
  CHECK(finite_bounds(Scene{}).is_empty());
}

TEST_CASE("bounds: combinations are as large as they can be, no larger") {
  Builder build;
  const Scene& scene = build.scene;
  using Operation = Combination::Operation;
  const ShapeRef sphere = build.shape(Sphere{1}), floor = build.shape(Plane{});
  const auto combined = [&](Operation operation, const std::vector<Object>& operands) {
    build.scene.objects = {at(build.combination(operation, operands), {0, 0, 0})};
    return bounds(scene);
  };
  CHECK(combined(Operation::intersect, {at(sphere, {0, 0, 0}), at(sphere, {1, 0, 0})}) == Box3{{0, -1, -1}, {1, 1, 1}});
  CHECK(combined(Operation::intersect, {at(sphere, {0, 0, 0}), at(floor, {0, 0, 0})}) == Box3{{-1, -1, -1}, {1, 0, 1}});
  CHECK(finite_bounds(scene) == Box3{{-1, -1, -1}, {1, 0, 1}});
  CHECK(combined(Operation::intersect, {at(sphere, {0, 0, 0}), at(sphere, {3, 0, 0})}).is_empty());
  CHECK(combined(Operation::subtract, {at(sphere, {0, 0, 0}), at(sphere, {1, 0, 0})}) == Box3{{-1, -1, -1}, {1, 1, 1}});
  CHECK(combined(Operation::unite, {at(sphere, {0, 0, 0}), at(sphere, {1, 0, 0})}) == Box3{{-1, -1, -1}, {2, 1, 1}});
  CHECK(combined(Operation::unite, {at(floor, {0, 2, 0})}).upper == Vec3{infinity, 2, infinity});
}

TEST_CASE("bounds: what is invisible is absent") {
  Builder build;
  const Scene& scene = build.scene;
  using Operation = Combination::Operation;
  const ShapeRef sphere = build.shape(Sphere{1});
  Object hidden = at(sphere, {9, 0, 0});
  hidden.is_visible = false;
  build.scene.objects = {at(build.group({at(sphere, {0, 0, 0}), hidden}), {0, 0, 0}), hidden};
  CHECK(bounds(scene) == Box3{{-1, -1, -1}, {1, 1, 1}});
  CHECK(count_primitives(scene) == 1);
  build.scene.objects = {at(build.combination(Operation::intersect, {at(sphere, {0, 0, 0}), hidden}), {0, 0, 0})};
  CHECK(bounds(scene) == Box3{{-1, -1, -1}, {1, 1, 1}});
  build.scene.objects = {at(build.combination(Operation::subtract, {hidden, at(sphere, {0, 0, 0})}), {0, 0, 0})};
  CHECK(bounds(scene).is_empty());
}

TEST_CASE("bounds: a thousand instances of ten thousand spheres are worked out once") {
  Builder build;
  const Scene& scene = build.scene;
  const ShapeRef sphere = build.shape(Sphere{1});
  std::vector<Object> cloud;
  for (int i = 0; i < 10000; ++i) cloud.push_back(at(sphere, {i % 100 * 1.0, i / 100 * 1.0, 0}));
  const ShapeRef shared = build.group(std::move(cloud));
  for (int i = 0; i < 1000; ++i) build.add(at(shared, {0, 0, i * 1.0}));
  CHECK(finite_bounds(scene) == Box3{{-1, -1, -1}, {100, 100, 1000}});
  CHECK(count_primitives(scene) == 10'000'000);
}

TEST_CASE("bounds: instances of instances, thirty and eighty times over") {
  Builder build;
  const Scene& scene = build.scene;
  ShapeRef shape = build.shape(Sphere{0.5});
  double reach = 0.5;
  for (int i = 0; i < 80; ++i) {
    shape = build.group({at(shape, {0, 0, 0}), at(shape, {1, 0, 0})});
    reach += 1;
    if (i != 29) continue;
    build.scene.objects = {at(shape, {0, 0, 0})};
    CHECK(count_primitives(scene) == std::uint64_t{1} << 30U);
    CHECK(finite_bounds(scene).upper.x == reach);
  }
  build.scene.objects = {at(shape, {0, 0, 0})};
  CHECK(count_primitives(scene) == std::numeric_limits<std::uint64_t>::max());
  CHECK(finite_bounds(scene).upper.x == reach);
}

TEST_CASE("bounds: things may nest as deep as memory goes") {
  Builder build;
  const Scene& scene = build.scene;
  ShapeRef shape = build.shape(Sphere{1});
  for (int i = 0; i < 200000; ++i) shape = build.group({at(shape, {1, 0, 0})});
  build.scene.objects = {at(shape, {0, 0, 0})};
  CHECK(bounds(scene).upper.x == 200001);
  CHECK(count_primitives(scene) == 1);
}

TEST_CASE("scene: samples make a grid if their number is a square") {
  CHECK(scene::sample_grid(1) == 1);
  CHECK(scene::sample_grid(9) == 3);
  CHECK(scene::sample_grid(65536) == 256);
  for (const int samples : {-4, 0, 2, 8, 10, 65535}) CHECK_FALSE(scene::sample_grid(samples).has_value());
}
