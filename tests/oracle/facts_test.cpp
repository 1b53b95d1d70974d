#include "tests/oracle/live.hpp"

#include <cmath>

// What the comparisons taught about POV-Ray 3.7, each once a difference: the exporter, the renderer and the
// explanations of the check rest on it.
using namespace rt;
using namespace rt::tests;
namespace povray = rt::tools::povray;
using Catch::Contains;

namespace {

float centre(const std::string& sdl, const std::string& levels = "3") {
  return povray::render("#version 3.7; global_settings { assumed_gamma 1.0 adc_bailout 0 max_trace_level " + levels +
                            " }\n" + sdl,
                        1, 1, {})
      .color[0]
      .r;
}
const std::string camera = "camera { location -z*5 direction z right x up y }\n";
const std::string glow = " pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } ";

} // namespace

TEST_CASE("fact: a crossing without bending needs a level to spare") {
  const std::string pane =
      camera + "background { rgb 1 } plane { z, 0 pigment { rgbf <1, 1, 1, 0.5> } finish { ambient 0 diffuse 0 } }";
  CHECK(centre(pane, "2") == 0.5f);
  CHECK(centre(pane, "1") == 0);
}

TEST_CASE("fact: `matrix` does not normalise the vertex normals of a smooth triangle, `scale` does") {
  const std::string triangle =
      camera + "light_source { <0, 0, -1>*100, rgb 1 parallel point_at 0 }\n"
               "smooth_triangle { <-1, -1, 0>, <-1, 0, -1>, <1, -1, 0>, <0.5, 0, -1>, <0, 1, 0>, <0, 1, -1> "
               "pigment { rgb 1 } finish { ambient 0 diffuse 1 } ";
  const float bare = centre(triangle + "matrix <1, 0, 0, 0, 1, 0, 0, 0, 0.2, 0, 0, 0> }");
  const float normalised = centre(triangle + "matrix <1, 0, 0, 0, 1, 0, 0, 0, 0.2, 0, 0, 0> scale 1 }");
  CHECK(normalised == centre(triangle + "scale <1, 1, 0.2> }"));
  CHECK(std::abs(bare - normalised) > 1e-4f);
}

TEST_CASE("fact: a smooth triangle with normals on both sides is left out, and the exporter says so") {
  CHECK(centre(camera + "smooth_triangle { <-1, -1, 0>, <0, 0, -1>, <1, -1, 0>, <0, 0, -1>, <0, 1, 0>, <0, 0.1, 1>" +
               glow + "}") == 0);
  const auto inexact =
      povray::export_povray(scene_of("triangle { normals: [[0, 0, 1], [0, 0, 1], [0, 0.1, -1]] }")).inexact;
  REQUIRE(inexact.size() == 1);
  CHECK_THAT(inexact[0].message, Contains("normals"));
}

TEST_CASE("fact: a spotlight without shadows shines everywhere, and the exporter says so") {
  const std::string wall = camera +
                           "plane { z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
                           "light_source { <0, 50, -5>, rgb 1 spotlight point_at <0, 50, 0> radius 5 falloff 6 ";
  CHECK(centre(wall + "}") == 0);
  CHECK(centre(wall + "shadowless }") > 0.05f);
  CHECK(povray::export_povray(scene_of("spot { at: [0, 3, 0], shadows: false }\nsphere {}")).inexact.size() == 1);
}

TEST_CASE("fact: the part of a solid cannot refuse its shadow, and the exporter says so") {
  CHECK(povray::export_povray(scene_of("sphere {} - box { casts_shadow: false }")).inexact.size() == 1);
  CHECK(povray::export_povray(scene_of("(sphere {} - box {}) { casts_shadow: false }")).inexact.empty());
}

TEST_CASE("fact: an index of refraction is kept in 32 bits") {
  const auto through = [&](const std::string& ior) {
    return centre(camera + "sphere { 0, 1 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior " + ior +
                  " } translate <0.6, 0, 0> }\n"
                  "plane { z, 100 pigment { gradient x scale 1000 translate <-500, 0, 0> } finish { ambient 0 diffuse "
                  "0 emission 1 } }");
  };
  CHECK(through("1.3") == through("1.2999999523162842"));
  CHECK(through("1.3") != through("1.3001"));
}

namespace {

// What a ball of glass shows that mirrors by Fresnel's equations. In a medium POV-Ray lets nothing mirror inside of it.
float glass_beside(const std::string& thing) {
  return centre(camera + thing +
                    " pigment { rgb 0.7 } finish { ambient 0 diffuse 0 emission 1 } }\n"
                    "box { <-100, -100, 30>, <100, 100, 31>" +
                    glow +
                    "}\n"
                    "sphere { <30, 0, 0>, 1" +
                    glow +
                    "}\n"
                    "sphere { <0.3, 0, 0>, 1 pigment { rgbf 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb "
                    "0.5 fresnel on } } interior { ior 2 } }",
                "6");
}

} // namespace

TEST_CASE("fact: the eye is inside opaque things too, which `inverse` undoes") {
  const float shell = glass_beside("union { box { <-20, -20, -20>, <20, 20, -19> } box { <-20, -20, 19>, <20, 20, 20> "
                                   "} box { <-20, 19, -19>, <20, 20, 19> } "
                                   "box { <-20, -20, -19>, <20, -19, 19> } box { <19, -19, -19>, <20, 19, 19> } box { "
                                   "<-20, -19, -19>, <-19, 19, 19> }");
  CHECK(glass_beside("box { -19, 19 inverse") == Approx(shell).epsilon(1e-6));
  CHECK(std::abs(glass_beside("box { -19, 19") - shell) > 0.01f);
  const std::string room =
      "camera { at: [0, 0, 5] }\nbox { size: 20 }\nsphere { material: glass { reflect: 1, fresnel: true } }";
  CHECK_THAT(povray::export_povray(scene_of(room)).text, Contains(" inverse }"));
  CHECK(holds(check_scene(scene_of("size: [32, 24]\n" + room)).comparison));
}

