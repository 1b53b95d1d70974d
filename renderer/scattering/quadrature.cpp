#include "renderer/scattering/quadrature.hpp"

#include "renderer/math/elementary.hpp"

namespace rt {
namespace {

// The Legendre polynomial of degree n at x, and its derivative.
std::pair<double, double> legendre(int n, double x) {
  double before = 1, value = x;
  for (int k = 2; k <= n; ++k) before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
  return {value, n * (x * value - before) / (x * x - 1)};
}

} // namespace

GaussLegendre::GaussLegendre(int n) {
  for (int i = 0; i < n; ++i) {
    double root = sine_cosine_of_turns((i + 0.75) / (2 * n + 1)).cosine;
    for (int step = 0; step < 20; ++step) {
      const auto [value, derivative] = legendre(n, root);
      root -= value / derivative;
    }
    const double derivative = legendre(n, root).second;
    points_.emplace_back((1 - root) / 2, 1 / ((1 - root * root) * derivative * derivative));
  }
}

FacetQuadrature::FacetQuadrature(int along, int around) : along_(along) {
  for (int i = 0; i < around; ++i) around_.push_back(sine_cosine_of_turns((i + 0.5) / (2 * around)).cosine);
}

} // namespace rt
