#include "renderer/compile/compile.hpp"
#include "renderer/compile/compiled_scene.hpp"
#include "renderer/render/ray_query.hpp"
#include "renderer/render/render.hpp"
#include "renderer/scene/builder.hpp"
#include "renderer/scene/validation/validate.hpp"
#include "tools/povray/export/export.hpp"

#include <catch2/catch.hpp>

#include <functional>
#include <limits>

using namespace rt;
using namespace rt::scene;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Object of(ShapeRef shape) {
  return {.shape = shape};
}

/// One of everything, without a flaw: a group of a ball and of a ball without a half-space, glass, a pattern in a
/// pattern, a transform, a light of each kind.
Builder sound() {
  Builder build;
  Material glass;
  glass.refract = 1.0, glass.ior = 1.5;
  const PatternId dots = build.pattern({Checker{white, black}, {}});
  Material tiled;
  tiled.color = build.pattern({Checker{dots, white}, {}});
  Object ball = of(build.shape(Sphere{2}));
  ball.material = build.material(glass);
  ball.transform = build.transform({{1, 2, 1}, {}, {}, {}}).value();
  ball.name = build.name("ball");
  Object bowl =
      of(build.combination(Combination::Operation::subtract, {of(build.shape(Sphere{3})), of(build.shape(Plane{}))}));
  bowl.material = build.material(tiled);
  build.add(of(build.group({ball, bowl})));
  build.add(of(build.shape(Disc{})));
  build.add(PointLight{});
  build.add(SunLight{});
  build.add(SpotLight{});
  build.scene.lights[0].enclosing = {{{2, 2, 2}, {}, {}, {}}};
  return build;
}

std::vector<std::string> paths(const Scene& scene, Flaw::Kind kind) {
  std::vector<std::string> list;
  for (const Flaw& flaw : validate(scene)) {
    INFO(flaw.path << ": " << flaw.message);
    CHECK(flaw.kind == kind);
    list.push_back(flaw.path);
  }
  return list;
}

/// The paths of the flaws, all of this kind, of the sound scene with one thing made wrong.
std::vector<std::string> broken(Flaw::Kind kind, const std::function<void(Scene&)>& damage) {
  Builder build = sound();
  damage(build.scene);
  return paths(build.scene, kind);
}

using Paths = std::vector<std::string>;
using Kind = Flaw::Kind;

} // namespace

TEST_CASE("validate: a sound scene has no flaw, nor has an empty one") {
  CHECK(validate(sound().scene).empty());
  CHECK(validate(Scene{}).empty());
}

TEST_CASE("validate: every field keeps its constraint") {
  CHECK(broken(Kind::value, [](Scene& s) { s.size = {0, 48}; }) == Paths{"size"});
  CHECK(broken(Kind::value, [](Scene& s) { s.background = {0, -1, 0}; }) == Paths{"background"});
  CHECK(broken(Kind::value, [](Scene& s) { s.max_depth = -1; }) == Paths{"max_depth"});
  CHECK(broken(Kind::value, [](Scene& s) { s.camera.fov = 180; }) == Paths{"camera.fov"});
  CHECK(broken(Kind::value, [](Scene& s) { s.camera.up = {}; }) == Paths{"camera.up"});
  CHECK(broken(Kind::value, [](Scene& s) { s.materials[0].ior = 0; }) == Paths{"materials[0].ior"});
  CHECK(broken(Kind::value, [](Scene& s) {
          s.materials[1].diffuse = Color{1, 1, nothing};
        }) == Paths{"materials[1].diffuse"});
  // Every shininess is above 0: not what a pattern of white and black shows, nor one that holds that pattern.
  CHECK(broken(Kind::value, [](Scene& s) { s.materials[0].shininess = PatternId{0}; }) ==
        Paths{"materials[0].shininess"});
  CHECK(broken(Kind::value, [](Scene& s) { s.materials[0].shininess = PatternId{1}; }) ==
        Paths{"materials[0].shininess"});
  CHECK(broken(Kind::value, [](Scene& s) { std::get<Checker>(s.patterns[0].layout).b = grey(-1); }) ==
        Paths{"patterns[0].b"});
  CHECK(broken(Kind::value, [](Scene& s) { s.shapes.all<Sphere>()[0].radius = 0; }) ==
        Paths{"objects[0].members[0].radius"});
  CHECK(broken(Kind::value, [](Scene& s) { s.shapes.all<Sphere>()[1].radius = infinity; }) ==
        Paths{"objects[0].members[1].operands[0].radius"});
  CHECK(broken(Kind::value, [](Scene& s) { s.shapes.all<Disc>()[0].normal = {}; }) == Paths{"objects[1].normal"});
  CHECK(broken(Kind::value, [](Scene& s) { s.objects[1].at.y = nothing; }) == Paths{"objects[1].at"});
  CHECK(broken(Kind::value, [](Scene& s) { std::get<PointLight>(s.lights[0].source).intensity = -1; }) ==
        Paths{"lights[0].intensity"});
  CHECK(broken(Kind::value, [](Scene& s) { std::get<PointLight>(s.lights[0].source).fade.distance = 0; }) ==
        Paths{"lights[0].fade"});
  CHECK(broken(Kind::value, [](Scene& s) { std::get<SunLight>(s.lights[1].source).direction = {}; }) ==
        Paths{"lights[1].direction"});
}

