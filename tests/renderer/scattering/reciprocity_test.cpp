#include "tests/renderer/scattering/surfaces.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

Vec3 turned_over(const Vec3& v) {
  return {v.x, v.y, -v.z};
}

void check_equal(double a, double b) {
  CHECK(std::abs(a - b) <= 1e-12 * std::max(1.0, std::max(a, b)));
}

} // namespace

TEST_CASE("reciprocity: f(a, b)/n_b² = f(b, a)/n_a² for every lobe and side") {
  SplitMix64 random(14);
  for (const Surface& surface : surfaces()) {
    const TabulatedSurface tabulated(surface);
    int lit = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 a = direction(random.between(0.01, 1), random.unit()),
                 b = direction(random.between(-1, 1), random.unit());
      INFO(surface.name << ", " << a.z << " to " << b.z);
      const bool passes = b.z < 0;
      const Color there = tabulated.bsdf(a).evaluate(b);
      const Color back =
          passes ? tabulated.bsdf_from_behind(turned_over(b)).evaluate(turned_over(a)) : tabulated.bsdf(b).evaluate(a);
      const double squares = passes ? surface.eta() * surface.eta() : 1;
      check_equal(there.r / squares, back.r);
      check_equal(there.g / squares, back.g);
      check_equal(there.b / squares, back.b);
      lit += there.g > 0 ? 1 : 0;
    }
    INFO(surface.name);
    CHECK((lit > 0) == tabulated.bsdf({0, 0, 1}).has_spread());
  }
}

TEST_CASE("reciprocity: perfect glass weighs both ways alike") {
  const TabulatedSurface outside({"", clear_glass(0)}), inside({"", clear_glass(0), true});
  for (const double cosine : {0.05, 0.3, 0.7, 1.0}) {
    const Vec3 wo = direction(cosine);
    const auto in = outside.bsdf(wo).sample(0.5, 0.5, 0.9999999);
    REQUIRE(in);
    const auto out = inside.bsdf(turned_over(in->wi)).sample(0.5, 0.5, 0.9999999);
    REQUIRE(out);
    CHECK(length(turned_over(out->wi) - wo) < 1e-12);
    CHECK(in->weight.g * in->density == Approx(out->weight.g * out->density).epsilon(1e-12));
  }
}
