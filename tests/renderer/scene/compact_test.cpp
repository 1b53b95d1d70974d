#include "renderer/scene/builder.hpp"
#include "renderer/scene/compact.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::scene;

TEST_CASE("compact: what stands nowhere goes, and references follow") {
  Builder build;
  build.material(Color{1, 0, 0}); // unused, as is every first of these
  build.pattern({.a = black});
  build.shape(Sphere{1});
  build.transform({{2, 2, 2}, {}, {}, {}});
  build.group({{.shape = build.shape(Sphere{2})}});
  const PatternId inner = build.pattern({.a = grey(0.25)});
  Material tiled;
  tiled.color = build.pattern({.a = inner, .b = white});
  const Object ball{.shape = build.shape(Sphere{3}),
                    .transform = build.transform({{3, 3, 3}, {}, {}, {}}).value(),
                    .material = build.material(tiled)};
  build.add({.shape = build.group({ball})});
  Scene scene = build.scene;
  compact(scene);
  REQUIRE(scene.shapes.all<Sphere>().size() == 1);
  REQUIRE(scene.shapes.all<Group>().size() == 1);
  REQUIRE(scene.materials.size() == 1);
  REQUIRE(scene.patterns.size() == 2);
  REQUIRE(scene.transforms.size() == 1);
  const Object& kept = scene.shapes.get<Group>(scene.objects.at(0).shape).members.at(0);
  CHECK(scene.shapes.get<Sphere>(kept.shape).radius == 3);
  CHECK(placement(scene, kept).scale == Vec3{3, 3, 3});
  const Material& material = scene.materials.at(static_cast<std::size_t>(kept.material));
  const Pattern& outer = scene.patterns.at(static_cast<std::size_t>(std::get<PatternId>(material.color)));
  CHECK(scene.patterns.at(static_cast<std::size_t>(std::get<PatternId>(outer.a))).a == Paint(grey(0.25)));
}

TEST_CASE("compact: a scene without anything left over stays as it is") {
  Builder build;
  build.add({.shape = build.shape(Sphere{1}), .material = build.material(Color{1, 0, 0})});
  Scene scene = build.scene;
  compact(scene);
  CHECK(scene.shapes.all<Sphere>().size() == 1);
  CHECK(scene.materials.size() == 1);
  CHECK(scene.objects.size() == 1);
  CHECK(scene.objects[0].shape == build.scene.objects[0].shape);
}
