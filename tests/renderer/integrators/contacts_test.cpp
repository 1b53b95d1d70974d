// Surfaces that touch, turned, scaled and moved about at random. Expectations are Snell's and Fresnel's laws for a pile
// of plates, and the same scenes with overlaps of 1e-7, where no two surfaces touch.

#include "renderer/integrators/contacts.hpp"
#include "renderer/math/random.hpp"
#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace rt;
using namespace rt::tests;

namespace {

const double pi = 3.14159265358979323846;
const Vec3 down{0, -1, 0};

// A placement of everything there is: turned in any way, moved by up to `reach` of its size, and scaled.
scene::Placement anywhere(SplitMix64& random, double scale, double reach = 3) {
  const auto angle = [&] { return random.between(-180, 180); };
  const auto move = [&] { return random.between(-reach, reach) * scale; };
  return {{scale, scale, scale}, {angle(), angle(), angle()}, {move(), move(), move()}, {}};
}

Ray carried(const scene::Placement& placement, const Vec3& origin, const Vec3& direction) {
  const Affine map = matrix(placement);
  return {map.point(origin), normalize(map.vector(direction))};
}

// All of the scene as one group that stands there.
void place(SceneBuilder& k, std::vector<scene::Object> things, const scene::Placement& placement) {
  scene::Placement turned = placement;
  scene::Object whole = k.group(std::move(things));
  whole.at = turned.at, turned.at = {};
  whole.transform = k.transform(turned);
  k.add(whole);
}

template <class T>
void shuffle(std::vector<T>& values, SplitMix64& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.bits() % i]);
}

// Follows the ray that is never mirrored, and counts what any ray meets in one place.
struct Way : NoRecorder {
  Ray last{};
  Color weight = white;
  int bends = 0, surfaces = 0;
  std::size_t most_touching = 0;

  void begin_ray(RayKind kind, const Ray& ray, int, const Color& w) {
    open.push_back(kind == RayKind::camera || (kind == RayKind::refracted && open.back()));
    if (!open.back()) return;
    last = ray, weight = w;
    bends += kind == RayKind::refracted;
  }
  void end_ray(const Color&) { open.pop_back(); }
  void touching(const std::vector<MetSurface>& met) { most_touching = std::max(most_touching, met.size()); }
  void surface(const RayHit&, const Surface&, const MaterialValues&, const Vec3&) { surfaces += open.back(); }

private:
  std::vector<bool> open; // rays, by whether they are on the way
};

Way follow(const scene::Builder& k, const Ray& ray) {
  const CompiledScene compiled(k.scene, 1);
  Way way;
  Whitted<OwnRules, Way>(compiled, way).radiance(ray, compiled.around(ray.origin));
  return way;
}

Color seen(const scene::Builder& k, const Ray& ray) {
  return Asked(k).radiance(ray.origin, ray.direction);
}

// Of unpolarised light, by Fresnel's sines and tangents (Born and Wolf, Principles of Optics, 1.5.2).
double reflectance(double ior, double ior_behind, double sine) {
  const double i = std::asin(sine), t = std::asin(sine * ior / ior_behind);
  if (i < 1e-6) return std::pow((ior_behind - ior) / (ior_behind + ior), 2);
  const double s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
  return (s * s + p * p) / 2;
}

scene::Material clear_material(double ior, bool fresnel) {
  scene::Material m;
  m.ambient = m.diffuse = grey(0), m.refract = 1.0, m.ior = ior;
  if (fresnel) m.fresnel = true, m.reflect = white;
  return m;
}

struct Plate {
  double ior, thickness;
};

// One upon the other, the first on top at y = 0, each reaching `overlap` into the one below it.
std::vector<scene::Object> pile(SceneBuilder& k, const std::vector<Plate>& plates, bool fresnel, double overlap = 0) {
  std::vector<scene::Object> things;
  double y = 0;
  for (const Plate& p : plates) {
    const bool is_last = &p == &plates.back();
    const auto material = k.material(clear_material(p.ior, fresnel));
    things.push_back(k.box({-40, y - p.thickness - (is_last ? 0 : overlap), -40}, {40, y, 40}).with(material));
    y -= p.thickness;
  }
  return things;
}

} // namespace

TEST_CASE("contact: a clear block that stands on a floor shows the floor everywhere") {
  SplitMix64 random(1301);
  for (const double scale : {1.0, 1e-9, 1e9, 1e-3, 137.0}) {
    for (int i = 0; i < 40; ++i) {
      SceneBuilder k;
      const auto glass = k.clear(1.5), floor = k.glow(0.5);
      std::vector<scene::Object> things{k.box({-9, 0, -9}, {9, 1, 9}).with(glass), k.plane({0, 1, 0}, 0).with(floor)};
      shuffle(things, random);
      const scene::Placement placement = anywhere(random, scale);
      place(k, things, placement);
      Asked asked(k);
      for (int n = 0; n < 50; ++n) {
        const Vec3 from{random.between(-4, 4), 4, random.between(-4, 4)};
        const Vec3 to{random.between(-4, 4), 1, random.between(-4, 4)};
        const Ray ray = carried(placement, from, to - from);
        REQUIRE(asked.radiance(ray.origin, ray.direction) == grey(0.5));
      }
    }
  }
}

