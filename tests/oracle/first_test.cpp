#include "renderer/render.hpp"
#include "tests/scene_builder.hpp"
#include "tools/povray/report.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace rt;
using namespace rt::tests;
using namespace rt::tools::povray;

static void check_scene(const scene::Scene& s, const char* name) {
  RenderOptions o; o.threads = 2; o.layers = true;
  const Rendered ours = render(s, o);
  const Shots theirs = shoot(s);
  Report r; r.scene = name; r.description = &s; r.film = &ours.film; r.shots = &theirs; r.comparison = compare(s, ours.film, theirs);
  fmt::print("{}\n", report_text(r));
  CHECK(r.holds());
}

static scene::Material mat(Color c) { scene::Material m; m.color = c; m.specular = 0.3; return m; }

TEST_CASE("shapes") {
  SceneBuilder b;
  b.scene.background = {0.2, 0.3, 0.5};
  scene::Pattern fp; fp.b = Color{0.3,0.1,0.1};
  scene::Material fm; fm.color = b.pattern(fp);
  scene::Plane fl; fl.y = -1;
  b.place(fl, b.material(fm));
  const auto red = b.material(mat({0.9,0.2,0.1})), green = b.material(mat({0.1,0.8,0.2})), blue = b.material(mat({0.2,0.2,0.9}));
  scene::Placement t; t.scale = {1, 0.5, 1.3}; t.rotate = {10, 20, 30}; t.chain = {scene::ShearStep{0.3, 0, 0, 0.2, 0, 0, {}}, scene::MirrorStep{{1, 0.2, 0.1}, {0.2, 0, 0}}, scene::RotateAxisStep{{1, 2, 3}, 33, {0.1, 0.2, 0.3}}};
  const auto tt = b.turn(t);
  b.place(scene::Sphere{0.5}, red, {-2, 0, 0}).turn = tt;
  scene::Cylinder c; c.radius = 0.3; c.height = 1.2;
  b.place(c, green, {-1, 0, 0.5}).turn = tt;
  c.open = true; c.axis = Vec3{1, 0.3, 0.2};
  b.place(c, blue, {0, 0, 1});
  scene::Cone k; k.radius = 0.4; k.top_radius = 0.1;
  b.place(k, red, {1, 0, 0}).turn = tt;
  k.open = true; k.top_radius = 0.6;
  b.place(k, green, {2, -0.5, 0.5});
  b.place(scene::Box{}, blue, {0, 0.4, -1.5}).turn = tt;
  b.place(scene::Disc{{0.3, 1, 0.5}, 0.5, 0.2}, red, {0, 1.2, 0.3});
  scene::Triangle tr; b.place(tr, green, {-1.5, 0.7, 0}).turn = tt;
  tr.normals = {{-1, 0, 1}, {1, 0, 1}, {0, 1, 1}}; b.place(tr, blue, {1.2, 0.6, 0.7}).turn = tt;
  scene::Quad q; q.normal = Vec3{0.2, 0.5, 1}; q.size = 0.7; b.place(q, red, {-0.7, 1.5, 0}).turn = tt;
  b.place(scene::Polygon{{{0, 0, 0}, {1, 0, 0}, {0.4, 0.3, 0}, {0, 1, 0}}}, green, {0.8, 1.2, -0.5}).turn = tt;
  scene::Cylinder inf; inf.infinite = true; inf.radius = 0.2; inf.axis = Vec3{1, 0.1, 0.3};
  b.place(inf, blue, {0, 0, -4});
  b.light(scene::PointLight{{white, 0.8, true}, {4, 5, 3}, {}});
  b.light(scene::SunLight{{Color{0.4, 0.3, 0.2}, 1, true}, {-1, -2, -1.5}});
  b.light(scene::SpotLight{{Color{0.4, 0.9, 0.2}, 20, true}, {-3, 4, 2}, {0, 0, 0}, 20, 30, {scene::Fade::Law::inverse_square, 1}});
  check_scene(b.scene, "shapes");
}

