#include "renderer/scene/transform.hpp"

namespace rt::scene {
namespace {

Affine about(const Affine& map, const Vec3& fixed) {
  if (fixed == Vec3{}) return map;
  return Affine::translating(fixed) * map * Affine::translating(-fixed);
}

Affine linear(const ScaleStep& s) {
  return about(Affine::scaling(s.factors), s.about);
}
Affine linear(const RotateStep& s) {
  return about(Affine::rotating_xyz(s.degrees), s.about);
}
Affine linear(const RotateAxisStep& s) {
  return about(Affine::rotating(s.axis, s.degrees), s.about);
}
Affine linear(const MoveStep& s) {
  return Affine::translating(s.offset);
}
Affine linear(const ShearStep& s) {
  return about({{1, s.yx, s.zx}, {s.xy, 1, s.zy}, {s.xz, s.yz, 1}, {}}, s.about);
}
Affine linear(const MatrixStep& s) {
  return s.matrix;
}

// Householder's reflection, p − 2 (n·p) n.
Affine linear(const MirrorStep& s) {
  const Vec3 n = normalize(s.normal);
  const auto mirrored = [&](const Vec3& e) { return e - n * (2 * dot(n, e)); };
  return about({mirrored({1, 0, 0}), mirrored({0, 1, 0}), mirrored({0, 0, 1}), {}}, s.about);
}

} // namespace

Affine matrix(const Step& step) {
  return std::visit([](const auto& s) { return linear(s); }, step);
}

Affine matrix(const Placement& placement) {
  Affine map =
      Affine::translating(placement.at) * Affine::rotating_xyz(placement.rotate) * Affine::scaling(placement.scale);
  for (const Step& step : placement.chain) map = matrix(step) * map;
  return map;
}

bool flattens(const Placement& placement) {
  return !inverse(matrix(placement));
}

} // namespace rt::scene