TEST_CASE("contact: the floor is seen through a block over it however small the gap") {
  SplitMix64 random(1312);
  for (int i = 0; i < 300; ++i) {
    SceneBuilder k;
    const double gap = std::pow(10, random.between(-18, -8)) * (i % 3 == 0 ? -1 : 1);
    const scene::Placement placement = anywhere(random, 1);
    std::vector<scene::Object> things{k.box({-9, gap, -9}, {9, 1, 9}).with(k.clear(1.5)),
                                      k.plane({0, 1, 0}, 0).with(k.glow(0.5))};
    shuffle(things, random);
    place(k, things, placement);
    Asked asked(k);
    for (int n = 0; n < 20; ++n) {
      const Ray ray = carried(placement, {random.between(-4, 4), 4, 0}, {random.between(-0.5, 0.5), -1, 0.2});
      REQUIRE(asked.radiance(ray.origin, ray.direction) == grey(0.5));
    }
  }
}

TEST_CASE(
    "contact: a floor that is lit through the block that stands on it is filtered by the block's other side alone") {
  SplitMix64 random(1302);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    scene::Material half = clear_material(1, false);
    half.refract = 0.5;
    scene::Material white_matte;
    white_matte.diffuse = grey(1);
    std::vector<scene::Object> things{k.box({-9, 0, -9}, {9, 1, 9}).with(k.material(half)),
                                      k.plane({0, 1, 0}, 0).with(k.material(white_matte))};
    shuffle(things, random);
    const scene::Placement placement = anywhere(random, 1);
    place(k, things, placement);
    k.sun(matrix(placement).vector(down));
    const Ray ray = carried(placement, {0.3, 4, 0.2}, {0.1, -1, 0.2});
    // The block's top lets half of the light in and half of it out; its own diffuse colour is 0.
    CHECK(seen(k, ray).r == Approx(0.25).epsilon(1e-9));
  }
}

TEST_CASE("contact: of opaque surfaces in one place the one declared first is seen") {
  SplitMix64 random(1303);
  for (int i = 0; i < 100; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    place(k, {k.box({-1, -1, -1}, {1, 0, 1}).with(k.glow(0.25)), k.plane({0, 1, 0}, 0).with(k.glow(0.75))}, placement);
    CHECK(seen(k, carried(placement, {random.between(-0.9, 0.9), 4, random.between(-0.9, 0.9)}, down)) == grey(0.25));
  }
}

TEST_CASE(
    "contact: light through a plate on water leaves where Snell's law says, in whatever order they are declared") {
  SplitMix64 random(1304);
  const double sine = std::sqrt(0.5);
  const auto shift = [&](double ior, double thickness) { return thickness * std::tan(std::asin(sine / ior)); };
  for (const double scale : {1.0, 1e-9, 1e9}) {
    for (int i = 0; i < 50; ++i) {
      SceneBuilder k;
      auto things = pile(k, {{1.52, 1}, {1.333, 2}}, false);
      if (i % 2 == 1) std::swap(things[0], things[1]);
      const scene::Placement placement = anywhere(random, scale);
      place(k, things, placement);
      const Way way = follow(k, carried(placement, {-3, 3, 0}, {1, -1, 0}));
      const Affine back = inverse(matrix(placement)).value();
      const Vec3 end = back.point(way.last.origin), direction = normalize(back.vector(way.last.direction));
      CHECK(way.bends == 3);
      CHECK(length(end - Vec3{shift(1.52, 1) + shift(1.333, 2), -3, 0}) < 1e-12);
      CHECK(length(direction - Vec3{sine, -sine, 0}) < 1e-12);
    }
  }
}

