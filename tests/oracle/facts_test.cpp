#include "renderer/shading/optics.hpp"
#include "tests/oracle/live.hpp"

#include <fmt/format.h>

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

TEST_CASE("fact: Fresnel's equations get the ratio of two solids' indices in 32 bits") {
  // From glass into air, 1e-6 in g² before total reflection: there the last digits of the ratio count ten-thousandfold.
  const double cosine = std::sqrt(1 + 1e-6 - 4.0 / 9), sine = std::sqrt(1 - cosine * cosine);
  const std::string glass = " pigment { rgbf 1 } finish { ambient 0 diffuse 0 ", air = "interior { ior 1 } }\n";
  const float mirrored = centre(
      fmt::format("camera {{ location -z*5 direction <{}, 0, {}> right x*1e-9 up y*1e-9 }}\n", sine, cosine) +
          "sphere { 0, 1000" + glass + "} interior { ior 1.5 } }\nbox { <-100, -100, 0>, <100, 100, 1>" + glass +
          "reflection { rgb 0, rgb 1 fresnel on } } " + air + "box { <-500, -500, -11>, <500, 500, -10>" + glow + "}",
      "8");
  CHECK(mirrored == Approx(fresnel_reflectance(cosine, 1.0f / 1.5f)).margin(5e-6));
  CHECK(std::abs(mirrored - fresnel_reflectance(cosine, 1 / 1.5)) > 1e-4);
}

namespace {

// The box between 0 and 1, met 5 from the camera at x = 0 and y = `off`, along a ray in the plane of x and y.
float box_edge(double x, double y, double off, const std::string& look) {
  return centre(fmt::format("camera {{ location <{}, {}, 0.5> direction <{}, {}, 0> right z up <{}, {}, 0> }}\n",
                            -5 * x, off - 5 * y, x, y, -y, x) +
                "light_source { -x*100, rgb 1 parallel point_at 0 shadowless }\nbox { 0, 1 " + look + " }");
}
const std::string matt = "pigment { rgb 1 } finish { ambient 0 diffuse 1 }";

} // namespace

TEST_CASE("fact: faces of a box met within 1e-6 of one another are met at once, on the one met more steeply") {
  // The light falls on the face x = 0 alone. The ray enters there, 7e-7 above the edge, and crossed y = 0 a moment ago.
  CHECK(box_edge(0.6, 0.8, 7e-7, matt) == 0);
  CHECK(box_edge(0.6, 0.8, 1e-6, matt) == 1);
  // It enters through y = 0, having crossed x = 0 a moment ago.
  CHECK(box_edge(0.8, 0.6, -5e-7, matt) == 1);
  CHECK(box_edge(0.8, 0.6, -7e-7, matt) == 0);
  // The distance is that of the plane x = 0, which is looked at first: not of x = 5e-7 · 0.8 / 0.6.
  const std::string ruler =
      "pigment { function { max(0, min(1, x*1e6 + 0.1)) } color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 0 "
      "diffuse 0 emission 1 }";
  CHECK(box_edge(0.8, 0.6, -5e-7, ruler) == Approx(0.1).margin(1e-6));
  CHECK(box_edge(0.8, 0.6, -7e-7, ruler) == 1);
}

TEST_CASE("fact: among several things a box is missed where a ray cuts off less than its bounding box has digits") {
  // 1e-6 of the ray's 24 is in the box; bounding boxes are looked at in 32 bits, and only where there is more than one.
  const std::string corner = "camera { location <13, 11, 17> direction <-0.47964633530265394, -0.33752297627874556, "
                             "-0.8099491548947202> right x*1e-3 up y*1e-3 }\n";
  const std::string others = "sphere { x*50, 1 } sphere { x*54, 1 } sphere { x*58, 1 } sphere { x*62, 1 }";
  const std::string straight = "box { <0.53, -1, -2.47>, <1.47, 3.0353615262336637, -1.53>",
                    turned = "box { <1.53, -1, 0.53>, <2.47, 3.0353615262336637, 1.47>";
  CHECK(centre(corner + straight + glow + "}") == 1);
  CHECK(centre(corner + straight + glow + "}\n" + others) == 0);
  CHECK(centre(corner + turned + glow + "rotate y*90 }\n" + others) == 0);
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
