#include "lang/load.hpp"
#include "renderer/render/render.hpp"
#include "tests/support/program.hpp"
#include "tools/import/import.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::tests;
using namespace rt::tools;
using Catch::Matchers::Contains;

namespace {

import::Imported read(const std::string& text, const import::Options& options = {}){
    return import::format_of("scene.rt")->read(text, "scene.rt", options);
}

/// The errors and warnings, "line: message", in order.
std::vector<std::string> complaints(const import::Imported& imported) {
  std::vector<std::string> list;
  for (const lang::Diagnostic& d : imported.diagnostics)
    list.push_back(std::to_string(imported.sources.position(0, d.span.begin).line) + ": " + d.message);
  return list;
}

scene::Scene scene_of(const std::string& text) {
  lang::Loaded loaded = lang::load_text(text, "scene.rt", ".", {});
  for (const lang::Diagnostic& d : loaded.diagnostics) UNSCOPED_INFO(d.message);
  REQUIRE(loaded.scene);
  return *loaded.scene;
}

constexpr const char* mandatory = "A 0.2 255,255,255\n"
                                  "# the eye\n"
                                  "C -50.0,0,20 0,0,1 70\n"
                                  "L -40.0,50.0,0.0 0.6 10,0,255\n"
                                  "\n"
                                  "pl 0.0,0.0,-10.0 0.0,1.0,0.0 0,0,225\n"
                                  "sp\t0.0,0.0,20.6 12.6\t10,0,255\n"
                                  "cy 50.0,0.0,20.6 0.0,0.0,1.0 14.2 21.42 10,0,255\n";

} // namespace

TEST_CASE("mini_rt: the school's own example, as one would type it") {
  const import::Imported imported = read(mandatory);
  CHECK(complaints(imported).empty());
  CHECK_THAT(imported.text, Contains("size: [1280, 720]\n"
                                     "fn paint(r, g, b) = material { color: linear_rgb(r / 255, g / 255, b / 255), "
                                     "diffuse: 1 }\n"
                                     "ambient: 0.2\n"
                                     "// the eye\n"
                                     "camera { at: [-50, 0, 20], look_at: [-50, 0, 21], fov: 70 }\n"
                                     "light { at: [-40, 50, 0], intensity: 0.6, color: linear_rgb(10 / 255, 0, 1) }\n"
                                     "\n"
                                     "plane { y: 0, material: paint(0, 0, 225) }\n"
                                     "sphere { at: [0, 0, 20.6], radius: 6.3, material: paint(10, 0, 255) }\n"));
  CHECK(scene_of(imported.text).size == scene::Resolution{1280, 720});
}

TEST_CASE("mini_rt: its light is ratio and colour over 255, without gamma or fading") {
  // One ball straight ahead, lit from where the eye is: n·l = 1, so I = c·(0.25·a + 0.5·b), channel by channel.
  const import::Imported imported = read("A 0.25 255,51,0\n"
                                         "C 0,0,0 0,0,-1 60\n"
                                         "L 0,0,0 0.5 255,255,102\n"
                                         "sp 0,0,-5 2 255,102,204\n");
  for (const std::string& text : {imported.text, imported.by_line}) {
    scene::Scene scene = scene_of(text);
    scene.size = {1, 1};
    const Film film = render(scene, {}).film;
    CHECK(film.color[0].r == Approx(1 * (0.25 * 1 + 0.5 * 1)).epsilon(1e-6));
    CHECK(film.color[0].g == Approx(0.4 * (0.25 * 0.2 + 0.5 * 1)).epsilon(1e-6));
    CHECK(film.color[0].b == Approx(0.8 * (0.25 * 0 + 0.5 * 0.4)).epsilon(1e-6));
  }
}

TEST_CASE("mini_rt: an eye that looks straight up, and numbers as people write them") {
  const scene::Scene scene = scene_of(read("A .5 +255,0,0\r\nC 1.,-2,+3 0,1,0 60\r\nsp 0,5,0 1 1,2,3\r\n").text);
  CHECK(scene.camera.at == Vec3{1, -2, 3});
  CHECK(scene.camera.look_at == Vec3{1, -1, 3});
  CHECK(scene.camera.up == Vec3{0, 0, 1});
  CHECK(scene.lights.empty()); // ambient light only, and none is assumed
}

