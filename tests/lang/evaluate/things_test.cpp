#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

using Codes = std::vector<std::string>;

namespace {

scene::Scene scene_of(const std::string& text, const LoadOptions& options = {}) {
  Loaded loaded = load(text, options);
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  return *std::move(loaded.scene);
}

template <class S>
const S& shape(const scene::Scene& scene, std::size_t object) {
  REQUIRE(object < scene.objects.size());
  REQUIRE(scene.objects[object].shape.kind == scene::kind_of<S>);
  return scene.shapes.get<S>(scene.objects[object].shape);
}

const std::vector<scene::Object>& members(const scene::Scene& scene, const scene::Object& object) {
  REQUIRE(object.shape.kind == scene::kind_of<scene::Group>);
  return scene.shapes.get<scene::Group>(object.shape).members;
}

} // namespace

TEST_CASE("things: every shape takes its defaults") {
  const scene::Scene scene =
      scene_of("sphere\nplane {}\ncylinder {}\ncone {}\nbox {}\ndisc {}\ntriangle {}\nquad {}\npolygon {}");
  CHECK(scene.objects.size() == 9);
  CHECK(shape<scene::Sphere>(scene, 0).radius == 1);
  CHECK_FALSE(shape<scene::Plane>(scene, 1).normal);
  CHECK(shape<scene::Cone>(scene, 3).to == Vec3{0, 1, 0});
  CHECK(shape<scene::Polygon>(scene, 8).points.size() == 4);
}

TEST_CASE("things: a copy merges properties and keeps the chain") {
  const scene::Scene scene = scene_of("post = cylinder { from: [0, 0, 0], to: [0, 2, 0], radius: 0.1 }.move(x: 1)\n"
                                      "post { radius: 0.2 }\npost { at: [0, 0, 1] }.scale(2)\npost");
  CHECK(shape<scene::Cylinder>(scene, 0).radius == 0.2);
  CHECK(to_parent(scene, scene.objects[0]).point({0, 0, 0}) == Vec3{1, 0, 0});
  // at, then the chain in the order written: (0, 0, 1) moved by (1, 0, 0), then doubled.
  CHECK(to_parent(scene, scene.objects[1]).point({0, 0, 0}) == Vec3{2, 0, 2});
  CHECK(shape<scene::Cylinder>(scene, 2).radius == 0.1);
}

TEST_CASE("things: copies that differ in place alone share the shape") {
  const scene::Scene scene =
      scene_of("ball = sphere { radius: 0.3 }\nfor x in 0..9 { ball { at: [x, 0, 0] } }\nball { radius: 2 }");
  CHECK(scene.objects.size() == 11);
  CHECK(scene.shapes.all<scene::Sphere>().size() == 2);
  CHECK(scene.objects[3].shape == scene.objects[7].shape);
}

TEST_CASE("things: the other form of a copy drops the inherited one") {
  const scene::Scene scene = scene_of("floor = plane { normal: [0, 1, 1], offset: 2 }\nfloor { y: 3 }\nwall = plane { "
                                      "z: 1 }\nwall { normal: [1, 0, 0] }");
  CHECK(shape<scene::Plane>(scene, 0).y == 3);
  CHECK_FALSE(shape<scene::Plane>(scene, 0).normal);
  CHECK_FALSE(shape<scene::Plane>(scene, 0).offset);
  CHECK(shape<scene::Plane>(scene, 1).normal == Vec3{1, 0, 0});
  CHECK_FALSE(shape<scene::Plane>(scene, 1).z);
  CHECK(errors("plane { y: 1, x: 2 }") == Codes{"E0206"});
}

TEST_CASE("things: scale, rotate and at apply in this order, however they are written") {
  const scene::Scene scene = scene_of("box { at: [1, 2, 3], rotate: [0, 90, 0], scale: [2, 1, 1] }\nbox { scale: [2, "
                                      "1, 1], at: [1, 2, 3], rotate: [0, 90, 0] }");
  // (1, 0, 0) doubled is (2, 0, 0), a quarter turn about y carries it to (0, 0, -2), then it is moved.
  CHECK(to_parent(scene, scene.objects[0]).point({1, 0, 0}) == Vec3{1, 2, 1});
  CHECK(to_parent(scene, scene.objects[1]) == to_parent(scene, scene.objects[0]));
  CHECK(scene.transforms.size() == 1); // one turn for both
}