TEST_CASE("glass and solids") {
  SceneBuilder b;
  b.scene.background = {0.2, 0.3, 0.5};
  scene::Pattern fp; fp.b = Color{0.3,0.1,0.1}; fp.placement.rotate = {0, 30, 0};
  scene::Pattern np; np.a = Color{0.1, 0.7, 0.3}; np.b = b.pattern(fp); np.placement.scale = {2, 2, 2};
  scene::Pattern ep; ep.a = grey(0.3); ep.b = grey(0); ep.placement.scale = {0.5, 0.5, 0.5};
  scene::Material fm; fm.color = b.pattern(np); fm.emission = b.pattern(ep);
  scene::Plane fl; fl.y = -1;
  b.place(fl, b.material(fm));
  scene::Material g; g.color = Color{0.9,0.95,0.9}; g.refract = 0.9; g.ior = 1.5; g.reflect = grey(0.8); g.fresnel = true; g.specular = 0.4; g.metallic = 0.5; g.diffuse = grey(0.3);
  const auto glass = b.material(g);
  const auto red = b.material(mat({0.9,0.2,0.1}));
  scene::Material w = g; w.ior = 1.3; w.fresnel = false; w.highlight = scene::Highlight::phong; const auto water = b.material(w);
  scene::Placement t; t.scale = {1, 0.8, 1.1}; t.rotate = {10, 20, 30};
  const auto tt = b.turn(t);
  scene::Combination d{scene::Combination::Operation::subtract, {b.object(scene::Box{}), b.object(scene::Sphere{0.6}, scene::no_material, {0.3, 0.3, 0.3})}};
  b.place(d, glass, {-1.6, 0, 0}).turn = tt;
  scene::Combination i{scene::Combination::Operation::intersect, {b.object(scene::Box{}, red), b.object(scene::Sphere{0.65})}};
  b.place(i, b.material(fm), {-0.4, 0, 1}).turn = tt;
  scene::Combination u{scene::Combination::Operation::unite, {b.object(scene::Sphere{0.5}), b.object(scene::Sphere{0.5}, scene::no_material, {0.5, 0.1, 0})}};
  b.place(u, glass, {0.7, 0, 0}).turn = tt;
  b.place(scene::Sphere{0.5}, glass, {2, 0, 0});
  b.place(scene::Sphere{0.5}, water, {2.3, 0.2, 0.3});
  b.place(scene::Sphere{0.3}, red, {2.3, 0.2, 0.3});
  scene::Group gr{{b.object(scene::Sphere{0.3}), b.object(scene::Cylinder{}, red)}};
  gr.members[1].turn = b.turn({{0.2, 0.4, 0.2}, {0, 0, 50}, {}, {}});
  auto& o = b.place(gr, glass, {0, 1.2, -0.5}); o.turn = tt;
  b.scene.objects.push_back(b.scene.objects.back()); b.scene.objects.back().at = {-1.2, 1.3, -0.3}; b.scene.objects.back().casts_shadow = false;
  b.scene.objects.push_back(b.scene.objects.back()); b.scene.objects.back().at = {-1, 1.4, -0.1}; b.scene.objects.back().material = water;
  b.light(scene::PointLight{{white, 0.8, true}, {4, 5, 3}, {}});
  b.light(scene::SunLight{{Color{0.4, 0.3, 0.2}, 1, true}, {-1, -2, -1.5}});
  check_scene(b.scene, "glass");
}


TEST_CASE("one") {
  for (int k = 0; k < 9; ++k) {
    SceneBuilder b;
    b.scene.background = {0.2, 0.3, 0.5};
    scene::Pattern fp; fp.b = Color{0.3,0.1,0.1}; fp.placement.rotate = {0, 30, 0};
    scene::Material fm; fm.color = b.pattern(fp);
    scene::Plane fl; fl.y = -1;
    b.place(fl, b.material(fm));
    scene::Material g; g.color = Color{0.9,0.95,0.9}; g.refract = 0.9; g.ior = 1.5; g.diffuse = grey(0.3);
    scene::Material w = g; w.ior = 1.3;
    if (k == 1) g.fresnel = true, g.reflect = grey(0.8);
    if (k == 2) g.fresnel = true, g.reflect = grey(0.8), g.metallic = 0.5;
    if (k == 3) w.reflect = grey(0.8);
    if (k == 4) w.reflect = g.reflect = grey(0.8), g.metallic = w.metallic = 0.5;
    if (k == 5) { w.reflect = g.reflect = grey(0.8), g.metallic = w.metallic = 0.5; g.fresnel = true; }
    if (k == 6) { w.reflect = g.reflect = grey(0.8), g.metallic = w.metallic = 0.5; w.fresnel = true; }
    if (k == 7) { w.reflect = g.reflect = grey(0.8), w.fresnel = g.fresnel = true; }
    b.place(scene::Sphere{1}, b.material(g), {0, 0, 0});
    b.place(scene::Sphere{1}, b.material(k == 8 ? g : w), {0.8, 0.3, 0.2});
    b.light(scene::PointLight{{white, 0.8, true}, {4, 5, 3}, {}});
    check_scene(b.scene, fmt::format("one {}", k).c_str());
  }
}
