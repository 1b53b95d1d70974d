#include "tests/support/scenes.hpp"
#include "tools/inspect/object_ids.hpp"
#include "tools/inspect/scene_hash.hpp"
#include "tools/inspect/scene_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <functional>
#include <limits>

using namespace rt;
using nlohmann::json;
using rt::tests::WrittenScene;

namespace {

std::string text_of(const scene::Scene& scene) {
  std::string text;
  tools::write_scene_json(scene, [&](std::string_view piece) { text += piece; });
  return text;
}

/// A scene with something of everything.
WrittenScene everything() {
  WrittenScene b;
  const auto pattern =
      b.pattern({.layout = scene::Checker{Color{1, 0, 0}, black}, .placement = {{2, 2, 2}, {}, {}, {}}});
  const auto tiled = b.material({.color = pattern,
                                 .reflect = Color{0.1, 0.2, 0.3},
                                 .refract = 0.9,
                                 .ior = 1.5,
                                 .roughness = 0.5,
                                 .metal = scene::Metal{white, grey(2)},
                                 .absorb = scene::Absorb{grey(0.5), 3}});
  b.scene.names = {"ball", "key \"light\"\n"};
  scene::Object& ball = b.place(scene::Sphere{0.1}, tiled, {1, 2, 1.0 / 3});
  ball.name = scene::NameId{0};
  ball.casts_shadow = false;
  scene::Plane floor;
  floor.y = -1;
  b.place(floor);
  const scene::Object member = b.object(scene::Box{}, scene::no_material, {0, 1, 0});
  b.place(scene::Group{{member, member}}).transform = *b.transform(
      {{1, 1, 1}, {0, 30, 0}, {}, {scene::MoveStep{{1, 0, 0}}, scene::ShearStep{.xy = 0.5}, scene::MatrixStep{}}});
  b.place(
      scene::Combination{scene::Combination::Operation::subtract, {b.object(scene::Box{}), b.object(scene::Sphere{})}});
  b.light(scene::SpotLight{{}, {0, 5, 0}, {}, 20, 30.0, {scene::Fade::Law::quadratic, 2}, {}});
  b.scene.lights[0].name = scene::NameId{1};
  b.scene.lights[0].enclosing = {{{1, 1, 1}, {}, {0, 0, 7}, {}}};
  return b;
}

} // namespace

TEST_CASE("scene as JSON: an object has its shape's properties, its place, its material and where it was written") {
  const json j = json::parse(text_of(everything().scene));
  const json& ball = j["objects"][0];
  CHECK(ball["shape"] == "sphere");
  CHECK(ball["radius"] == 0.1);
  CHECK(ball["at"] == json({1, 2, 1.0 / 3}));
  CHECK(ball["material"] == 0);
  CHECK(ball["name"] == "ball");
  CHECK(ball["casts_shadow"] == false);
  CHECK(ball["file"] == "test.rtl");
  CHECK(ball["line"] == 1);
  CHECK(j["objects"][1] ==
        json({{"shape", "plane"}, {"y", -1}, {"at", {0, 0, 0}}, {"id", 2}, {"file", "test.rtl"}, {"line", 2}}));
  CHECK(j["objects"][2]["ids"] == json({3, 4})); // a group of two
  CHECK(j["objects"][3]["id"] == 5);             // a combination is one object
}

TEST_CASE("scene as JSON: the manifest has the ids of every name, the outermost for those in groups") {
  const auto named = [](scene::Object object, scene::NameId name) {
    object.name = name;
    return object;
  };
  WrittenScene b;
  b.scene.names = {"ball", "pair", "hidden"};
  const auto sphere = [&] { return b.object(scene::Sphere{}); };
  scene::Object hidden = named(sphere(), scene::NameId{2});
  hidden.is_visible = false;
  b.place(scene::Sphere{}); // 1
  b.place(
      scene::Group{{named(sphere(), scene::NameId{0}), hidden, sphere(), named(sphere(), scene::NameId{0})}}); // 2 to 4
  b.scene.objects.push_back(
      named(b.object(scene::Group{{named(sphere(), scene::NameId{0}), sphere()}}), scene::NameId{1})); // 5 and 6
  b.scene.objects.push_back(named(sphere(), scene::NameId{1}));                                        // 7
  CHECK(json::parse(text_of(b.scene))["manifest"] ==
        json::parse(R"([{"name": "ball", "id": 2}, {"name": "ball", "id": 4}, {"name": "pair", "ids": [5, 7]}])"));
}

TEST_CASE("scene as JSON: groups and combinations are lists that objects name by index") {
  const json j = json::parse(text_of(everything().scene));
  const json& group = j["objects"][2];
  CHECK(group["shape"] == "group");
  CHECK(group["index"] == 0);
  CHECK(group["rotate"] == json({0, 30, 0}));
  CHECK(group["chain"][0] == json({{"move", {1, 0, 0}}}));
  CHECK(group["chain"][1]["shear"]["xy"] == 0.5);
  CHECK(group["chain"][2]["matrix"] == json({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}));
  CHECK(j["groups"][0]["members"].size() == 2);
  CHECK(j["groups"][0]["members"][1]["shape"] == "box");
  CHECK(j["combinations"][0]["operation"] == "difference");
  CHECK(j["combinations"][0]["operands"][1]["shape"] == "sphere");
}