TEST_CASE("mini_rt: a cylinder stands about its middle with discs, in the older form without, or on its foot") {
  const auto cylinder = [](const import::Imported& imported) {
    const scene::Scene scene = scene_of(imported.text);
    REQUIRE(scene.shapes.all<scene::Cylinder>().size() == 1);
    return std::pair(scene.shapes.all<scene::Cylinder>()[0], imported.text);
  };
  const std::string newer = "A 0 0,0,0\nC 0,0,9 0,0,-1 50\ncy 1,2,3 0,1,0 4 6 9,9,9\n";
  const std::string older = "R 80 60\nA 0 0,0,0\nc 0,0,9 0,0,-1 50\ncy 1,2,3 0,1,0 4 6 9,9,9\n";
  const auto [closed, text] = cylinder(read(newer));
  CHECK(closed.radius == 2);
  CHECK(closed.height == 6);
  CHECK_FALSE(closed.open);
  CHECK_THAT(text, Contains("cylinder { at: [1, 2, 3], axis: [0, 1, 0], height: 6, radius: 2"));
  CHECK(cylinder(read(older)).first.open);
  import::Options foot;
  foot.cylinders_stand_on_foot = true;
  CHECK_THAT(read(newer, foot).text, Contains("cylinder { at: [1, 5, 3]"));
}

TEST_CASE("mini_rt: the older form has its own size, squares, triangles, many lamps and views") {
  const import::Imported imported = read("R 320 200\n"
                                         "A 0.1 255,255,255\n"
                                         "c 0,0,9 0,0,-1 50\n"
                                         "c 9,0,0 -1,0,0 40\n"
                                         "l 1,1,1 0.5 255,255,255\n"
                                         "l 2,2,2 0.5 255,0,0\n"
                                         "sq 0,0,0 0,0,1 3 10,20,30\n"
                                         "tr 0,0,0 1,0,0 0,1,0 10,20,30\n");
  CHECK(complaints(imported).empty());
  const scene::Scene scene = scene_of(imported.text);
  CHECK(scene.size == scene::Resolution{320, 200});
  CHECK(scene.camera.at == Vec3{0, 0, 9});
  CHECK(scene.lights.size() == 2);
  CHECK_THAT(imported.text, Contains("// another view: camera { at: [9, 0, 0], look_at: [8, 0, 0], fov: 40 }"));
  CHECK(scene_of(imported.by_line).lights.size() == 2);
}

TEST_CASE("mini_rt: places in the scene are places in the file") {
  const scene::Scene scene = scene_of(read(mandatory).by_line);
  REQUIRE(scene.objects.size() == 3);
  CHECK(scene.objects[0].origin.line == 6);
  CHECK(scene.objects[1].origin.line == 7);
  CHECK(scene.objects[2].origin.line == 8);
}

TEST_CASE("mini_rt: every defect of every line is told, in one run") {
  CHECK(complaints(read("A 1.5 255,255,255\n"
                        "C 0,0 0,0,0 181\n"
                        "L 0,0,0 0.5 256,0,0\n"
                        "sp 0,0,0 0 255.0,0,0\n"
                        "sp 0,0,0 1e3 1,2,3,4\n"
                        "sp 0,0,0 --1 1,2\n"
                        "pl 0,0,0 0,2,0 0,0,0\n"
                        "cy 0,0,0 0,1,0 1\n"
                        "sp 0,0,0 inf 0x10,0,0\n"
                        "ba 1,2,3\n"
                        "sq 0,0,0 0,1,0 1 0,0,0\n"
                        "A 0.5 0,0,0\n")) ==
        std::vector<std::string>{
            "1: the ratio of `A` must be from 0 to 1",
            "2: the point of `C` is three numbers with commas and no spaces: 0,1.5,-2",
            "2: the direction of `C` must not be 0,0,0",
            "2: the field of view of `C` must be from 0 to 180",
            "3: the colour of `L` must have numbers from 0 to 255",
            "4: the diameter of `sp` must be above 0",
            "4: the colour of `sp` is three whole numbers with commas and no spaces: 255,0,100",
            "5: the diameter of `sp` is a number: 1.5",
            "5: the colour of `sp` is three whole numbers with commas and no spaces: 255,0,100",
            "6: the diameter of `sp` is a number: 1.5",
            "6: the colour of `sp` is three whole numbers with commas and no spaces: 255,0,100",
            "7: the direction of `pl` must have numbers from -1 to 1",
            "8: `cy` takes 5 fields, not 3: point, direction, diameter, height, colour",
            "9: the diameter of `sp` is a number: 1.5",
            "9: the colour of `sp` is three whole numbers with commas and no spaces: 255,0,100",
            "10: `ba` is not a miniRT element",
            "11: `sq` does not belong to the 2021 format",
            "12: a file has one ambient light (`A`)",
        });
  CHECK(complaints(read("sp 0,0,0 1 1,2,3\n")) ==
        std::vector<std::string>{"2: the file has no ambient light (`A`)", "2: the file has no camera (`C`)"});
}