TEST_CASE("things: the steps of a chain") {
  const auto image = [](const std::string& chain, const Vec3& p) {
    const scene::Scene scene = scene_of("box {}" + chain);
    return to_parent(scene, scene.objects[0]).point(p);
  };
  CHECK(image(".scale(2)", {1, 2, 3}) == Vec3{2, 4, 6});
  CHECK(image(".scale(y: 3)", {1, 2, 3}) == Vec3{1, 6, 3});
  CHECK(image(".scale([2, 3, 4], about: [1, 1, 1])", {2, 2, 2}) == Vec3{3, 4, 5});
  CHECK(image(".rotate(z: 90)", {1, 0, 0}) == Vec3{0, 1, 0});
  CHECK(image(".rotate([90, 0, 0])", {0, 1, 0}) == Vec3{0, 0, 1});
  CHECK(image(".rotate(axis: [0, 0, 2], angle: 180, about: [1, 0, 0])", {3, 0, 0}) == Vec3{-1, 0, 0});
  CHECK(image(".move([1, 2, 3]).move(y: -1)", {0, 0, 0}) == Vec3{1, 1, 3});
  CHECK(image(".shear(xy: 0.5)", {1, 2, 0}) == Vec3{2, 2, 0});
  CHECK(image(".mirror([1, 0, 0], about: [1, 0, 0])", {3, 4, 5}) == Vec3{-1, 4, 5});
  CHECK(image(".mirror(y: 1)", {1, 2, 3}) == Vec3{1, -2, 3});
  CHECK(image(".transform([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]])", {1, 2, 3}) == Vec3{3, 7, 10});
  CHECK(image(".transform([[2, 0, 0], [0, 2, 0], [0, 0, 2]])", {1, 2, 3}) == Vec3{2, 4, 6});
  CHECK(image(".transform([[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])", {0, 0, 0}) == Vec3{1, 2, 3});
}

TEST_CASE("things: a def makes a group, with properties in its body as defaults") {
  const scene::Scene scene =
      scene_of("def post(height = 2) {\n  material: red\n  at: [9, 0, 0]\n  box { size: [1, height, 1] }\n}\n"
               "post {}\npost { height: 3, material: blue }\npost { at: [1, 2, 3] }\npost");
  REQUIRE(scene.objects.size() == 4);
  CHECK(scene.objects[0].at == Vec3{9, 0, 0});
  CHECK(scene.objects[2].at == Vec3{1, 2, 3});
  CHECK(std::get<Color>(scene.materials[static_cast<std::size_t>(scene.objects[0].material)].color) == Color{1, 0, 0});
  CHECK(std::get<Color>(scene.materials[static_cast<std::size_t>(scene.objects[1].material)].color) == Color{0, 0, 1});
  CHECK(scene.shapes.get<scene::Box>(members(scene, scene.objects[1])[0].shape).size == Vec3{1, 3, 1});
  // Equal arguments, equal group: instances.
  CHECK(scene.objects[0].shape == scene.objects[2].shape);
  CHECK(scene.objects[0].shape == scene.objects[3].shape);
  CHECK_FALSE(scene.objects[0].shape == scene.objects[1].shape);
  CHECK(scene.shapes.all<scene::Group>().size() == 2);
}

TEST_CASE("things: a def runs again when its arguments change, however often it was copied") {
  const scene::Scene scene = scene_of("def row(n, gap = 1) { for i in 0..<n { sphere { at: [i * gap, 0, 0] } } }\n"
                                      "wide = row { gap: 5 }.move(y: 1)\nwide { n: 3 }\nwide { n: 2, gap: 2 }\n"
                                      "for k in 1..2 { wide { n: k } }");
  REQUIRE(scene.objects.size() == 4);
  CHECK(members(scene, scene.objects[0]).size() == 3);
  CHECK(members(scene, scene.objects[0])[2].at.x == 10);
  CHECK(members(scene, scene.objects[1])[1].at.x == 2);
  CHECK(members(scene, scene.objects[2]).size() == 1);
  CHECK(to_parent(scene, scene.objects[3]).translation == Vec3{0, 1, 0});
  CHECK(errors("def row(n) { sphere { radius: n } }\nrow {}") == Codes{"E0208"});
}

TEST_CASE("things: recursion shares every level") {
  const scene::Scene scene = scene_of(
      "def flake(level) {\n  sphere {}\n  if level > 0 {\n    small = flake { level: level - 1 }.scale(1 / 3)\n"
      "    for i in 0..<9 { small.move(x: i) }\n  }\n}\nflake { level: 6 }");
  CHECK(scene.shapes.all<scene::Sphere>().size() == 7);
  CHECK(scene.shapes.all<scene::Group>().size() == 7);
  CHECK(count_primitives(scene) == (4782969 - 1) / 8); // 9⁷ = 4782969: 1 + 9 + 81 + … + 9⁶
}

