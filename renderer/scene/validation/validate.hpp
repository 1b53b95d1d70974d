#pragma once

#include "renderer/scene/scene.hpp"

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt::scene {

/// What is wrong with a description, and where.
struct Flaw {
  enum class Kind : std::uint8_t {
    value,     ///< a number is not finite, or violates its field's constraint
    thing,     ///< the fields of a shape, light or camera are inconsistent: see its `check`
    transform, ///< a placement is singular or not finite
    operand,   ///< of a combination: it is open, or a group
    media,     ///< the parts of one solid refract differently
    reference, ///< to something that does not exist, or to itself
  };
  Kind kind;
  std::string path;    ///< "objects[2].operands[0].radius", "materials[4].ior"; empty for the scene's own fields
  std::string message; ///< a sentence without the full stop
};

/// All flaws of a description, in far less time than a picture of it would take. A scene without any can be rendered,
/// exported and queried.
std::vector<Flaw> validate(const Scene& scene);
/// The same for ranges of the scene's objects and what they refer to, without the rest.
std::vector<Flaw> validate(const Scene& scene, std::span<const std::span<const Object>> ranges);
/// The same for the scene's own fields, its camera and its lights.
std::vector<Flaw> validate_settings(const Scene& scene);

/// Thrown when a description that does not pass `validate` is to be rendered or exported.
class InvalidScene : public std::invalid_argument {
public:
  explicit InvalidScene(std::vector<Flaw> flaws);
  const std::vector<Flaw>& flaws() const { return flaws_; }

private:
  std::vector<Flaw> flaws_;
};

/// Throws InvalidScene if there are flaws.
void require_none(std::vector<Flaw> flaws);
/// Returns the scene if it is valid; else throws InvalidScene.
const Scene& validated(const Scene& scene);

/// The inverse of composed placements: each has one, but for deep nesting the product may overflow or underflow. Throws
/// InvalidScene then.
Affine inverse_of_nested(const Affine& map);

} // namespace rt::scene
