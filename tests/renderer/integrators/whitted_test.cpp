#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

const double pi = 3.14159265358979323846;

// A ray straight down on the floor y = 0, at the origin.
Color floor_seen_from_above(const SceneBuilder& k) {
  return Asked(k).radiance({0, 5, 0}, {0, -1, 0});
}

// A light in the plane x–y, at `degrees` from the floor's normal and at `distance` from the origin.
Vec3 above_floor(double degrees, double distance) {
  return {distance * std::sin(degrees * pi / 180), distance * std::cos(degrees * pi / 180), 0};
}

scene::Material no_light() {
  scene::Material m;
  m.ambient = m.diffuse = grey(0);
  return m;
}

} // namespace

TEST_CASE("whitted: ambient and emission in the surface's colour, less what it lets by") {
  SceneBuilder k;
  k.scene.ambient = {0.1, 0.2, 0.4};
  scene::Material m;
  m.color = Color{0.5, 0.25, 1};
  m.ambient = grey(0.5), m.emission = grey(0.25), m.refract = 0.5;
  k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
  // ½ c (½ I_a + ¼); the background is black.
  const Color c = floor_seen_from_above(k);
  CHECK(c.r == Approx(0.5 * 0.5 * (0.05 + 0.25)));
  CHECK(c.g == Approx(0.5 * 0.25 * (0.1 + 0.25)));
  CHECK(c.b == Approx(0.5 * 1 * (0.2 + 0.25)));
}

TEST_CASE("whitted: Lambert's cosine, on either side of a surface") {
  SceneBuilder k;
  scene::Material m;
  m.color = Color{1, 0.5, 0.25};
  k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
  k.point_light(above_floor(60, 3), {1, 1, 2});
  const Color c = floor_seen_from_above(k);
  CHECK(c.r == Approx(0.8 * 0.5));
  CHECK(c.g == Approx(0.8 * 0.5 * 0.5));
  CHECK(c.b == Approx(0.8 * 0.5 * 0.25 * 2));
  // From below the light is on the other side.
  CHECK(Asked(k).radiance({0, -5, 0}, {0, 1, 0}) == black);
  k.point_light({0, -4, 0});
  CHECK(Asked(k).radiance({0, -5, 0}, {0, 1, 0}).r == Approx(0.8));
}

TEST_CASE(
    "whitted: Blinn's highlight is a power of the cosine to the half-way vector, Phong's of that to the mirrored one") {
  scene::Material m = no_light();
  m.color = Color{0.5, 0.5, 0.5};
  m.specular = 0.75, m.shininess = 10.0;
  // The viewer looks along the normal, the light is at 60°: h is at 30°, and the mirrored light at 60° from the viewer.
  for (const auto& [form, cosine] :
       {std::pair{scene::Highlight::blinn, std::sqrt(3) / 2}, {scene::Highlight::phong, 0.5}}) {
    m.highlight = form;
    for (const double refract : {0.0, 0.5}) { // it does not matter how much the surface lets by
      m.refract = refract;
      SceneBuilder k;
      k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
      k.point_light(above_floor(60, 3));
      CHECK(floor_seen_from_above(k).r == Approx(0.75 * std::pow(cosine, 10)).epsilon(1e-13));
    }
  }
}

TEST_CASE("whitted: a metal's highlight takes its colour, less so towards grazing angles") {
  scene::Material m = no_light();
  m.color = Color{1, 0.5, 0};
  m.specular = 1.0, m.shininess = 1.0, m.metallic = 0.5;
  SceneBuilder k;
  k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
  k.point_light(above_floor(60, 3));
  // Φ(60°) = 0.059270 by the formula of POV-Ray's manual, x = ⅔.
  const double phi = 0.0592701, highlight = std::sqrt(3) / 2;
  const Color c = floor_seen_from_above(k);
  CHECK(c.r == Approx(highlight));
  CHECK(c.g == Approx(highlight * (1 - 0.5 * (1 - phi) * 0.5)).epsilon(1e-7));
  CHECK(c.b == Approx(highlight * (1 - 0.5 * (1 - phi) * 1)).epsilon(1e-7));
}