TEST_CASE("fact: a disc has all below it for its inside, as far as its bounding box goes") {
  const std::string tilted = "disc { y*0.5, <0.3, 1, 0>, 30 ", level = "disc { y*0.5, y, 30 ";
  CHECK(std::abs(glass_beside(tilted) - glass_beside(tilted + "inverse")) > 1e-3f);
  CHECK(glass_beside(level) == glass_beside(level + "inverse"));
  // `clipped_by` does not change what is inside, an intersection does: that is how the exporter writes it where only
  // some of the view's rays start below.
  CHECK(glass_beside(tilted + "clipped_by { sphere { y*30, 20 } }") ==
        glass_beside("disc { y*0.5, <0.3, 1, 0>, 30 clipped_by { sphere { y*40, 20 } }"));
  const std::string text = "size: [32, 24]\ncamera { at: [0, 0, 5], projection: orthographic, width: 4 }\n"
                           "disc { normal: [0.1, 1, 0.1], material: tomato }\nsphere { radius: 0.5, at: [0, 0, 2], "
                           "material: glass { reflect: 1, fresnel: true } }";
  CHECK_THAT(povray::export_povray(scene_of(text)).text, Contains("intersection { disc {"));
  CHECK(holds(check_scene(scene_of(text)).comparison));
}

TEST_CASE(
    "fact: a smooth triangle is looked at after each transform, and left out once its normals are on both sides") {
  const std::string head =
      "smooth_triangle { <-1, -1, 0>, <0, -0.7, -1>, <1, -1, 0>, <0.8, 0, -1>, <0, 1, 0>, <0, 0.9, -1>" + glow;
  CHECK(centre(camera + head + "}") == 1);
  // Sheared across the line of sight, x by -2 z, and back.
  const std::string there = "matrix <1, 0, 0, 0, 1, 0, -2, 0, 1, 0, 0, 0> ",
                    back = "matrix <1, 0, 0, 0, 1, 0, 2, 0, 1, 0, 0, 0> ";
  CHECK(centre(camera + head + there + "}") == 0);
  CHECK(centre(camera + head + there + back + "}") == 0);

  const std::string triangle = "triangle { points: [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], normals: [[0, -0.7, 1], [0.8, "
                               "0, 1], [0, 0.9, 1]], material: checker {} }";
  const std::string stage = "size: [32, 24]\ncamera { at: [1, 0.5, 5] }\nlight { at: [2, 3, 5] }\n" + triangle;
  CHECK(holds(check_scene(scene_of(stage)).comparison));
  CHECK(povray::export_povray(scene_of(stage + ".shear(xz: 2)")).inexact.size() == 1);
  CHECK(povray::export_povray(scene_of(stage + ".shear(xz: 2).shear(xz: -2)")).inexact.empty());
  CHECK(holds(check_scene(scene_of(stage + ".shear(xz: 2).shear(xz: -2)")).comparison));
  // The group's transforms are applied by POV-Ray after its own, one by one.
  CHECK(
      povray::export_povray(scene_of(stage + "\ngroup { at: [1, 0, 0]\n " + triangle + " }.shear(xz: 2).shear(xz: -2)"))
          .inexact.size() == 1);
}

TEST_CASE("fact: a solid has one index of refraction, that of the part that has one if the whole has none") {
  for (const char* part :
       {"material { reflect: 0.4, fresnel: true, ior: 1.75 }", "material { refract: 0.8, ior: 1.75 }"}) {
    const std::string solid =
        std::string("box { size: 1.2, rotate: [10, 30, 0] } | sphere { radius: 0.8, material: ") + part + " }";
    CHECK(holds(check_scene(scene_of("size: [32, 24]\n" + solid)).comparison));
    CHECK(holds(check_scene(scene_of("size: [32, 24]\n(" + solid + ") { material: khaki }")).comparison));
  }
}

TEST_CASE("fact: a blocker counts from 1e-3 of the surface on, and from 1e-3 of the transparent one before it") {
  const auto lit = [&](const std::string& blockers) {
    return centre(
        "camera { location <0, 0.5, -5> direction <0, -0.1, 1> right x*1e-3 up y*1e-3 }\n"
        "light_group { light_source { y*5 rgb 1 } plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n" +
        blockers + " global_lights off }");
  };
  const auto pane = [](const std::string& y, const std::string& pigment) {
    return "box { <-1, " + y + ", -0.001>, <1, " + y + " + 4e-4, 1> pigment { " + pigment + " } }\n";
  };
  const float open = lit("");
  CHECK(open > 0.5f);
  CHECK(lit(pane("3e-4", "rgb 0")) == open);
  CHECK(lit(pane("2e-3", "rgb 0")) == 0);
  // A pane of 4e-4 has but one surface, a box two.
  CHECK(lit(pane("1", "rgbf <0.5, 0.5, 0.5, 1>")) == Approx(open * 0.5).epsilon(1e-6));
  CHECK(lit("box { <-1, 1, -1>, <1, 2, 1> pigment { rgbf <0.5, 0.5, 0.5, 1> } }") == Approx(open * 0.25).epsilon(1e-6));
}

TEST_CASE("fact: hits nearer than 1e-4 and farther than 1e7 do not count") {
  const auto at = [&](const std::string& distance) {
    return centre(camera + "plane { z, " + distance + " - 5" + glow + "}");
  };
  CHECK(at("0.00005") == 0);
  CHECK(at("0.0002") == 1);
  CHECK(at("9e6") == 1);
  CHECK(at("1.1e7") == 0);
}
