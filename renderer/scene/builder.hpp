#pragma once

#include "renderer/math/hashing.hpp"
#include "renderer/scene/scene.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rt::scene {

/// Builds a description, for front ends, importers and tests. Equal materials, names and transforms are stored once.
/// Whether its input is valid is for `validate` to decide.
class Builder {
public:
  Scene scene; ///< so far; resolution, camera and so on are set directly

  MaterialId material(const Material& material);
  /// A material that is a colour and nothing else.
  MaterialId material(const Color& color);
  /// It may refer to patterns that were added before.
  PatternId pattern(Pattern pattern);
  /// A function as a pattern that stands where it is asked for; equal ones are kept once.
  PatternId function_pattern(FunctionRef function);
  NameId name(std::string_view text);
  /// For an object's `transform`; `at` is ignored, as it belongs to the object. Nothing if the placement is singular or
  /// not finite.
  std::optional<TransformId> transform(Placement placement);

  template <class S>
  ShapeRef shape(S shape) {
    return scene.shapes.add(std::move(shape));
  }
  ShapeRef group(std::vector<Object> members);
  /// A group among the operands is treated as the union of its members.
  ShapeRef combination(Combination::Operation operation, std::vector<Object> operands);

  /// Why a shape is not a solid: the name of its kind, or of the first open shape in a group; empty for
  /// solids.
  std::string_view open_part(ShapeRef shape);

  Object& add(const Object& object) { return scene.objects.emplace_back(object); }
  Light& add(const LightSource& source) { return scene.lights.emplace_back(Light{source, {}, {}, no_name, {}}); }

private:
  MaterialId add(const Material& material);
  ShapeRef united(ShapeRef shape);
  /// Calls `finish` with the group and the nested ones that `known` does not have yet, each after those it contains.
  template <class Known, class Finish>
  void innermost_first(std::uint32_t group, const Known& known, Finish&& finish);

  struct ColorHash {
    std::size_t operator()(const Color& color) const { return Hasher().add(color).value(); }
  };
  std::unordered_map<Color, MaterialId, ColorHash> plain_; // materials that are a colour and nothing else
  std::unordered_multimap<std::uint64_t, MaterialId> materials_;
  std::unordered_multimap<std::uint64_t, TransformId> transforms_;
  std::unordered_multimap<std::uint64_t, PatternId> functions_;
  std::unordered_map<std::string, NameId> names_;
  std::unordered_map<std::uint32_t, ShapeRef> unions_;             // by index of the group
  std::unordered_map<std::uint32_t, std::string_view> open_parts_; // by index of the group
};

} // namespace rt::scene
