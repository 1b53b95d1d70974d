#include "renderer/scene/builder.hpp"
#include "renderer/scene/compact.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>

using namespace rt;
using namespace rt::scene;

namespace {

// A sphere with one property of its material given by the last of the patterns.
Scene scene_with(const Field& property, std::vector<Pattern> patterns) {
  Scene scene;
  Object sphere;
  sphere.shape = scene.shapes.add(Sphere{});
  sphere.material = MaterialId{0};
  scene.objects = {sphere};
  property.set(&scene.materials.emplace_back(), PatternId{static_cast<std::uint32_t>(patterns.size() - 1)});
  scene.patterns = std::move(patterns);
  return scene;
}

} // namespace

TEST_CASE("compact: what stands nowhere goes, and references follow") {
  Builder build;
  build.material(Color{1, 0, 0}); // unused, as is every first of these
  build.pattern({Checker{black, black}, {}});
  build.shape(Sphere{1});
  build.transform({{2, 2, 2}, {}, {}, {}});
  build.group({{.shape = build.shape(Sphere{2})}});
  const PatternId inner = build.pattern({Checker{grey(0.25), black}, {}});
  Material tiled;
  tiled.color = build.pattern({Checker{inner, white}, {}});
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
  const auto checker = [&](const Paint& paint) {
    return std::get<Checker>(scene.patterns.at(static_cast<std::size_t>(std::get<PatternId>(paint))).layout);
  };
  CHECK(checker(checker(material.color).a).a == Paint(grey(0.25)));
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

TEST_CASE("compact: the pattern of every property stays, and so does what every pattern shows") {
  const Material plain;
  for (const Field& property : fields(&plain)) {
    if (!property.is_textured) continue;
    PatternKinds::for_each([&]<class P>() {
      for (const Field& part : fields(static_cast<const P*>(nullptr))) {
        const bool has_stops = part.type == FieldType::stops;
        if (!part.is_textured && !has_stops) continue;
        INFO(std::string(property.name) + ", " + std::string(part.name));
        const auto showing = [&](PatternId id) {
          return has_stops ? FieldValue(Stops{{0.25, grey(0.5)}, {0.75, id}}) : FieldValue(id);
        };
        P outer;
        part.set(&outer, showing(PatternId{1}));
        Scene scene = scene_with(property, {{Checker{}, {}}, {Checker{grey(0.5), grey(0.5)}, {}}, {outer, {}}});
        compact(scene);
        REQUIRE(scene.patterns.size() == 2);
        CHECK(std::get<Checker>(scene.patterns[0].layout).a == Paint(grey(0.5)));
        CHECK(part.get(&std::get<P>(scene.patterns[1].layout)) == showing(PatternId{0}));
        CHECK(property.get(&scene.materials[0]) == FieldValue(PatternId{1}));
      }
    });
  }
}
