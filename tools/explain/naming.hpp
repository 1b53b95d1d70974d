#pragma once

#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// How answers name objects and lights.
namespace rt::tools::explain {

/// The objects that a path of indices leads through, from the scene's list inwards; the last is the shape itself. The
/// path must be one of this scene's (`HitReport::path`).
std::vector<const scene::Object*> objects_on(const scene::Scene& scene, std::span<const std::uint32_t> path);

/// The object that represents what was hit: the outermost that has a name, else the outermost combination, else the
/// shape itself. None for an empty path.
const scene::Object* owner(const scene::Scene& scene, std::span<const std::uint32_t> path);

/// Its name, or its noun if it has none; for a combination its operation.
std::string name_of(const scene::Scene& scene, const scene::Object& object);
std::string name_of(const scene::Scene& scene, const scene::Light& light);

/// Names with the shortest form of their place: "`ball` (line 7)", with the file if it is not the scene's
/// own.
class Namer {
public:
  /// `file` is the name of the scene's own file in `scene.files`; without it every place includes its file. The scene
  /// must outlive the namer.
  explicit Namer(const scene::Scene& scene, std::string_view file = {}) : scene_(scene), file_(file) {}

  /// All objects that were hit, outermost first: "`table` (line 12), its box (line 4)".
  std::string whole(std::span<const std::uint32_t> path) const;
  /// The same for nested objects.
  std::string whole(std::span<const scene::Object* const> objects) const;
  /// The name of the object that represents the hit: `owner`.
  std::string title(std::span<const std::uint32_t> path) const;
  std::string object(const scene::Object& object) const;
  std::string light(std::uint32_t index) const;
  /// "line 7", "other.rtl:7"; empty if it was not written.
  std::string place(scene::Origin origin) const;

private:
  std::string with_place(std::string name, scene::Origin origin) const;

  const scene::Scene& scene_;
  std::string_view file_;
};

} // namespace rt::tools::explain
