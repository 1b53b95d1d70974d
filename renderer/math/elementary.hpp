#pragma once

/// Elementary functions that give the same bits on every machine. The C library's do not: glibc has variants with fused
/// multiply-add and selects them by processor. Here are sums and products only, accurate to a few units in the last
/// place.
namespace rt {

struct SineCosine {
  double sine, cosine;
};

/// For an angle between −π/4 and π/4, in radians.
SineCosine sine_cosine_near_zero(double angle);

/// For 2π times `turns`, which lies between 0 and 1.
SineCosine sine_cosine_of_turns(double turns);

/// In radians; the argument lies between −1 and 1.
double arc_cosine(double cosine);

/// e to the power of −x, x between 0 and 700.
double exponential_decay(double x);

/// To the base e, of a positive number.
double natural_logarithm(double x);

} // namespace rt
