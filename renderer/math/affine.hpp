#pragma once

#include "renderer/math/box3.hpp"
#include "renderer/math/ray.hpp"
#include "renderer/math/vec3.hpp"

#include <optional>

namespace rt {

/// An affine map p ↦ x·p.x + y·p.y + z·p.z + translation; x, y, z are the images of the unit vectors.
struct Affine {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Vec3 translation{0, 0, 0};

  friend constexpr bool operator==(const Affine&, const Affine&) = default;
  constexpr Vec3 point(const Vec3& p) const { return x * p.x + y * p.y + z * p.z + translation; }
  constexpr Vec3 vector(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
  constexpr Ray ray(const Ray& r) const { return {point(r.origin), vector(r.direction)}; }
  constexpr double determinant() const { return dot(x, cross(y, z)); }

  /// The transpose of the linear part applied to `n`: with the *inverse* map this transforms a normal, not normalised.
  constexpr Vec3 transposed_vector(const Vec3& n) const { return {dot(x, n), dot(y, n), dot(z, n)}; }

  /// A vector perpendicular to the image of a surface whose outward normal is `n`, also outward, not normalised: the
  /// inverse transpose times |determinant|, which needs no inverse.
  constexpr Vec3 normal(const Vec3& n) const {
    const Vec3 image = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return determinant() < 0 ? -image : image;
  }
  /// How the given coordinate of an image depends on x, y and z.
  constexpr Vec3 row(std::size_t axis) const { return {x[axis], y[axis], z[axis]}; }

  static constexpr Affine scaling(const Vec3& s) { return {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {}}; }
  static constexpr Affine translating(const Vec3& t) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, t}; }
  /// Right-handed rotation by `degrees` about the line through the origin along `axis` (not zero, any length);
  /// Rodrigues' formula. Multiples of 90° about a coordinate axis are exact.
  static Affine rotating(const Vec3& axis, double degrees);
  /// About x, then y, then z, each in degrees.
  static Affine rotating_xyz(const Vec3& degrees);
};

/// a after b: (a * b).point(p) = a.point(b.point(p)).
constexpr Affine operator*(const Affine& a, const Affine& b) {
  return {a.vector(b.x), a.vector(b.y), a.vector(b.z), a.point(b.translation)};
}

/// The inverse map; nothing if the determinant is zero or not finite.
std::optional<Affine> inverse(const Affine& a);

/// The factor by which the map scales all lengths alike, if it does (to 1e-14): it only rotates, mirrors, moves and
/// scales uniformly.
std::optional<double> similarity_scale(const Affine& a);

/// The mean factor by which it scales lengths: the cube root of that for volumes.
double mean_scale(const Affine& a);

/// The bounding box of the image of `box`; infinite sides stay infinite.
Box3 transform_box(const Affine& a, const Box3& box);

} // namespace rt
