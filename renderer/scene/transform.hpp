#pragma once

#include "renderer/fields/type_list.hpp"
#include "renderer/math/affine.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

/// Transforms as written. They are not multiplied out here: whatever reads a description (the compiler, the POV-Ray
/// exporter) does so for itself.
namespace rt::scene {

/// The steps of a chain, `.scale(…)`, `.rotate(…)` and so on. `about` is the fixed point, the world's origin by
/// default.
struct ScaleStep {
  static constexpr std::string_view noun = "scale";
  Vec3 factors{1, 1, 1};
  Vec3 about{};
};
/// About the x, then the y, then the z axis, in degrees.
struct RotateStep {
  static constexpr std::string_view noun = "rotate";
  Vec3 degrees{};
  Vec3 about{};
};
/// Right-handed about `axis` (not zero), in degrees.
struct RotateAxisStep {
  static constexpr std::string_view noun = "rotate about an axis";
  Vec3 axis{0, 1, 0};
  double degrees = 0;
  Vec3 about{};
};
struct MoveStep {
  static constexpr std::string_view noun = "move";
  Vec3 offset{};
};
/// x' = x + xy·y + xz·z, y' = y + yx·x + yz·z, z' = z + zx·x + zy·y.
struct ShearStep {
  static constexpr std::string_view noun = "shear";
  double xy = 0, xz = 0, yx = 0, yz = 0, zx = 0, zy = 0;
  Vec3 about{};
};
/// Through the plane that contains `about` and is perpendicular to `normal` (not zero).
struct MirrorStep {
  static constexpr std::string_view noun = "mirror";
  Vec3 normal{1, 0, 0};
  Vec3 about{};
};
struct MatrixStep {
  static constexpr std::string_view noun = "matrix";
  Affine matrix;
};
using StepKinds = TypeList<ScaleStep, RotateStep, RotateAxisStep, MoveStep, ShearStep, MirrorStep, MatrixStep>;
using Step = StepKinds::Variant;

/// How a thing is placed in its parent's space: scaled, then rotated (x, y, z in degrees), then moved to `at`, then
/// each step of the chain, left to right.
struct Placement {
  Vec3 scale{1, 1, 1};
  Vec3 rotate{};
  Vec3 at{};
  std::vector<Step> chain{};
};

/// The map of one step, and of a whole placement, from object space to its parent's.
Affine matrix(const Step& step);
Affine matrix(const Placement& placement);
/// Whether the placement is singular or not finite, so that it has no inverse.
bool flattens(const Placement& placement);

/// Index into `Scene::transforms`, `no_transform` if there is neither scale, rotation nor chain: true of almost every
/// object of a large scene, which is why `Object` stores only `at` itself.
enum class TransformId : std::uint32_t {};
inline constexpr TransformId no_transform{0xffffffff};

} // namespace rt::scene