TEST_CASE("whitted: lights fade by their law") {
  using Law = scene::Fade::Law;
  for (const auto& [law, expected] : {std::pair{Law::none, 1.0},
                                      {Law::linear, 1.0 / 3},
                                      {Law::quadratic, 1.0 / 5},
                                      {Law::inverse_square, 1.0 / 16}}) {
    SceneBuilder k;
    k.add(k.plane({0, 1, 0}, 0));
    scene::PointLight light;
    light.at = {0, 4, 0}, light.fade = {law, 2};
    k.add(light);
    CHECK(floor_seen_from_above(k).r == Approx(0.8 * expected));
    scene::SpotLight spot;
    spot.at = {0, 4, 0}, spot.fade = {law, 2}, spot.intensity = 3;
    k.add(spot);
    CHECK(floor_seen_from_above(k).r == Approx(0.8 * 4 * expected));
  }
}

TEST_CASE("whitted: a sun shines the same everywhere, from beyond everything") {
  SceneBuilder k;
  k.add(k.plane({0, 1, 0}, 0));
  k.sun({3, -4, 0}, {1, 0.5, 0});
  CHECK(floor_seen_from_above(k).r == Approx(0.8 * 0.8));
  CHECK(floor_seen_from_above(k).g == Approx(0.8 * 0.8 * 0.5));
  k.add(k.sphere(10).at({-3e6, 4e6, 0}));
  CHECK(floor_seen_from_above(k) == black);
}

TEST_CASE("whitted: a spot is full within its angle, none beyond its falloff, a smoothstep between") {
  // Half angles 20° and 40°; at 30°: q = (cos 30° − cos 40°) / (cos 20° − cos 40°), (3 − 2q) q² = 0.612781.
  for (const auto& [degrees, expected] :
       {std::pair{0.0, 1.0}, {19.99, 1.0}, {30.0, 0.6127812}, {40.01, 0.0}, {80.0, 0.0}}) {
    SceneBuilder k;
    k.add(k.plane({0, 1, 0}, 0));
    scene::SpotLight spot;
    spot.at = above_floor(0, 5);
    spot.look_at = spot.at + Vec3{-std::sin(degrees * pi / 180), -std::cos(degrees * pi / 180), 0};
    spot.angle = 40, spot.falloff = 80;
    k.add(spot);
    CHECK(floor_seen_from_above(k).r == Approx(0.8 * expected).epsilon(1e-6));
  }
  for (const auto& [degrees, expected] : {std::pair{19.99, 1.0}, {20.01, 0.0}}) { // without falloff the edge is hard
    SceneBuilder k;
    k.add(k.plane({0, 1, 0}, 0));
    scene::SpotLight spot;
    spot.at = above_floor(degrees, 5);
    spot.look_at = spot.at + Vec3{0, -1, 0};
    spot.angle = 40;
    k.add(spot);
    CHECK(floor_seen_from_above(k).r == Approx(0.8 * std::cos(degrees * pi / 180) * expected));
  }
}

TEST_CASE("whitted: a spot of which nothing is said lights what lies below it, at the origin") {
  SceneBuilder k;
  k.add(k.plane({0, 1, 0}, 0));
  k.add(scene::SpotLight{});
  CHECK(floor_seen_from_above(k).r == Approx(0.8)); // straight down, without fading
}

TEST_CASE("whitted: lights move with the composites they stand in") {
  SceneBuilder k;
  k.add(k.plane({0, 1, 0}, 0));
  scene::SunLight sun;
  sun.direction = {-1, 0, 0};
  scene::Placement turned;
  turned.rotate = {0, 0, 30};
  k.add(sun).enclosing = {turned};
  // −x turned by 30° about z points 30° downwards: n·l = sin 30°.
  CHECK(floor_seen_from_above(k).r == Approx(0.8 * 0.5));
}

TEST_CASE("whitted: a light without shadows passes everything and makes no highlight") {
  SceneBuilder k;
  scene::Material m;
  m.specular = 1.0;
  k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
  k.add(k.sphere(0.5).at({3, 3, 0}));
  scene::PointLight light;
  light.at = {4, 4, 0};
  k.add(light);
  CHECK(floor_seen_from_above(k) == black);
  light.shadows = false;
  k.add(light);
  CHECK(floor_seen_from_above(k).r == Approx(0.8 * std::sqrt(0.5)));
}

