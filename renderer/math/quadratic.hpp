#pragma once

#include <cmath>

namespace rt {

/// The real roots of a·t² + 2·b·t + c = 0, given d = b² − a·c ≥ 0 and not all of a, b, d zero. No root suffers from
/// cancellation between b and √d (Press et al., Numerical Recipes, section 5.6); a root is infinite where a is 0, and
/// which of the two is the larger depends on the signs.
struct QuadraticRoots {
  double first, second;

  QuadraticRoots(double a, double b, double c, double d) {
    const double root = std::sqrt(d);
    const double q = -(b + std::copysign(root, b));
    first = q / a;
    second = q == 0 ? first : c / q;
  }
};

} // namespace rt