TEST_CASE("contact: piles of touching plates bend and mirror at one boundary between each and the next") {
  SplitMix64 random(1305);
  for (int i = 0; i < 150; ++i) {
    std::vector<Plate> plates(2 + random.bits() % 4);
    for (Plate& p : plates) p = {random.between(1.1, 2.4), random.between(0.1, 2)};
    SceneBuilder k;
    k.scene.max_depth = 12;
    auto things = pile(k, plates, true);
    shuffle(things, random);
    const scene::Placement placement = anywhere(random, std::pow(10, random.between(-6, 6)));
    place(k, things, placement);

    const double sine = random.between(0, 0.95), tangent = sine / std::sqrt(1 - sine * sine);
    const Way way = follow(k, carried(placement, {-tangent, 1, 0}, {tangent, -1, 0}));
    double x = 0, y = 0, ior = 1, transmitted = 1;
    for (const Plate& p : plates) {
      transmitted *= 1 - reflectance(ior, p.ior, sine / ior);
      ior = p.ior;
      x += p.thickness * std::tan(std::asin(sine / ior)), y -= p.thickness;
    }
    transmitted *= 1 - reflectance(ior, 1, sine / ior);
    const Vec3 end = inverse(matrix(placement)).value().point(way.last.origin);
    REQUIRE(way.bends == static_cast<int>(plates.size()) + 1);
    REQUIRE(length(end - Vec3{x, y, 0}) < 1e-10);
    REQUIRE(way.weight.r == Approx(transmitted).epsilon(1e-9));
    REQUIRE(way.most_touching == 2);
  }
}

TEST_CASE("contact: beyond the critical angle of two media that touch all light is mirrored, whatever air would do") {
  // From glass to water at 65°: the critical angle is asin(1.333/1.52) = 61.3°; to air it would be 41.1°.
  for (const double degrees : {55.0, 65.0}) {
    SceneBuilder k;
    k.scene.background = grey(0.25);
    place(k, pile(k, {{1.52, 3}, {1.333, 3}}, false), {});
    k.add(k.plane({0, 1, 0}, -5).with(k.glow(1)));
    const double angle = degrees * pi / 180;
    const Way way = follow(k, {{0, -1, 0}, {std::sin(angle), -std::cos(angle), 0}});
    CHECK(way.bends == (degrees < 61.3 ? 1 : 0));
  }
}

TEST_CASE("contact: tinted, half mirrored plates that touch look as those that overlap by 1e-7") {
  SplitMix64 random(1306);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> shades(8);
    for (double& s : shades) s = random.between(0.3, 1);
    const std::vector<Plate> plates{{random.between(1.1, 1.8), 1}, {random.between(1.1, 1.8), 0.7}, {1.2, 0.5}};
    const scene::Placement placement = anywhere(random, 1, 1);
    const Ray ray = carried(placement, {0.3, 2, 0.1}, {random.between(-1, 1), -1, random.between(-1, 1)});
    Color colors[2];
    for (const double overlap : {0.0, 1e-7}) {
      SceneBuilder k;
      k.scene.ambient = grey(0.2), k.scene.background = {0.1, 0.3, 0.8}, k.scene.max_depth = 7;
      auto things = pile(k, plates, false, overlap);
      for (std::size_t n = 0; n < things.size(); ++n) {
        scene::Material m;
        m.color = Color{shades[n], shades[n + 1], shades[n + 2]}, m.refract = 0.5 + shades[n] / 3,
        m.ior = plates[n].ior;
        m.reflect = grey(shades[n + 3] / 4), m.specular = 0.4, m.shininess = 20.0;
        things[n].material = k.material(m);
      }
      shuffle(things, random);
      place(k, things, placement);
      k.sun(matrix(placement).vector({0.3, -1, 0.2}));
      colors[overlap > 0] = seen(k, ray);
    }
    const Color off = colors[0] - colors[1];
    REQUIRE(max_component(colors[0]) > 0.05);
    REQUIRE(std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) < 1e-6);
  }
}

TEST_CASE("contact: a glass that is filled with water is seen through as one where they overlap by 1e-7") {
  SplitMix64 random(1307);
  const Vec3 y{0, 1, 0};
  const auto cylinder = [&](SceneBuilder& k, double from, double to, double radius) {
    scene::Cylinder c;
    c.from = y * from, c.to = y * to, c.radius = radius;
    return k.shape(c);
  };
  int through_both = 0;
  for (int i = 0; i < 120; ++i) {
    const scene::Placement placement = anywhere(random, 1, 2);
    const double height = random.between(-1, 2.5), angle = random.between(-0.4, 0.4);
    const Ray ray =
        carried(placement, {random.between(-0.7, 0.7), height, 6}, {std::sin(angle) / 6, -height / 6 * 0.5, -1});
    Way ways[2];
    for (const double overlap : {0.0, 1e-7}) {
      SceneBuilder k;
      std::vector<scene::Object> things{
          k.subtract({cylinder(k, -0.2, 3, 1.1), cylinder(k, 0, 4, 1)}).with(k.clear(1.52)),
          cylinder(k, -overlap, 2, 1 + overlap).with(k.clear(1.333))};
      shuffle(things, random);
      place(k, things, placement);
      ways[overlap > 0] = follow(k, ray);
    }
    through_both += ways[0].most_touching == 2;
    CHECK(ways[0].bends == ways[1].bends);
    CHECK(length(ways[0].last.direction - ways[1].last.direction) < 2e-5);
  }
  CHECK(through_both > 60);
}

