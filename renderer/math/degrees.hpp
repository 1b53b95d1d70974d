#pragma once

namespace rt {

/// Trigonometry in degrees. Multiples of 30° and 45° are as exact as doubles allow, both ways: sin(30) is ½, sin(45)
/// and cos(45) are the same number, tan(45) is 1, and asin inverts sin exactly for a whole number of degrees.
double sin_degrees(double degrees);
double cos_degrees(double degrees);
/// Infinite where the cosine is 0.
double tan_degrees(double degrees);

/// From -90 to 90. Requires |x| <= 1.
double asin_degrees(double x);
/// From 0 to 180. Requires |x| <= 1.
double acos_degrees(double x);
/// From -90 to 90.
double atan_degrees(double x);
/// The angle of the point (x, y), from -180 to 180.
double atan2_degrees(double y, double x);

} // namespace rt