TEST_CASE("mini_rt: lenient, common forms are taken and the rest is left out, with a word") {
  const std::string text = "A 0.1 255,255,255\nC 0,0,9 0,0,-1 50\nL 1,1,1 0.5\nL 2,2,2 0.5 255,0,0\n"
                           "sp 0,0,0 1 1,2,3 checker\nco 0,0,0 0,1,0 2 3 1,2,3\nbump 3\n";
  CHECK(read(text).has_errors());
  import::Options lenient;
  lenient.is_lenient = true;
  const import::Imported imported = read(text, lenient);
  CHECK(complaints(imported) == std::vector<std::string>{"5: extra text after the fields of `sp` is ignored",
                                                         "7: `bump` is not a miniRT element: ignored"});
  const scene::Scene scene = scene_of(imported.text);
  CHECK(scene.lights.size() == 2);
  REQUIRE(scene.shapes.all<scene::Cone>().size() == 1);
  CHECK(scene.shapes.all<scene::Cone>()[0].to == Vec3{0, 3, 0});
}

TEST_CASE("mini_rt: what graders like to try is warned of") {
  const import::Imported imported = read("A 0.1 255,255,255\nC 0,0,9 0,0,-0.9 180\nsp 0,0,0 1 1,2,3\n");
  CHECK(complaints(imported) ==
        std::vector<std::string>{"2: the direction of `C` has length 0.9",
                                 "2: a field of view of 180° cannot be drawn on a flat picture"});
  CHECK(scene_of(imported.text).camera.fov == 179.99);
}

TEST_CASE("mini_rt: commands take such a file directly, and tell mistakes in its lines") {
  const TestFolder folder;
  RunOptions options;
  options.folder = folder.path();
  folder.write("scene.rt", mandatory);
  CHECK(rtlang({"convert", "scene.rt", "-o", "scene.rtl"}, options).exit_code == 0);
  CHECK(rtlang({"scene.rt", "-q", "-o", "a.ppm", "--size", "32x18"}, options).exit_code == 0);
  CHECK(rtlang({"scene.rtl", "-q", "-o", "b.ppm", "--size", "32x18"}, options).exit_code == 0);
  CHECK(folder.read("a.ppm") == folder.read("b.ppm"));
  CHECK_THAT(rtlang({"probe", "scene.rt", "--ray", "0,0,0", "0,0,1"}, options).output, Contains("scene.rt:7"));
  folder.write("wrong.rt", "A 0.2 255,255,255\nC 0,0,0 0,0,1 70\nsp 0,0,20 -2 1,2,3\n");
  const Outcome wrong = rtlang({"wrong.rt", "-o", "c.ppm"}, options);
  CHECK(wrong.exit_code == 1);
  CHECK_THAT(wrong.errors, Contains("error[E0801]: the diameter of `sp` must be above 0") && Contains("wrong.rt:3:11"));
  CHECK(folder.read("c.ppm").empty());
  CHECK(rtlang({"convert", "scene.rtl"}, options).exit_code == 2);
  CHECK(rtlang({"convert", "missing.rt"}, options).exit_code == 3);
}