TEST_CASE("contact: ice in water, flush with its surface or in a hole of its shape, bends light as ice") {
  SplitMix64 random(1308);
  const double sine = 0.6, water = 1.333, ice = 1.31;
  for (int i = 0; i < 80; ++i) {
    for (const bool has_hole : {false, true}) {
      SceneBuilder k;
      const auto block = [&] { return k.box({-2, -1, -2}, {2, 0, 2}); };
      const auto pond = k.material(clear_material(water, true));
      scene::Object around = has_hole ? k.subtract({k.box({-20, -4, -20}, {20, 0, 20}), block()}).with(pond)
                                      : k.box({-20, -4, -20}, {20, 0, 20}).with(pond);
      std::vector<scene::Object> things{around, block().with(k.material(clear_material(ice, true)))};
      shuffle(things, random);
      const scene::Placement placement = anywhere(random, 1);
      place(k, things, placement);
      const Way way = follow(k, carried(placement, {-0.75, 1, 0}, {0.75, -1, 0}));
      const double x = std::tan(std::asin(sine / ice)) + 3 * std::tan(std::asin(sine / water));
      CHECK(length(inverse(matrix(placement)).value().point(way.last.origin) - Vec3{x, -4, 0}) < 1e-12);
      // One boundary at the top, from air to ice.
      const double top = 1 - reflectance(1, ice, sine), bottom = 1 - reflectance(water, 1, sine / water);
      if (has_hole)
        CHECK(way.weight.r == Approx(top * (1 - reflectance(ice, water, sine / ice)) * bottom).epsilon(1e-9));
      else
        CHECK(way.weight.r == Approx(top * bottom).epsilon(1e-9)); // nothing is mirrored within a solid: POV-Ray's rule
      CHECK(way.bends == 3);

      // And from below.
      const double up = 3 * std::tan(std::asin(sine / water)), far = up + std::tan(std::asin(sine / ice));
      const Way back = follow(k, carried(placement, {-0.75 - up, -5, 0}, {0.75, 1, 0}));
      CHECK(back.bends == 3);
      CHECK(length(inverse(matrix(placement)).value().point(back.last.origin) - Vec3{far - up, 0, 0}) < 1e-12);
    }
  }
}

TEST_CASE("contact: a ball that fills a hollow one to its wall leads to a boundary between the two") {
  SplitMix64 random(1309);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    std::vector<scene::Object> things{k.subtract({k.sphere(2), k.sphere(1)}).with(k.clear(1.5)),
                                      k.sphere(1).with(k.clear(1.2))};
    shuffle(things, random);
    const scene::Placement placement = anywhere(random, std::pow(10, random.between(-9, 9)));
    place(k, things, placement);
    const double impact = random.between(-0.9, 0.9);
    const Way way = follow(k, carried(placement, {impact, 5, 0}, down));
    // Bouguer: n·r·sin θ is the impact parameter everywhere. The ray turns by 2(i − t) at the outer sphere, and by
    // 2(i′ − t′) at the inner one.
    const double turn =
        2 * (std::asin(impact / 2) - std::asin(impact / 3) + std::asin(impact / 1.5) - std::asin(impact / 1.2));
    const Vec3 direction = normalize(inverse(matrix(placement)).value().vector(way.last.direction));
    REQUIRE(way.bends == 4);
    REQUIRE(length(direction - Vec3{-std::sin(turn), -std::cos(turn), 0}) < 1e-9);
  }
}

TEST_CASE("contact: parts of one clear solid that touch have no seam") {
  SplitMix64 random(1310);
  for (int i = 0; i < 100; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    place(k,
          {k.unite({k.box({-9, -1, -9}, {9, 0, 9}), k.box({-9, -2, -9}, {9, -1, 9})})
               .with(k.material(clear_material(1.5, true)))},
          placement);
    const Way way = follow(k, carried(placement, {0.1, 2, 0.3}, {0.4, -1, 0.2}));
    CHECK(way.bends == 2);
    CHECK(way.surfaces == 2);
  }
}

TEST_CASE(
    "contact: surfaces apart by more than rounding are met one by one, in order, though their distances are equal") {
  SplitMix64 random(1311);
  // From 1e5 away the distance along the ray is known to 1e-11 only; the order of the surfaces is known all the same.
  for (int i = 0; i < 200; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1, 0);
    place(k, {k.plane({0, 1, 0}, 0).with(k.glow(0.25)), k.plane({0, 1, 0}, 1e-12).with(k.glow(0.75))}, placement);
    CHECK(seen(k, carried(placement, {random.between(-1, 1), 1e5, random.between(-1, 1)}, {3e-6, -1, 2e-6})) ==
          grey(0.75));
  }
}
