#pragma once

#include "lang/text/symbol.hpp"
#include "renderer/scene/scene.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace rt::lang {

/// What kind of thing a noun names.
enum class Category : std::uint8_t { shape, group, combination, material, pattern, light, camera, scene };

/// The type of a property: those of the description's fields (same order), and those that only the language has.
enum class PropertyType : std::uint8_t {
  number,
  boolean,
  vector,
  size,
  color,
  points,
  choice,
  fade,
  resolution,
  metal,
  absorb,
  function,
  stops,
  material,
  text,
};

/// Properties that no field table lists, because they are not parameters of the shape itself.
enum class Common : std::uint8_t { none, at, rotate, scale, material, name, visible, casts_shadow };

/// One property of a noun, from its field table or from those common to all shapes (patterns, lights).
struct Property {
  std::string_view name;
  PropertyType type = PropertyType::number;
  Common common = Common::none;
  int form = 0;
  scene::Constraint constraint;
  std::string_view default_text;
  std::string_view help;
  std::span<const std::string_view> choices;
  const scene::Field* field = nullptr; ///< if `common` is none
  std::array<Symbol, 2> parts{};       ///< of a metal n and k, of absorption colour and distance; see `intern`

  bool is_textured() const { return field && field->is_textured; }
};

/// What a noun makes, of whatever kind, with no property set. Nothing for the scene itself.
using Prototype =
    scene::Joined<scene::TypeList<std::monostate, scene::Material, scene::Camera>,
                  scene::Joined<scene::Joined<scene::ShapeKinds, scene::LightKinds>, scene::PatternKinds>>::Variant;

/// The description that the fields of its table read and set.
inline void* owner(Prototype& made) {
  return std::visit([](auto& of_kind) -> void* { return &of_kind; }, made);
}

/// As a variant over a narrower list, which must contain its kind.
template <class Variant>
Variant narrowed(const Prototype& made) {
  return std::visit(
      []<class T>(const T& of_kind) -> Variant {
        if constexpr (std::is_constructible_v<Variant, const T&>)
          return of_kind;
        else
          throw std::bad_variant_access();
      },
      made);
}

/// A built-in noun.
struct NodeType {
  std::string_view name;
  Category category = Category::shape;
  std::string_view help;
  std::vector<Property> properties;
  Prototype prototype;
  scene::Combination::Operation operation = scene::Combination::Operation::unite;
  std::vector<std::uint8_t> by_symbol; ///< index in `properties` + 1 by symbol number; filled by `NodeTypes::intern`

  /// Index in `properties`, or nothing. By symbol once the names are interned.
  std::optional<std::uint16_t> find(std::string_view property) const;
  std::optional<std::uint16_t> find(Symbol property) const {
    const auto i = static_cast<std::size_t>(property);
    if (i >= by_symbol.size() || by_symbol[i] == 0) return std::nullopt;
    return static_cast<std::uint16_t>(by_symbol[i] - 1);
  }
  bool is_placeable() const { return category <= Category::combination || category == Category::light; }
  bool is_shape() const { return category <= Category::combination; }
  bool is_composite() const { return category == Category::group || category == Category::combination; }
  bool has_chain() const { return is_placeable() || category == Category::pattern; }
};

/// The table of all built-in nouns, assembled from the field tables of the scene description: nothing here knows what
/// properties a sphere has. References to its nouns stay valid for its lifetime.
class NodeTypes {
public:
  NodeTypes();
  /// Interns all names of nouns, properties and choices, and fills the nouns' `by_symbol`. To be called first on a
  /// symbol table, so that the symbols are small.
  void intern(SymbolTable& symbols);

  std::span<const NodeType> all() const { return nouns_; }
  const NodeType* find(std::string_view name) const;
  const NodeType& operator[](std::size_t i) const { return nouns_[i]; }
  std::size_t index(const NodeType& type) const { return static_cast<std::size_t>(&type - nouns_.data()); }

  const NodeType& group() const { return *group_; }
  const NodeType& material() const { return *material_; }
  const NodeType& combination(scene::Combination::Operation operation) const;
  /// The scene itself, whose properties are set at the top level; it has no name in the language.
  const NodeType& scene() const { return scene_; }

private:
  std::vector<NodeType> nouns_;
  NodeType scene_;
  const NodeType* group_ = nullptr;
  const NodeType* material_ = nullptr;
};

} // namespace rt::lang
