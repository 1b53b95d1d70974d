#include "tests/support/scenes.hpp"
#include "tools/povray/export/export.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;
using namespace rt::tools::povray;
using Catch::Contains;

namespace {

std::string exported(const WrittenScene& b, Pass pass = Pass::color) {
  return export_povray(b.scene, {.pass = pass, .comments = false}).text;
}
template <class S>
std::string exported_shape(S shape) {
  WrittenScene b;
  b.place(std::move(shape));
  return exported(b);
}
std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

scene::Plane plane_y(double y) {
  scene::Plane plane;
  plane.y = y;
  return plane;
}

} // namespace

TEST_CASE("export: the camera is four vectors, its width that of the horizontal field of view") {
  WrittenScene b;
  b.scene.size = {200, 100};
  b.scene.camera = {.at = {0, 0, 5}, .look_at = {0, 0, 0}, .up = {0, 2, 0}, .fov = 90};
  const std::string text = exported(b);
  // 2 · tan 45° wide, half of it high.
  CHECK_THAT(text,
             Contains("perspective\n  location <0, 0, 5>\n  direction <0, 0, -1>\n  right <2, 0, 0>\n  up <0, 1, 0>") ||
                 Contains("right <1.9999999999999998, 0, 0>\n  up <0, 0.9999999999999999, 0>"));
  b.scene.camera.projection = scene::Projection::orthographic;
  b.scene.camera.width = 6;
  CHECK_THAT(exported(b),
             Contains("orthographic\n  location <0, 0, 5>\n  direction <0, 0, -1>\n  right <6, 0, 0>\n  up <0, 3, 0>"));
}

TEST_CASE("export: one level more than the greatest depth, and nothing is cut off") {
  WrittenScene b;
  b.scene.max_depth = 5;
  CHECK_THAT(exported(b), Contains("max_trace_level 6") && Contains("adc_bailout 0.001953125"));
}