TEST_CASE("scene as JSON: settings, camera, lights, materials and patterns have all their fields") {
  const scene::Scene scene = everything().scene;
  const json j = json::parse(text_of(scene));
  CHECK(j["size"] == json({64, 48}));
  CHECK(j["camera"]["fov"] == 45);
  CHECK(j["camera"]["projection"] == "perspective");
  const json& spot = j["lights"][0];
  CHECK(spot["light"] == "spot");
  CHECK(spot["falloff"] == 30);
  CHECK(spot["fade"] == json({{"law", "quadratic"}, {"distance", 2}}));
  CHECK(spot["enclosing"][0]["at"] == json({0, 0, 7}));
  CHECK(spot["name"] == "key \"light\"\n");
  const json& material = j["materials"][0];
  CHECK(material["color"] == json({{"pattern", 0}}));
  CHECK(material["reflect"] == json({0.1, 0.2, 0.3}));
  CHECK(material["highlight"] == "blinn");
  CHECK(material["metal"] == json({{"n", {1, 1, 1}}, {"k", {2, 2, 2}}}));
  CHECK(material["absorb"] == json({{"color", {0.5, 0.5, 0.5}}, {"distance", 3}}));
  for (const scene::Field& field : scene::fields(static_cast<const scene::Material*>(nullptr)))
    CHECK(material.contains(std::string(field.name)));
  CHECK(j["patterns"][0]["pattern"] == "checker");
  CHECK(j["patterns"][0]["a"] == json({1, 0, 0}));
  CHECK(j["patterns"][0]["scale"] == json({2, 2, 2}));
}

TEST_CASE("scene as JSON: numbers keep all their digits and every object has a line") {
  WrittenScene b;
  for (const double radius : {0.1, 1.0 / 3, 1e-300, 123456789.123456789, std::numeric_limits<double>::max()})
    b.place(scene::Sphere{radius});
  const std::string text = text_of(b.scene);
  const json j = json::parse(text);
  CHECK(j["objects"][0]["radius"].get<double>() == 0.1);
  CHECK(j["objects"][1]["radius"].get<double>() == 1.0 / 3);
  CHECK(j["objects"][2]["radius"].get<double>() == 1e-300);
  CHECK(j["objects"][3]["radius"].get<double>() == 123456789.123456789);
  CHECK(j["objects"][4]["radius"].get<double>() == std::numeric_limits<double>::max());
  CHECK(text.find("\n    {\"shape\": \"sphere\", \"radius\": 0.1, \"at\": [0, 0, 0], \"id\": 1, \"file\": "
                  "\"test.rtl\", \"line\": 1},\n") != std::string::npos);
  CHECK(text == text_of(b.scene));
}

TEST_CASE("scene as JSON: a number that is not finite is a word") {
  WrittenScene b;
  b.place(scene::Sphere{std::numeric_limits<double>::infinity()});
  CHECK(json::parse(text_of(b.scene))["objects"][0]["radius"] == "inf");
}

TEST_CASE("scene hash: any change of the description changes it, source lines do not") {
  const std::string before = tools::scene_hash(everything().scene);
  CHECK(before.size() == 16);
  CHECK(before == tools::scene_hash(everything().scene));
  const std::vector<std::function<void(scene::Scene&)>> changes{
      [](scene::Scene& s) {
        s.size = {64, 49};
      },
      [](scene::Scene& s) { s.camera.fov = 45.000000000000007; },
      [](scene::Scene& s) { s.objects[0].at.z += 1e-16; },
      [](scene::Scene& s) { s.objects[0].material = scene::no_material; },
      [](scene::Scene& s) { s.objects[1].is_visible = false; },
      [](scene::Scene& s) { std::swap(s.objects[0], s.objects[1]); },
      [](scene::Scene& s) { s.objects.pop_back(); },
      [](scene::Scene& s) { s.transforms[0].chain.pop_back(); },
      [](scene::Scene& s) { s.names[0] = "bell"; },
      [](scene::Scene& s) { s.lights[0].enclosing[0].at.z = 8; },
      [](scene::Scene& s) { s.materials[0].highlight = scene::Highlight::phong; },
      [](scene::Scene& s) { s.shapes.all<scene::Combination>()[0].operation = scene::Combination::Operation::unite; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    scene::Scene scene = everything().scene;
    changes[i](scene);
    INFO("change " << i);
    CHECK(tools::scene_hash(scene) != before);
  }
  scene::Scene moved = everything().scene;
  for (scene::Object& object : moved.objects) object.origin.line += 10;
  moved.files = {"other.rtl"};
  CHECK(tools::scene_hash(moved) == before);
}

TEST_CASE("object ids: counted over what can be seen, named by the outermost name") {
  WrittenScene b;
  b.scene.names = {"table"};
  scene::Object leg = b.object(scene::Box{});
  scene::Object hidden = b.object(scene::Sphere{});
  hidden.is_visible = false;
  b.place(scene::Sphere{});
  b.place(scene::Group{{leg, hidden, leg}}).name = scene::NameId{0};
  b.place(scene::Group{{hidden, leg}});
  const tools::ObjectIds ids(b.scene);
  CHECK(ids.name(0).empty());
  CHECK(ids.name(1) == "sphere 1");
  CHECK(ids.name(2) == "table");
  CHECK(ids.name(3) == "table");
  CHECK(ids.name(4) == "box 4");
  CHECK(ids.name(5).empty());
}