TEST_CASE("whitted: a lamp within a surface shines, one behind it does not") {
  for (const auto& [height, expected] : {std::pair{4.0, 0.8}, {4.0000001, 0.0}, {3.9999999, 0.8}}) {
    SceneBuilder k;
    k.add(k.plane({0, 1, 0}, 0));
    k.add(k.plane({0, -1, 0}, -4)); // a ceiling at y = 4
    k.point_light({0, height, 0});
    CHECK(Asked(k).radiance({0, 2, 0}, {0, -1, 0}).r == Approx(expected));
  }
}

TEST_CASE("whitted: coloured glass filters light at each surface, and light goes straight on") {
  const Color c{0.5, 0.25, 1};
  scene::Material glass = no_light();
  glass.color = c, glass.refract = 0.8, glass.ior = 1.5;
  for (int times = 1; times <= 4; ++times) {
    SceneBuilder k;
    k.add(k.plane({0, 1, 0}, 0));
    const auto material = k.material(glass);
    // Spheres are crossed twice, a disc once.
    for (int i = 0; i < times / 2; ++i) k.add(k.sphere(0.25).at({0.75 * (2 + i), 2.0 + i, 0}).with(material));
    if (times % 2 == 1) k.add(k.shape(scene::Disc{}).at({3.75, 5, 0}).with(material));
    k.point_light({7.5, 10, 0}); // n·l = 0.8
    const Color got = floor_seen_from_above(k);
    CHECK(got.r == Approx(0.8 * 0.8 * std::pow(0.8 * c.r, times)));
    CHECK(got.g == Approx(0.8 * 0.8 * std::pow(0.8 * c.g, times)));
    CHECK(got.b == Approx(0.8 * 0.8 * std::pow(0.8 * c.b, times)));
  }
}

TEST_CASE("whitted: something opaque among the glass blocks all light, what casts no shadow none") {
  SceneBuilder k;
  const auto glass = k.clear(1.5);
  k.add(k.plane({0, 1, 0}, 0));
  k.add(k.sphere(0.25).at({3, 3, 0}).with(glass));
  k.add(k.sphere(0.25).at({1, 1, 0}).without_shadow());
  k.add(k.group({k.sphere(0.25).at({5, 5, 0})}).without_shadow());
  k.point_light({6, 6, 0});
  CHECK(floor_seen_from_above(k).r == Approx(0.8 * std::sqrt(0.5)));
  k.add(k.sphere(0.25).at({2, 2, 0}));
  CHECK(floor_seen_from_above(k) == black);
}

TEST_CASE("whitted: checker cells, with negative coordinates and a floor that lies between cells") {
  const Color a{1, 0, 0}, b{0, 0, 1};
  SceneBuilder k;
  scene::Material m = no_light();
  m.color = k.checker(a, b), m.emission = grey(1);
  k.add(k.plane({0, 1, 0}, -2).with(k.material(m)));
  Asked asked(k);
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      // At y = −2 the cell is that above the floor, −2: even.
      const Color expected = (i + j - 2) % 2 == 0 ? a : b;
      CHECK(asked.radiance({i + 0.5, 3, j + 0.5}, {0, -1, 0}) == expected);
      CHECK(asked.radiance({i + 0.01, 3, j + 0.99}, {0, -1, 0}) == expected);
      CHECK(asked.radiance({1.0 * i, 3, 1.0 * j}, {0, -1, 0}) == expected); // a whole number belongs to the cell above
    }
}

TEST_CASE("whitted: a pattern moves with the object that writes it and has a placement of its own") {
  const Color a{1, 0, 0}, b{0, 0, 1};
  SceneBuilder k;
  scene::Material m = no_light();
  m.color = k.checker(a, b, {.scale = {2, 2, 2}, .rotate = {}, .at = {0.5, 0, 0}, .chain = {}}), m.emission = grey(1);
  k.add(k.box({-10, -1, -10}, {10, -0.5, 10}).with(k.material(m)).at({100, 0, 0}));
  Asked asked(k);
  // Cells of 2, beginning at 100.5 along x; along y the cell from −2 to 0, which is odd.
  CHECK(asked.radiance({100.6, 3, 0.5}, {0, -1, 0}) == b);
  CHECK(asked.radiance({102.4, 3, 0.5}, {0, -1, 0}) == b);
  CHECK(asked.radiance({102.6, 3, 0.5}, {0, -1, 0}) == a);
  CHECK(asked.radiance({100.4, 3, 0.5}, {0, -1, 0}) == a);
}