TEST_CASE("export: shapes and their forms") {
  CHECK_THAT(exported_shape(scene::Sphere{2.5}), Contains("sphere { 0, 2.5 "));
  CHECK_THAT(exported_shape(plane_y(-1)), Contains("plane { y, -1 "));
  scene::Plane slanted;
  slanted.normal = Vec3{1, 2, 3};
  slanted.offset = 4;
  CHECK_THAT(exported_shape(slanted), Contains("plane { <1, 2, 3>, 4 "));
  scene::Cylinder c;
  CHECK_THAT(exported_shape(c), Contains("cylinder { <0, -0.5, 0>, <0, 0.5, 0>, 1 "));
  c.axis = Vec3{0, 0, 3};
  c.height = 4;
  c.open = true;
  CHECK_THAT(exported_shape(c), Contains("cylinder { <0, 0, -2>, <0, 0, 2>, 1 open "));
  c.infinite = true;
  // x² + y² − 1 = 0
  CHECK_THAT(exported_shape(c), Contains("quadric { <1, 1, 0>, <0, 0, 0>, <0, 0, 0>, -1 "));
  scene::Cone cone;
  CHECK_THAT(exported_shape(cone), Contains("cone { <0, 0, 0>, 1, <0, 1, 0>, 0 "));
  cone.top_radius = 1;
  CHECK_THAT(exported_shape(cone), Contains("cylinder { <0, 0, 0>, <0, 1, 0>, 1 "));
  scene::Box box;
  CHECK_THAT(exported_shape(box), Contains("box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> "));
  box.from = Vec3{1, 5, 3};
  box.to = Vec3{4, 2, 6};
  CHECK_THAT(exported_shape(box), Contains("box { <1, 2, 3>, <4, 5, 6> "));
  CHECK_THAT(exported_shape(scene::Disc{{0, 0, 1}, 2, 0.5}), Contains("disc { 0, <0, 0, 1>, 2, 0.5 "));
  scene::Triangle t;
  CHECK_THAT(exported_shape(t), Contains(" triangle { <-0.5, 0, 0>, <0.5, 0, 0>, <0, 1, 0> ") ||
                                    Contains("\ntriangle { <-0.5, 0, 0>, <0.5, 0, 0>, <0, 1, 0> "));
  t.normals = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  CHECK_THAT(exported_shape(t),
             Contains("smooth_triangle { <-0.5, 0, 0>, <0, 0, 1>, <0.5, 0, 0>, <1, 0, 1>, <0, 1, 0>, <0, 1, 1> "));
  CHECK_THAT(exported_shape(scene::Polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
             Contains("polygon { 4, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <0, 0, 0> "));
  scene::Quad quad;
  CHECK_THAT(exported_shape(quad),
             Contains("polygon { 5, <-0.5, 0, 0.5>, <0.5, 0, 0.5>, <0.5, 0, -0.5>, <-0.5, 0, -0.5>, <-0.5, 0, 0.5> "));
  quad.corner = Vec3{1, 1, 1}, quad.edge_u = Vec3{1, 0, 0}, quad.edge_v = Vec3{0, 2, 0};
  CHECK_THAT(exported_shape(quad), Contains("polygon { 5, <1, 1, 1>, <2, 1, 1>, <2, 3, 1>, <1, 3, 1>, <1, 1, 1> "));
}

TEST_CASE("export: what a medium absorbs is POV-Ray's fading, with a power that makes it exponential") {
  WrittenScene b;
  // e^(−(1 − fade_color)·t/fade_distance) is ½, ¼ and 1 after 4: the darkest channel is at 1/e after 4/ln 4 = 2.885….
  b.place(scene::Sphere{1}, b.material({.refract = 1.0, .ior = 1.5, .absorb = scene::Absorb{{0.5, 0.25, 1}, 4}}));
  CHECK_THAT(exported(b), Contains("interior { ior 1.5 fade_power 1001 fade_distance 2.88539") &&
                              Contains("fade_color rgb <0.5, 0, 1>"));
}

TEST_CASE("export: metal and roughness are what they imply, a thin sheet bends nothing") {
  WrittenScene b;
  b.place(scene::Sphere{1}, b.material({.specular = 0.5, .roughness = 0.5, .metal = scene::Metal{grey(2), grey(1)}}));
  // ((2 − 1)² + 1)/((2 + 1)² + 1); 1/(2/0.5⁴ − 2)
  CHECK_THAT(
      exported(b),
      Contains("specular 0.5 roughness 0.03333333333333333 metallic 1 reflection { rgb <0.2, 0.2, 0.2> metallic 1 }"));
  b.place(scene::Sphere{1}, b.material({.refract = 0.5, .ior = 1.5, .thin = true}));
  CHECK_THAT(exported(b), Contains("interior { ior 1 }"));
}

TEST_CASE("export: every term of a material") {
  WrittenScene b;
  const auto m = b.material({.color = Color{0.1, 0.2, 0.3},
                             .ambient = grey(0.5),
                             .diffuse = grey(0.6),
                             .emission = grey(0.7),
                             .specular = 0.4,
                             .shininess = 50.0,
                             .highlight = scene::Highlight::blinn,
                             .metallic = 0.8,
                             .reflect = Color{0.9, 0.8, 0.7},
                             .refract = 0.25,
                             .ior = 1.5,
                             .fresnel = false});
  b.place(scene::Sphere{1}, m);
  const std::string text = exported(b);
  CHECK_THAT(text, Contains("pigment { rgbf <0.1, 0.2, 0.3, 0.25> }"));
  CHECK_THAT(text, Contains("finish { ambient 0.5 diffuse 0.6 emission 0.7 specular 0.4 roughness 0.02 metallic 0.8 "
                            "reflection { rgb <0.9, 0.8, 0.7> metallic 0.8 } }"));
  CHECK_THAT(text, Contains("sphere { 0, 1 texture { material_1 } interior { ior 1.5 } }"));
  b.scene.materials[0].fresnel = true;
  b.scene.materials[0].highlight = scene::Highlight::phong;
  CHECK_THAT(exported(b), Contains("phong 0.4 phong_size 50 metallic 0.8 reflection { rgb 0, rgb <0.9, 0.8, 0.7> "
                                   "fresnel on metallic 0.8 } conserve_energy }"));
}

TEST_CASE("export: a pattern of numbers becomes a pattern of textures, and what stands inside is moved back") {
  WrittenScene b;
  const auto dots = b.pattern({scene::Checker{grey(1), grey(0)}, {{2, 2, 2}, {}, {}, {}}});
  const auto cells = b.pattern({scene::Checker{white, black}, {{4, 4, 4}, {}, {}, {}}});
  scene::Material m;
  m.color = cells;
  m.emission = dots;
  b.place(scene::Sphere{1}, b.material(m));
  const std::string text = exported(b);
  CHECK(count(text, "checker") == 3);
  CHECK_THAT(text, Contains("emission 1 }") && Contains("emission 0 }") && Contains("scale 2"));
  // Within a pattern of cells of 2, cells of 4 are twice as large.
  CHECK(count(text, "matrix <2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0>") == 2);
}

TEST_CASE("export: lights, their fades and placements") {
  WrittenScene b;
  b.light(scene::PointLight{{white, 2, true}, {1, 2, 3}, {scene::Fade::Law::quadratic, 4}, {}});
  CHECK_THAT(exported(b), Contains("light_source { <1, 2, 3>, rgb <1, 1, 1> fade_distance 4 fade_power 2 }"));
  b.scene.lights[0].source = scene::PointLight{{white, 2, false}, {1, 2, 3}, {scene::Fade::Law::linear, 4}, {}};
  b.scene.lights[0].chain = {scene::MoveStep{{0, 1, 0}}};
  b.scene.lights[0].enclosing = {{{1, 1, 1}, {0, 90, 0}, {}, {}}};
  CHECK_THAT(exported(b),
             Contains("rgb <1, 1, 1> fade_distance 4 fade_power 1 shadowless translate <0, 1, 0> rotate <0, 90, 0> }"));
  b.scene.lights[0].source = scene::SunLight{{white, 1, true}, {0, -2, 0}, {}};
  CHECK_THAT(exported(b), Contains("light_source { <0, 100000000, 0>, rgb <1, 1, 1> parallel point_at 0 }"));
  b.scene.lights[0] = {scene::SpotLight{{white, 1, true}, {0, 5, 0}, {}, 30, 50, {}, {}}, {}, {}, scene::no_name, {}};
  CHECK_THAT(
      exported(b),
      Contains(
          "light_source { <0, 5, 0>, rgb <1, 1, 1> spotlight point_at <0, 0, 0> radius 15 falloff 25 tightness 0 }"));
}

TEST_CASE("export: groups keep every surface, solids their outer boundary, and shared groups are written once") {
  WrittenScene b;
  scene::Group group{{b.object(scene::Sphere{1}), b.object(scene::Sphere{2})}};
  b.place(group);
  CHECK_THAT(exported(b), Contains("union {"));
  b.scene.objects.push_back(b.scene.objects.front());
  b.scene.objects.back().at = {3, 0, 0};
  const std::string text = exported(b);
  CHECK(count(text, "sphere {") == 2);
  CHECK_THAT(text, Contains("#declare shared_1 = union {") &&
                       Contains("object { shared_1 texture { material_default } translate <3, 0, 0> }"));
  CHECK(count(exported(b, Pass::ids), "sphere {") == 4);

  WrittenScene solid;
  const scene::Object sphere = solid.object(scene::Sphere{1});
  const scene::Object members =
      solid.object(scene::Group{{solid.object(scene::Box{}), solid.object(scene::Sphere{2})}});
  solid.add({.shape = solid.combination(scene::Combination::Operation::subtract, {sphere, members})});
  CHECK_THAT(exported(solid), Contains("difference {") && Contains("merge {") && !Contains("union {"));
}

TEST_CASE("export: what is not visible is absent, what casts no shadow says so") {
  WrittenScene b;
  b.place(scene::Sphere{1}).is_visible = false;
  b.place(scene::Sphere{2}).casts_shadow = false;
  const std::string text = exported(b);
  CHECK_THAT(text, !Contains("sphere { 0, 1 ") && Contains("sphere { 0, 2 texture { material_default } no_shadow }"));
}

TEST_CASE("export: comments name what stands there and where it was written; without them the text is the same") {
  WrittenScene b;
  b.scene.names = {"ball\nof glass"};
  b.place(scene::Sphere{1}).name = scene::NameId{0};
  const std::string text = export_povray(b.scene).text;
  CHECK_THAT(text, Contains("// ball of glass, test.rtl:1\n"));
  std::string bare;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; begin = end + 1, end = text.find('\n', begin)) {
    const std::string line = text.substr(begin, end - begin + 1);
    if (line.substr(line.find_first_not_of(' ')).rfind("//", 0) != 0) bare += line;
  }
  CHECK(bare == exported(b));
}