TEST_CASE("things: groups hold what their block says, and copies add to it") {
  const scene::Scene scene = scene_of("pair = group { sphere {}, box { at: [2, 0, 0] } }\npair\npair { at: [0, 5, 0] "
                                      "}\npair { cone {}\n material: red }\npair { [disc {}, quad {}] }");
  REQUIRE(scene.objects.size() == 4);
  CHECK(scene.objects[0].shape == scene.objects[1].shape);
  CHECK(members(scene, scene.objects[2]).size() == 3);
  CHECK(members(scene, scene.objects[3]).size() == 4);
  CHECK(scene.objects[2].material != scene::no_material);
}

TEST_CASE("things: what is kept and never placed is not in the scene") {
  const scene::Scene scene = scene_of("a = group { sphere { material: red }.rotate(y: 5), torus = 3 }\nb = box {} - "
                                      "sphere {}\nc = a { cone {} }\nplane { material: blue }");
  CHECK(scene.objects.size() == 1);
  CHECK(scene.shapes.all<scene::Sphere>().empty());
  CHECK(scene.shapes.all<scene::Group>().empty());
  CHECK(scene.shapes.all<scene::Combination>().empty());
  CHECK(scene.materials.size() == 1);
  CHECK(scene.transforms.empty());
}

TEST_CASE("things: visible false is absent, with everything in it") {
  const scene::Scene scene = scene_of("sphere { visible: false }\ngroup { visible: false\n box {}\n light {} }\ngroup "
                                      "{ sphere { visible: false }, box {} }\nplane {}");
  REQUIRE(scene.objects.size() == 2);
  CHECK(members(scene, scene.objects[0]).size() == 1);
  CHECK(find(load("sphere { visible: false }"), "N0002")); // the light in the group is no light of the scene
}

TEST_CASE("things: lists are placed element by element, none places nothing") {
  const scene::Scene scene =
      scene_of("[sphere {}, [box {}, none], []]\nnone\nif false { cone {} }\n[cone {} for i in 1..3 if i != 2]");
  CHECK(scene.objects.size() == 4);
}

TEST_CASE("things: if and for put what they hold into the block around them") {
  const scene::Scene scene = scene_of("big = true\nsphere { if big { radius: 3 } else { radius: 1 }\n for x in [7] { "
                                      "at: [x, 0, 0] } }\nif big { background: white }\nfor d in [4] { max_depth: d }");
  CHECK(shape<scene::Sphere>(scene, 0).radius == 3);
  CHECK(scene.objects[0].at.x == 7);
  CHECK(scene.background == white);
  CHECK(scene.max_depth == 4);
}

TEST_CASE("things: properties at the top level are the scene's") {
  const scene::Scene scene =
      scene_of("size: [320, 240]\nbackground: 0.5\nambient: #ffffff\nmax_depth: 3\nsamples: 4\nsphere {}");
  CHECK(scene.size == scene::Resolution{320, 240});
  CHECK(scene.background == grey(0.5));
  CHECK(scene.ambient == white);
  CHECK(scene.samples == 4);
}

TEST_CASE("things: names and lines go with the objects") {
  const scene::Scene scene = scene_of("ball = sphere { name: \"ball\" }\n\nball { at: [1, 0, 0] }\nfor i in 0..1 {\n  "
                                      "box { name: \"crate\" }\n}\nball");
  REQUIRE(scene.objects.size() == 4);
  CHECK(scene.names == std::vector<std::string>{"ball", "crate"});
  CHECK(scene.objects[0].origin.line == 3);
  CHECK(scene.objects[1].origin.line == 5);
  CHECK(scene.objects[2].origin.line == 5);
  CHECK(scene.objects[3].origin.line == 1); // where it was written
  CHECK(scene.objects[1].name == scene.objects[2].name);
  CHECK(scene.files[0] == "test.rtl");
}

TEST_CASE("things: what was written can be read back, and defaults too") {
  CHECK(number("ball.radius * 10 + ball.at.y", "ball = sphere { radius: 2, at: [0, 3, 0] }") == 23);
  CHECK(number("sphere {}.radius") == 1);
  CHECK(number("(box { at: [1, 2, 3] }).at.z") == 3);
  CHECK(number("t.width", "def table(width) { box {} }\nt = table { width: 7 }") == 7);
  CHECK(number("material { ior: 1.5 }.ior + material {}.shininess") == 33.5);
}

TEST_CASE("things: records") {
  CHECK(number("door.size[1] * door.count", "door = { size: [1, 2], count: 3 }") == 6);
  CHECK(number("(door { count: 5 }).count + door.count", "door = { count: 3 }") == 8);
}