TEST_CASE("whitted: a pane that is clear by a pattern lets light by there, and blocks it elsewhere") {
  SceneBuilder k;
  scene::Material pane = no_light();
  pane.color = Color{1, 0.5, 0.25}, pane.refract = k.checker(grey(1), grey(0));
  k.add(k.plane({0, 1, 0}, 0));
  k.add(k.box({-4, 1.1, -4}, {4, 1.2, 4}).with(k.material(pane)));
  k.sun({0, -1, 0});
  Asked asked(k);
  const auto floor_at = [&](double x) { return asked.radiance({x, 0.5, 0.5}, {0, -1, 0}); };
  // A clear cell is crossed twice, each time in the pane's colour.
  CHECK(floor_at(1.5) == Color{0.8, 0.8 * 0.25, 0.8 * 0.0625});
  CHECK(floor_at(0.5) == black);
  // The eye sees through the same cells: of the floor's light what the pane lets by once more.
  CHECK(asked.radiance({1.5, 3, 0.5}, {0, -1, 0}) == Color{0.8, 0.8 * 0.0625, 0.8 * 0.00390625});
  CHECK(asked.radiance({0.5, 3, 0.5}, {0, -1, 0}) == black);
}

TEST_CASE("whitted: what a patterned pane lets by does not depend on what its mirror meets before") {
  SceneBuilder k;
  scene::Material pane = no_light(), ceiling = no_light();
  pane.refract = k.checker(grey(1), grey(0)), pane.reflect = grey(0.5);
  ceiling.color = k.checker(black, black);
  k.add(k.plane({0, 1, 0}, 0).with(k.material(pane)));
  k.add(k.plane({0, 1, 0}, -2).with(k.glow(0.25)));
  k.add(k.plane({0, 1, 0}, 3).with(k.material(ceiling)));
  Asked asked(k);
  CHECK(asked.radiance({0.5, 1, 0.5}, {0, -1, 0}) == grey(0.25)); // and half of the black ceiling
  CHECK(asked.radiance({1.5, 1, 0.5}, {0, -1, 0}) == black);
}

TEST_CASE("whitted: highlights and mirrors that come and go by a pattern") {
  SceneBuilder shiny, mirror;
  scene::Material m = no_light();
  m.specular = shiny.checker(grey(0.5), grey(0)), m.shininess = shiny.checker(grey(8), grey(1));
  shiny.add(shiny.plane({0, 1, 0}, 0).with(shiny.material(m)));
  shiny.sun({0, -1, 0});
  Asked highlight(shiny);
  CHECK(highlight.radiance({0.5, 1, 0.5}, {0, -1, 0}) == grey(0.5)); // n·h is 1
  CHECK(highlight.radiance({1.5, 1, 0.5}, {0, -1, 0}) == black);

  m = no_light(), m.reflect = mirror.checker(Color{0.5, 1, 0}, black);
  mirror.add(mirror.plane({0, 1, 0}, 0).with(mirror.material(m)));
  mirror.scene.background = grey(0.25);
  Asked mirrored(mirror);
  CHECK(mirrored.radiance({0.5, 1, 0.5}, {0, -1, 0}) == Color{0.125, 0.25, 0});
  CHECK(mirrored.radiance({1.5, 1, 0.5}, {0, -1, 0}) == black);
}

TEST_CASE("whitted: a triangle with normals of its own is shaded by them") {
  SceneBuilder k;
  scene::Triangle t;
  t.points = {Vec3{-1, 0, 1}, Vec3{1, 0, 1}, Vec3{0, 0, -1}};
  t.normals = {Vec3{-0.6, 0.8, 0}, Vec3{0.6, 0.8, 0}, Vec3{0, 1, 0}};
  k.add(k.shape(t));
  k.sun({0, -1, 0});
  Asked asked(k);
  // Half-way between the first two corners the normals' x cancel.
  CHECK(asked.radiance({0, 5, 0.999999}, {0, -1, 0}).r == Approx(0.8).epsilon(1e-5));
  // Near the first corner n·l is 0.8.
  CHECK(asked.radiance({-0.999999, 5, 0.9999995}, {0, -1, 0}).r == Approx(0.8 * 0.8).epsilon(1e-5));
  // In the middle of the left edge: (−0.3, 0.9, 0) normalised.
  CHECK(asked.radiance({-0.4999999, 5, 0}, {0, -1, 0}).r == Approx(0.8 * 0.9 / std::sqrt(0.9)).epsilon(1e-5));
}
