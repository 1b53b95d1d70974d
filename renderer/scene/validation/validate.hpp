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
    value,     ///< a number is not finite, or breaks its field's constraint
    thing,     ///< what a shape, light or camera is made of does not go together: see its `check`
    transform, ///< a placement flattens, or stretches without end
    operand,   ///< of a combination: it is open, or a group
    media,     ///< the parts of one solid refract differently
    reference, ///< to what is not there, or to the thing itself
  };
  Kind kind;
  std::string path;    ///< "objects[2].operands[0].radius", "materials[4].ior"; empty for the scene's own fields
  std::string message; ///< a sentence without its end
};

/// All flaws of a description, in no time that a picture of it would not take many times over. Without one it can be
/// rendered, exported and asked about.
std::vector<Flaw> validate(const Scene& scene);
/// The same for ranges of the scene's objects and what they refer to, without the rest.
std::vector<Flaw> validate(const Scene& scene, std::span<const std::span<const Object>> ranges);
/// The same for the scene's own fields, its camera and its lights.
std::vector<Flaw> validate_settings(const Scene& scene);

/// A description is to be rendered or exported that does not pass `validate`.
class InvalidScene : public std::invalid_argument {
public:
  explicit InvalidScene(std::vector<Flaw> flaws);
  const std::vector<Flaw>& flaws() const { return flaws_; }

private:
  std::vector<Flaw> flaws_;
};

/// Throws InvalidScene where there is a flaw.
void require_none(std::vector<Flaw> flaws);
/// The scene, which must be valid: throws InvalidScene.
const Scene& validated(const Scene& scene);

/// The inverse of placements that are multiplied out: each has one, but where many are nested the product may be beyond
/// what numbers hold. Throws InvalidScene then.
Affine inverse_of_nested(const Affine& map);

} // namespace rt::scene
