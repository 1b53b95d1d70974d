#include "tests/oracle/live.hpp"

#include <cmath>

// What the comparisons taught about POV-Ray 3.7, each once a difference: the exporter, the renderer and the explanations
// of the check rest on it.
using namespace rt;
using namespace rt::tests;
namespace povray = rt::tools::povray;
using Catch::Contains;

namespace {

float centre(const std::string& sdl, const std::string& levels = "3") {
  return povray::render("#version 3.7; global_settings { assumed_gamma 1.0 adc_bailout 0 max_trace_level " + levels + " }\n" + sdl, 1, 1, {})
      .color[0]
      .r;
}
const std::string camera = "camera { location -z*5 direction z right x up y }\n";
const std::string glow = " pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } ";

} // namespace

TEST_CASE("fact: a crossing without bending needs a level to spare") {
  const std::string pane = camera + "background { rgb 1 } plane { z, 0 pigment { rgbf <1, 1, 1, 0.5> } finish { ambient 0 diffuse 0 } }";
  CHECK(centre(pane, "2") == 0.5f);
  CHECK(centre(pane, "1") == 0);
}

TEST_CASE("fact: `matrix` does not normalise the vertex normals of a smooth triangle, `scale` does") {
  const std::string triangle = camera + "light_source { <0, 0, -1>*100, rgb 1 parallel point_at 0 }\n"
                                        "smooth_triangle { <-1, -1, 0>, <-1, 0, -1>, <1, -1, 0>, <0.5, 0, -1>, <0, 1, 0>, <0, 1, -1> "
                                        "pigment { rgb 1 } finish { ambient 0 diffuse 1 } ";
  const float bare = centre(triangle + "matrix <1, 0, 0, 0, 1, 0, 0, 0, 0.2, 0, 0, 0> }");
  const float normalised = centre(triangle + "matrix <1, 0, 0, 0, 1, 0, 0, 0, 0.2, 0, 0, 0> scale 1 }");
  CHECK(normalised == centre(triangle + "scale <1, 1, 0.2> }"));
  CHECK(std::abs(bare - normalised) > 1e-4f);
}

TEST_CASE("fact: a smooth triangle with normals on both sides is left out, and the exporter says so") {
  CHECK(centre(camera + "smooth_triangle { <-1, -1, 0>, <0, 0, -1>, <1, -1, 0>, <0, 0, -1>, <0, 1, 0>, <0, 0.1, 1>" + glow + "}") == 0);
  const auto inexact = povray::export_povray(scene_of("triangle { normals: [[0, 0, 1], [0, 0, 1], [0, 0.1, -1]] }")).inexact;
  REQUIRE(inexact.size() == 1);
  CHECK_THAT(inexact[0].message, Contains("normals"));
}

TEST_CASE("fact: a spotlight without shadows shines everywhere, and the exporter says so") {
  const std::string wall = camera + "plane { z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
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
    return centre(camera + "sphere { 0, 1 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior " + ior + " } translate <0.6, 0, 0> }\n"
                           "plane { z, 100 pigment { gradient x scale 1000 translate <-500, 0, 0> } finish { ambient 0 diffuse 0 emission 1 } }");
  };
  CHECK(through("1.3") == through("1.2999999523162842"));
  CHECK(through("1.3") != through("1.3001"));
}

TEST_CASE("fact: the eye is inside opaque things too, which `inverse` undoes") {
  const auto glass_in_room = [&](const std::string& word) {
    return centre(camera + "box { -20, 20" + glow + word + " }\n"
                           "sphere { 0, 1 pigment { rgbf 1 } finish { ambient 0 diffuse 0 reflection { rgb 0, rgb 0.5 fresnel on } conserve_energy } interior { ior 2 } }");
  };
  CHECK(glass_in_room("inverse") != glass_in_room(""));
  CHECK_THAT(povray::export_povray(scene_of("camera { at: [0, 0, 5] }\nbox { size: 20 }\nsphere { material: glass }")).text, Contains(" inverse }"));
}

TEST_CASE("fact: hits nearer than 1e-4 and farther than 1e7 do not count") {
  const auto at = [&](const std::string& distance) { return centre(camera + "plane { z, " + distance + " - 5" + glow + "}"); };
  CHECK(at("0.00005") == 0);
  CHECK(at("0.0002") == 1);
  CHECK(at("9e6") == 1);
  CHECK(at("1.1e7") == 0);
}