TEST_CASE("export: a finish or a transparency that is a pattern is a pattern of textures") {
  WrittenScene b;
  scene::Material m;
  m.refract = b.pattern({scene::Checker{grey(0.5), black}, {}});
  m.reflect = b.pattern({scene::Checker{Color{0.1, 0.2, 0.3}, black}, {{2, 2, 2}, {}, {}, {}}});
  m.ior = 1.5;
  b.place(scene::Sphere{1}, b.material(m));
  const std::string text = exported(b);
  CHECK(count(text, "checker") == 3); // one of the reflections, and in each of its textures one of the transparencies
  CHECK(count(text, "rgbf <1, 1, 1, 0.5>") == 2);
  CHECK(count(text, "reflection { rgb <0.1, 0.2, 0.3> }") == 2);
  CHECK_THAT(text, Contains("interior { ior 1.5 }"));
}

TEST_CASE("export: what POV-Ray cannot do is named with its place") {
  WrittenScene b;
  b.place(scene::Sphere{1});
  CHECK(export_povray(b.scene).inexact.empty());
  b.scene.max_depth = 300;
  scene::Material m;
  m.diffuse = Color{1, 0, 0};
  b.place(scene::Sphere{1}, b.material(m));
  const auto inexact = export_povray(b.scene).inexact;
  REQUIRE(inexact.size() == 2);
  CHECK(place_text(b.scene, inexact[0].origin) == "test.rtl:2");
  CHECK_THAT(inexact[0].message, Contains("diffuse"));
  CHECK_THAT(inexact[1].message, Contains("255") && Contains("300"));
}
