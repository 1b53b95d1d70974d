#include "renderer/scattering/fresnel.hpp"
#include "renderer/scattering/quadrature.hpp"
#include "renderer/scattering/tables.hpp"
#include "renderer/shading/absorption.hpp"
#include "tests/renderer/scattering/surfaces.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

// Of a slab that one way through leaves `inner` of the light.
SheetTerms slab(double side, double inner) {
  return sheet_terms(grey(side), grey(inner));
}

} // namespace

TEST_CASE("fresnel: a clear slab of n = 1.5 mirrors 1/13 at the normal") {
  const double side = fresnel_reflectance(1, 1.5);
  CHECK(side == Approx(0.04).margin(1e-15)); // ((1.5 − 1)/(1.5 + 1))²
  CHECK(slab(side, 1).reflected.r == Approx(1.0 / 13).epsilon(1e-14));
  CHECK(slab(side, 1).transmitted.r == Approx(12.0 / 13).epsilon(1e-14));
}

TEST_CASE("fresnel: a clear slab at 60 degrees, both polarisations mixed at each side") {
  const double side = fresnel_reflectance(0.5, 1.5);
  CHECK(side == Approx(0.0891867).margin(5e-8));
  CHECK(slab(side, 1).transmitted.r == Approx(0.8362325).margin(5e-8)); // (1 − R)/(1 + R)
}

// The geometric series of inner reflections, summed by hand: e.g. T = 0.96²·a/(1 − 0.04²a²), a = e^(−σt).
TEST_CASE("fresnel: an absorbing slab") {
  const auto [depth, passed, mirrored] = GENERATE(table<double, double, double>(
      {{0.5, 0.5593079, 0.0535695}, {1, 0.3391111, 0.0449901}, {2, 0.1247287, 0.0406752}}));
  const double inner = Absorption{grey(depth / 3)}.left_after(3).g;
  CHECK(slab(0.04, inner).transmitted.g == Approx(passed).margin(5e-8));
  CHECK(slab(0.04, inner).reflected.g == Approx(mirrored).margin(5e-8));
}

TEST_CASE("fresnel: a thin sheet of colour 0.8, n = 1.5") {
  const TabulatedSurface thin({"", sheet(0)});
  const Bsdf bsdf = thin.bsdf({0, 0, 1});
  CHECK(bsdf.passed_straight().g == Approx(0.7380357).margin(5e-8));
  int mirrored = 0;
  for (double choice = 0.05; choice < 1; choice += 0.1) {
    const auto sample = bsdf.sample(0.3, 0.3, choice);
    REQUIRE(sample);
    CHECK(sample->is_perfect);
    const double light = sample->weight.g * sample->density;
    CHECK(light == Approx(sample->is_straight ? 0.7380357 : 0.0636171).margin(5e-8));
    CHECK(sample->wi == Vec3{0, 0, sample->is_straight ? -1.0 : 1.0});
    mirrored += sample->is_straight ? 0 : 1;
  }
  CHECK(mirrored == 1); // 0.0794 of what leaves it
}

TEST_CASE("fresnel: a slanting ray goes straight through a thin sheet") {
  const Vec3 wo = direction(0.4);
  const auto sample = TabulatedSurface({"", sheet(0)}).bsdf(wo).sample(0.3, 0.3, 0.9);
  REQUIRE(sample);
  CHECK(sample->wi == -wo);
}

// Computed from the closed form of Walsh (1926) and by quadrature.
TEST_CASE("fresnel: means over the hemisphere, from outside and inside") {
  const auto [n, outside, inside] = GENERATE(table<double, double, double>(
      {{1.333, 0.0664058, 0.4745906}, {1.5, 0.0917780, 0.5963458}, {2.417, 0.2121876, 0.8651442}}));
  CHECK(mean_fresnel_reflectance(n) == Approx(outside).margin(5e-8));
  CHECK(mean_fresnel_reflectance(1 / n) == Approx(inside).margin(5e-8));
  // The same without the identity that the renderer takes it from.
  const FresnelCurve curve{.kind = FresnelCurve::Kind::dielectric, .eta = 1 / n};
  const MirrorTables tables(RoughnessAxis::constant(0), curve);
  CHECK(tables.mean_reflectance({curve, black, white, black}).r == Approx(inside).margin(2e-7));
}

// A ray that meets it at sin θ = b leaves at the same angle; parallel light is spread evenly over b².
TEST_CASE("fresnel: a ball of n = 1.5 in parallel light passes 0.8355444 of the beam at once") {
  const TabulatedSurface outside({"", clear_glass(0)}), inside({"", clear_glass(0), true});
  const auto passed = [&](double cosine) {
    const auto in = outside.bsdf(direction(cosine)).sample(0.5, 0.5, 0.9999999);
    const auto out = inside.bsdf(direction(-in->wi.z)).sample(0.5, 0.5, 0.9999999);
    CHECK(-out->wi.z == Approx(cosine));
    return in->weight.r * in->density * out->weight.r * out->density;
  };
  const double sum = GaussLegendre(24).integrate([&](double x) {
    const double cosine = x * x;
    return passed(cosine) * 4 * x * x * x;
  });
  CHECK(sum == Approx(0.8355444).margin(1e-6));
}

TEST_CASE("fresnel: a metal at the normal mirrors ((n − 1)² + k²)/((n + 1)² + k²), at the horizon all") {
  CHECK(conductor_reflectance(1, 0.1310, 4.0624) == Approx(0.9705).margin(5e-5));
  CHECK(conductor_reflectance(1, 1.4829, 1.7805) == Approx(0.3646).margin(5e-5));
  CHECK(conductor_reflectance(0, 1.4829, 1.7805) == Approx(1).margin(1e-12));
  CHECK(conductor_reflectance(0.5, 1.5, 0) == Approx(0.0891867).margin(5e-8)); // glass is one that absorbs nothing
}

TEST_CASE("fresnel: a perfect mirror gives back what the curve says, in one direction") {
  MaterialValues v = rough_mirror(0);
  v.reflect = {0.9, 0.5, 0.1};
  const auto sample = TabulatedSurface({"", v}).bsdf(direction(0.6, 0)).sample(0.1, 0.2, 0.3);
  REQUIRE(sample);
  CHECK(sample->is_perfect);
  CHECK(sample->density == Approx(1));
  CHECK(sample->weight.r == Approx(0.9));
  CHECK(sample->weight.b == Approx(0.1));
  CHECK(sample->wi.x == Approx(-0.8));
  CHECK(sample->wi.z == Approx(0.6));
}

TEST_CASE("fresnel: glass bends by Snell's law and mirrors all beyond the critical angle") {
  const auto in = TabulatedSurface({"", clear_glass(0)}).bsdf(direction(0.5, 0)).sample(0.1, 0.2, 0.999);
  REQUIRE(in);
  CHECK(in->wi.x == Approx(-std::sqrt(0.75) / 1.5));
  CHECK(in->weight.g == Approx(1)); // basic radiance: no factor of n²
  const TabulatedSurface inside({"", clear_glass(0), true});
  const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
  for (const double choice : {0.0, 0.5, 0.9999}) {
    const auto total = inside.bsdf(direction(critical - 1e-6)).sample(0.1, 0.2, choice);
    REQUIRE(total);
    CHECK(total->wi.z > 0);
    CHECK(total->density == Approx(1));
    CHECK(total->weight.b == Approx(1));
  }
}
