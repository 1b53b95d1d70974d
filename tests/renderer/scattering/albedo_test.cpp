#include "renderer/scattering/albedo_table.hpp"
#include "renderer/scattering/quadrature.hpp"
#include "renderer/scattering/tables.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace rt;

namespace {

double one(double) {
  return 1;
}

// Two parametrisations and, at μ = 1, Cycles agree with these to 5·10⁻⁶.
struct Row {
  double alpha;
  std::array<double, 5> albedo; // at these cosines
  double mean;
};
constexpr std::array cosines{0.1, 0.3, 0.5, 0.7, 1.0};
constexpr Row known[] = {
    {0.10, {0.88346, 0.93625, 0.96921, 0.98142, 0.98831}, 0.97205},
    {0.25, {0.89162, 0.83791, 0.85726, 0.88534, 0.91581}, 0.88232},
    {0.50, {0.86010, 0.74527, 0.69825, 0.68295, 0.68785}, 0.70024},
    {0.75, {0.81071, 0.65028, 0.56462, 0.51149, 0.46392}, 0.53630},
    {1.00, {0.76021, 0.56010, 0.45069, 0.37889, 0.30685}, 0.40914},
};

} // namespace

TEST_CASE("albedo: GGX with Smith's correlated masking, every facet a mirror") {
  const FacetQuadrature fine(48, 64), usual;
  for (const Row& row : known) {
    for (std::size_t i = 0; i < cosines.size(); ++i) {
      INFO("alpha " << row.alpha << ", cosine " << cosines[i]);
      CHECK(fine.reflected(row.alpha, cosines[i], one) == Approx(row.albedo[i]).margin(1e-5));
      CHECK(usual.reflected(row.alpha, cosines[i], one) == Approx(row.albedo[i]).margin(1.5e-4));
    }
  }
  CHECK(fine.reflected(1, 1, one) == Approx(1 - std::log(2)).margin(1e-9));
}

TEST_CASE("albedo: tables are within 0.0005 of it, and so are their means") {
  const FacetQuadrature fine(48, 64);
  for (const Row& row : known) {
    const MirrorTables tables(RoughnessAxis::constant(row.alpha), {});
    const auto place = tables.find(row.alpha);
    INFO("alpha " << row.alpha);
    CHECK(tables.mean_energy(place) == Approx(row.mean).margin(1e-4));
    for (double cosine = 0.003; cosine < 1; cosine *= 1.31) {
      INFO("cosine " << cosine);
      CHECK(tables.energy(place, cosine) == Approx(fine.reflected(row.alpha, cosine, one)).margin(1e-3));
    }
  }
}

TEST_CASE("albedo: a table of all roughnesses agrees with that of one") {
  const MirrorTables all(RoughnessAxis::patterned(Ggx::least_alpha), {});
  for (const Row& row : known) {
    INFO("alpha " << row.alpha);
    const MirrorTables one_only(RoughnessAxis::constant(row.alpha), {});
    const auto place = all.find(row.alpha), only = one_only.find(row.alpha);
    CHECK(all.mean_energy(place) == Approx(one_only.mean_energy(only)).margin(1e-3));
    for (const double cosine : cosines)
      CHECK(all.energy(place, cosine) == Approx(one_only.energy(only, cosine)).margin(2e-3));
  }
}

TEST_CASE("albedo: the mean of a table is that of its interpolation") {
  // f = μ^¼ is linear in the table's parameter: 2∫ μ^(5/4) dμ = 8/9.
  const AlbedoTable<double> table(RoughnessAxis::constant(1),
                                  [](double, double mu) { return std::sqrt(std::sqrt(mu)); });
  CHECK(table.mean({}) == Approx(8.0 / 9).margin(1e-9));
  CHECK(table.at({}, 0.3) == Approx(std::sqrt(std::sqrt(0.3))).margin(1e-9));
}

TEST_CASE("albedo: Gauss and Legendre's rule is exact for polynomials") {
  const GaussLegendre rule(5);
  CHECK(rule.integrate([](double x) { return std::pow(x, 9); }) == Approx(0.1).epsilon(1e-13));
  CHECK(GaussLegendre(48).integrate([](double x) { return std::exp(x); }) == Approx(std::exp(1) - 1).epsilon(1e-13));
}
