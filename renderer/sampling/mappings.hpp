#pragma once

#include "renderer/math/vec3.hpp"

/// Maps from the unit square that preserve proximity and relative area: stratified points stay stratified.
namespace rt {

struct Vec2 {
  double x = 0, y = 0;
};

/// Onto the unit disc. P. Shirley and K. Chiu, A Low Distortion Map Between Disk and Square, 1997.
Vec2 to_disc(double u, double v);

/// Onto directions about +z with a density of cos θ / π per solid angle: the disc projected up (N. Malley).
Vec3 to_cosine_hemisphere(double u, double v);

/// Onto the unit sphere, uniformly: the disc's rings spread over it.
Vec3 to_sphere(double u, double v);

/// Onto the directions within a cone about +z, uniformly; `height` is 1 − cos of its half angle, up to 2 for all
/// directions.
Vec3 to_cone(double u, double v, double height);

/// Onto a triangle, as barycentric coordinates. E. Heitz, A Low-Distortion Map Between Triangle and Square,
/// 2019.
Vec3 to_triangle(double u, double v);

/// An orthonormal basis, right-handed, z given.
class TangentFrame {
public:
  /// T. Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017.
  explicit TangentFrame(const Vec3& unit_z);
  /// From coordinates in this frame.
  Vec3 vector(const Vec3& v) const { return x_ * v.x + y_ * v.y + z_ * v.z; }
  /// To coordinates in this frame.
  Vec3 local(const Vec3& v) const { return {dot(v, x_), dot(v, y_), dot(v, z_)}; }

private:
  Vec3 x_, y_, z_;
};

} // namespace rt