TEST_CASE("validate: what a thing is made of goes together") {
  CHECK(broken(Kind::thing, [](Scene& s) { s.samples = 3; }) == Paths{"samples"});
  CHECK(broken(Kind::thing, [](Scene& s) { s.camera.look_at = s.camera.at; }) == Paths{"camera.look_at"});
  CHECK(broken(Kind::thing, [](Scene& s) { s.camera.up = s.camera.at - s.camera.look_at; }) == Paths{"camera.up"});
  CHECK(broken(Kind::thing, [](Scene& s) { s.lights[0].source = s.lights[2].source = SkyLight{}; }) ==
        Paths{"lights[2]"});
  CHECK(broken(Kind::thing, [](Scene& s) {
          std::get<SpotLight>(s.lights[2].source).look_at = {0, 3, 0};
        }) == Paths{"lights[2].look_at"});
  CHECK(broken(Kind::thing, [](Scene& s) { s.shapes.all<Combination>()[0].operands.clear(); }) ==
        Paths{"objects[0].members[1]"});
  CHECK(broken(Kind::thing, [](Scene& s) {
          Triangle flat;
          flat.points = {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
          s.objects.push_back(of(s.shapes.add(flat)));
        }) == Paths{"objects[2].points"});
}

TEST_CASE("validate: no placement flattens, or stretches without end") {
  CHECK(broken(Kind::transform, [](Scene& s) { s.transforms[0].scale.y = 0; }) == Paths{"transforms[0]"});
  CHECK(broken(Kind::transform, [](Scene& s) { s.transforms[0].scale = {1e200, 1e200, 1}; }) == Paths{"transforms[0]"});
  CHECK(broken(Kind::transform, [](Scene& s) {
          s.transforms[0].chain = {MirrorStep{{0, 0, 0}, {}}};
        }) == Paths{"transforms[0]"});
  CHECK(broken(Kind::transform, [](Scene& s) { s.patterns[1].placement.scale = {}; }) == Paths{"patterns[1]"});
  CHECK(broken(Kind::transform, [](Scene& s) { s.lights[0].enclosing[0].scale = {}; }) ==
        Paths{"lights[0].enclosing[0]"});
  CHECK(broken(Kind::transform, [](Scene& s) {
          s.lights[1].chain = {ScaleStep{{1, 0, 1}, {}}};
        }) == Paths{"lights[1]"});
}

TEST_CASE("validate: operands are solids, and no groups") {
  const auto with_operand = [](const Object& operand) {
    return [=](Scene& s) { s.shapes.all<Combination>()[0].operands.push_back(operand); };
  };
  const ShapeRef disc{kind_of<Disc>, 0}, ball{kind_of<Sphere>, 0};
  CHECK(broken(Kind::operand, with_operand(of(disc))) == Paths{"objects[0].members[1].operands[2]"});
  CHECK(broken(Kind::operand, [&](Scene& s) { with_operand(of(s.shapes.add(Group{{of(ball)}})))(s); }) ==
        Paths{"objects[0].members[1].operands[2]"});
  CHECK(broken(Kind::operand, [&](Scene& s) {
          Cylinder tube;
          tube.open = true;
          with_operand(of(s.shapes.add(tube)))(s);
        }) == Paths{"objects[0].members[1].operands[2]"});
}

TEST_CASE("validate: one solid is one medium") {
  const auto damage = [](Scene& s) {
    Material water = s.materials[0];
    water.ior = 1.33;
    s.materials.push_back(water);
    auto& operands = s.shapes.all<Combination>()[0].operands;
    operands[0].material = MaterialId{0};
    operands[1].material = MaterialId{2};
  };
  CHECK(broken(Kind::media, [&](Scene& s) {
          damage(s);
          s.shapes.all<Group>()[0].members[1].material = no_material;
        }) == Paths{"combinations[0]"});
  CHECK(broken(Kind::media, damage).empty()); // the whole has a material of its own
}

TEST_CASE("validate: references lead to what is there, and not in circles") {
  CHECK(broken(Kind::reference, [](Scene& s) { s.objects[1].shape.index = 1; }) == Paths{"objects[1].shape"});
  CHECK(broken(Kind::reference, [](Scene& s) { s.objects[1].shape.kind = 99; }) == Paths{"objects[1].shape"});
  CHECK(broken(Kind::reference, [](Scene& s) { s.objects[1].material = MaterialId{2}; }) ==
        Paths{"objects[1].material"});
  CHECK(broken(Kind::reference, [](Scene& s) { s.objects[1].transform = TransformId{1}; }) ==
        Paths{"objects[1].transform"});
  CHECK(broken(Kind::reference, [](Scene& s) { s.objects[1].name = NameId{1}; }) == Paths{"objects[1].name"});
  CHECK(broken(Kind::reference, [](Scene& s) { s.lights[0].name = NameId{1}; }) == Paths{"lights[0].name"});
  CHECK(broken(Kind::reference, [](Scene& s) { std::get<Checker>(s.patterns[0].layout).a = PatternId{1}; }) ==
        Paths{"patterns[0].a"});
  CHECK(broken(Kind::reference, [](Scene& s) { std::get<Checker>(s.patterns[1].layout).a = PatternId{1}; }) ==
        Paths{"patterns[1].a"});
  CHECK(broken(Kind::reference, [](Scene& s) { s.materials[0].color = PatternId{2}; }) == Paths{"materials[0].color"});
  CHECK(broken(Kind::reference, [](Scene& s) {
          s.shapes.all<Combination>()[0].operands.push_back(of({kind_of<Combination>, 0}));
        }) == Paths{"objects[0].members[1].operands[2]"});
}

TEST_CASE("validate: things may nest as deep as memory goes") {
  Builder build;
  ShapeRef shape = build.shape(Sphere{});
  for (int i = 0; i < 200'000; ++i) shape = build.group({of(shape)});
  for (int i = 0; i < 200'000; ++i) shape = build.combination(Combination::Operation::unite, {of(shape)});
  build.add(of(shape));
  CHECK(validate(build.scene).empty());
}

TEST_CASE("validate: what does not pass is neither rendered nor exported nor asked about") {
  Builder build = sound();
  build.scene.shapes.all<Sphere>()[0].radius = -1;
  CHECK_THROWS_AS(render(build.scene, {}), InvalidScene);
  CHECK_THROWS_AS(RayQuery(build.scene, 1), InvalidScene);
  CHECK_THROWS_AS(CompiledScene(build.scene, 1), InvalidScene);
  CHECK_THROWS_AS(tools::povray::export_povray(build.scene), InvalidScene);
  CompileCache cache(1);
  const std::vector<Part> parts{{0, 1, 7}};
  CHECK_THROWS_AS(CompiledScene(build.scene, parts, cache), InvalidScene);
  CHECK_THROWS_WITH(CompiledScene(build.scene, 1), Catch::Contains("objects[0].members[0].radius: `radius` must be"));

  const Scene fine = sound().scene;
  const CompiledScene compiled(fine, 1);
  View view{fine.camera, {4, 3}, 1};
  CHECK(render(compiled, view, {}).is_complete);
  view.camera.look_at = view.camera.at;
  CHECK_THROWS_AS(render(compiled, view, {}), InvalidScene);
}

TEST_CASE("validate: transforms that flatten only together are found on the way") {
  Builder build;
  ShapeRef shape = build.shape(Box{});
  for (int i = 0; i < 2; ++i) {
    Object object = of(shape);
    object.transform = build.transform({{1e-90, 1e-90, 1e-90}, {0, 30, 0}, {}, {}}).value();
    shape = build.group({object});
  }
  build.add(of(shape));
  CHECK(validate(build.scene).empty());
  CHECK_THROWS_AS(CompiledScene(build.scene, 1), InvalidScene);
}
