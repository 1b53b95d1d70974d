#include "tests/renderer/scattering/surfaces.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

constexpr double cosines[] = {0.1, 0.4, 1};

/// How many directions are looked at, and how far from white they may be: some of that is theirs, the rest the tables'.
struct Effort {
  int directions;
  double margin;
};
constexpr Effort quick{20'000, 5e-3}, thorough{1'000'000, 1e-3};

void check_white(const Surface& surface, const Effort& effort) {
  const TabulatedSurface tabulated(surface);
  for (const double cosine : cosines) {
    INFO(surface.name << ", roughness " << surface.values.roughness.value_or(-1) << ", cosine " << cosine);
    const Color shown = furnace(tabulated.bsdf(direction(cosine)), effort.directions);
    CHECK(shown.r == Approx(1).margin(effort.margin));
    CHECK(shown.b == Approx(1).margin(effort.margin));
  }
}

void check_all_white(const Effort& effort) {
  for (const double roughness : {0.0, 0.1, 0.4, 0.7, 1.0}) {
    check_white({"mirror", rough_mirror(roughness)}, effort);
    check_white({"glass", clear_glass(roughness)}, effort);
    check_white({"glass, inside", clear_glass(roughness), true}, effort);
    MaterialValues plain = clear_glass(roughness);
    plain.fresnel = false;
    plain.reflect = grey(0.3);
    plain.refract = 0.7;
    check_white({"glass without Fresnel", plain}, effort);
    check_white({"glass without Fresnel, inside", plain, true}, effort);
    check_white({"white under a mirror", plastic(roughness)}, effort);
    check_white({"white under a coat", coated(matte(), 0.4, roughness)}, effort);
  }
  check_white({"white under a highlight", glossy()}, effort);
}

} // namespace

TEST_CASE("furnace: a matte body shows its albedo") {
  MaterialValues v = matte();
  v.color = {0.3, 0.6, 0.9};
  const Color shown = furnace(TabulatedSurface({"", v}).bsdf(direction(0.4)), 100);
  CHECK(shown.r == Approx(0.3).epsilon(1e-12));
  CHECK(shown.b == Approx(0.9).epsilon(1e-12));
}

TEST_CASE("furnace: what loses nothing is invisible, mirror, glass from both sides or layers, however rough") {
  check_all_white(quick);
}

TEST_CASE("furnace: what loses nothing is invisible to a thousandth, looked at in a million directions", "[.slow]") {
  check_all_white(thorough);
}

TEST_CASE("furnace: no surface gives back more than it gets") {
  MaterialValues greedy = clear_glass(0.5);
  greedy.fresnel = false;
  greedy.refract = 0.5;
  greedy.color = grey(2);
  greedy.diffuse = white;
  greedy.reflect = grey(0.8);
  // Mirror 0.8, passed 1 and ground 1, divided by s, give back (0.8 + 1)/s + (1 − 0.8/s)/s = 1.
  CHECK(excess(greedy).g == Approx(1.4 + std::sqrt(1.4 * 1.4 - 0.8)));
  std::vector<Surface> all = surfaces();
  all.push_back({"greedy", greedy});
  all.push_back({"greedy, inside", greedy, true});
  all.push_back({"coated, glossy, on glass", coated(plain_glass(0.3), 0.7, 0.3)});
  for (const Surface& surface : all) {
    const TabulatedSurface tabulated(surface);
    for (const double cosine : cosines) {
      INFO(surface.name << ", cosine " << cosine);
      const Color shown = furnace(tabulated.bsdf(direction(cosine)), 20'000);
      CHECK(max_component(shown) < 1.004);
      CHECK(max_component(shown) > 0.2);
    }
  }
}

TEST_CASE("furnace: the albedo by which lobes are chosen is near what they show") {
  for (const Surface& surface : surfaces()) {
    const TabulatedSurface tabulated(surface);
    for (const double cosine : cosines) {
      INFO(surface.name << ", cosine " << cosine);
      const Bsdf bsdf = tabulated.bsdf(direction(cosine));
      CHECK(bsdf.albedo().g == Approx(furnace(bsdf, 5'000).g).margin(0.06));
    }
  }
}

TEST_CASE("furnace: library glass loses nothing to its mirror being written as 1 beside what it passes") {
  MaterialValues glass = clear_glass(0);
  glass.diffuse = grey(0.02);
  glass.refract = 0.96;
  glass.color = {0.94, 0.99, 0.96};
  CHECK(excess(glass) == white);
}