TEST_CASE("lights: stand in groups and move with them") {
  const scene::Scene scene = scene_of("lamp = group { light { at: [1, 0, 0] }, sphere { radius: 0.1 } }\nlamp { at: "
                                      "[0, 5, 0] }\ngroup { lamp.rotate(y: 90)\n at: [0, 0, 7] }");
  REQUIRE(scene.lights.size() == 2);
  CHECK(to_world(scene.lights[0]).point({1, 0, 0}) == Vec3{1, 5, 0});
  CHECK(scene.lights[1].enclosing.size() == 2);
  // A quarter turn about y carries +x to -z.
  CHECK(to_world(scene.lights[1]).point({1, 0, 0}) == Vec3{0, 0, 6});
}

TEST_CASE("lights: kinds, fades, and shadows") {
  const scene::Scene scene =
      scene_of("light { fade: linear(3), shadows: false }\nspot { at: [0, 5, 0], angle: 20, falloff: 30, fade: "
               "inverse_square }\nsun { intensity: 2 }\nlight { fade: none }.move(x: 1)");
  REQUIRE(scene.lights.size() == 4);
  CHECK(std::get<scene::PointLight>(scene.lights[0].source).fade == scene::Fade{scene::Fade::Law::linear, 3});
  CHECK_FALSE(std::get<scene::PointLight>(scene.lights[0].source).shadows);
  CHECK(std::get<scene::SpotLight>(scene.lights[1].source).falloff == 30);
  CHECK(std::get<scene::SpotLight>(scene.lights[1].source).fade.law == scene::Fade::Law::inverse_square);
  CHECK(std::get<scene::SunLight>(scene.lights[2].source).intensity == 2);
  CHECK(to_world(scene.lights[3]).translation == Vec3{1, 0, 0});
}

TEST_CASE("camera: one, at the top level, and kept ones do not count") {
  const scene::Scene scene = scene_of("view = camera { at: [0, 0, 5], fov: 30 }\nside = camera {}\nif true { view { "
                                      "projection: orthographic, width: 8 } }\nsphere {}");
  CHECK(scene.camera.at == Vec3{0, 0, 5});
  CHECK(scene.camera.fov == 30);
  CHECK(scene.camera.projection == scene::Projection::orthographic);
  CHECK(scene.camera_origin.line == 3);
}

TEST_CASE("materials: colours, patterns and records serve as materials") {
  const scene::Scene scene =
      scene_of("sphere { material: red }\nsphere { material: checker { a: red, b: checker { scale: 2 } } }\n"
               "sphere { material: { color: blue, reflect: 0.5 } }\nsphere { material: material { diffuse: checker { "
               "a: 0.2, b: 1 } } }\n"
               "sphere { material: red }\nsphere { material: material { color: red } }");
  CHECK(scene.patterns.size() == 3);
  CHECK(std::holds_alternative<scene::PatternId>(
      scene.materials[static_cast<std::size_t>(scene.objects[1].material)].color));
  CHECK(scene.materials[static_cast<std::size_t>(scene.objects[2].material)].reflect == scene::Paint(grey(0.5)));
  CHECK(scene.objects[0].material == scene.objects[4].material);
  // A record is a material of its own, not a change of the inherited one.
  const scene::Scene changed =
      scene_of("a = sphere { material: { color: blue, reflect: 0.5 } }\na { material: { color: red } }");
  CHECK(changed.materials.size() == 1);
  CHECK(changed.materials[0].reflect == scene::Paint(black));
}

TEST_CASE("materials: a record's misspelt property is reported where its name stands, with what others call it") {
  const Loaded loaded = load("sphere { material: { shinyness: 3, colour: red } }");
  REQUIRE(errors(loaded) == std::vector<std::string>{"E0204", "E0204"});
  CHECK(loaded.diagnostics[0].span.begin == 21);
  CHECK(loaded.diagnostics[0].span.end == 30);
  CHECK(loaded.diagnostics[0].label == "did you mean `shininess`?");
  CHECK(loaded.diagnostics[1].label == "write `color`");
}

TEST_CASE("materials: the library holds what the reference says") {
  const scene::Scene scene = scene_of("for m in [glass, water, diamond, mirror, gold, silver, copper, chrome, rubber, "
                                      "matte] { sphere { material: m } }\nsphere { material: glass { color: red } }");
  CHECK(scene.materials.size() == 11);
  CHECK(scene.materials[0].ior == 1.52);
  CHECK(scene.materials[2].ior == 2.417);
  CHECK(scene.materials[10].ior == 1.52);
}

TEST_CASE("things: lights and patterns are not flattened either") {
  CHECK(errors("sphere { material: checker { scale: 1e-200 } }") == std::vector<std::string>{"E0406"});
  CHECK(errors("light {}.scale(1e-60).scale(1e-60)") == std::vector<std::string>{"E0406"});
  CHECK(errors("sphere { material: checker { scale: 1e-60 } }\nlight {}.scale(1e-60)").empty());
}
