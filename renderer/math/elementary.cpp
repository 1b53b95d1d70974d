#include "renderer/math/elementary.hpp"

#include <cmath>
#include <numbers>

namespace rt {
namespace {

// asin(x)/x − 1 for x² = `square` up to ¼: the rational approximation of FreeBSD's libm (e_asin.c, Sun Microsystems).
double arc_sine_excess(double square) {
  const double z = square;
  const double p = z * (1.66666666666666657415e-01 +
                        z * (-3.25565818622400915405e-01 +
                             z * (2.01212532134862925881e-01 +
                                  z * (-4.00555345006794114027e-02 +
                                       z * (7.91534994289814532176e-04 + z * 3.47933107596021167570e-05)))));
  const double q =
      1 + z * (-2.40339491173441421878e+00 +
               z * (2.02094576023350569471e+00 + z * (-6.88283971605453293030e-01 + z * 7.70381505559019352791e-02)));
  return p / q;
}

} // namespace

// Taylor series: the truncation error is below 10⁻¹⁸.
SineCosine sine_cosine_near_zero(double angle) {
  const double z = angle * angle;
  double sine = 1, cosine = 1;
  for (int n = 17; n >= 3; n -= 2) {
    sine = 1 - z / (n * (n - 1)) * sine;
    cosine = 1 - z / ((n - 1) * (n - 2)) * cosine;
  }
  return {angle * sine, cosine};
}

SineCosine sine_cosine_of_turns(double turns) {
  const double quarters = std::floor(4 * turns + 0.5);
  const SineCosine rest = sine_cosine_near_zero((turns - quarters / 4) * (2 * std::numbers::pi));
  switch (static_cast<int>(quarters) % 4) {
  case 0:
    return rest;
  case 1:
    return {rest.cosine, -rest.sine};
  case 2:
    return {-rest.sine, -rest.cosine};
  default:
    return {-rest.cosine, rest.sine};
  }
}

double arc_cosine(double cosine) {
  const double size = std::abs(cosine);
  if (size < 0.5) return std::numbers::pi / 2 - (cosine + cosine * arc_sine_excess(cosine * cosine));
  const double half_square = (1 - size) / 2, half = std::sqrt(half_square); // of the sine of half the angle
  const double angle = 2 * (half + half * arc_sine_excess(half_square));
  return cosine > 0 ? angle : std::numbers::pi - angle;
}

// e^(−x) = (e^(−x/1024))^1024, the inner one by its Taylor series.
double exponential_decay(double x) {
  const double y = x / 1024;
  double result = 1;
  for (int n = 12; n >= 1; --n) result = 1 - y / n * result;
  for (int i = 0; i < 10; ++i) result *= result;
  return result;
}

// x = m·2^e with m about 1: e·ln 2 + 2·artanh((m − 1)/(m + 1)), the latter by its series.
double natural_logarithm(double x) {
  int e = 0;
  double m = std::frexp(x, &e);
  if (m < std::numbers::sqrt2 / 2) m *= 2, --e;
  const double s = (m - 1) / (m + 1), z = s * s;
  double sum = 0;
  for (int n = 23; n >= 1; n -= 2) sum = 1.0 / n + z * sum;
  return e * std::numbers::ln2 + 2 * s * sum;
}

} // namespace rt
