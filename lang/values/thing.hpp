#pragma once

#include "lang/values/node_types.hpp"
#include "lang/values/value.hpp"
#include "renderer/scene/scene.hpp"

#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <vector>

namespace rt::lang {

/// A property that was set: its index in `NodeType::properties`, or `parameter_id` of a def's parameter.
struct PropertyValue {
  Value value;
  Span span; ///< of the value
  std::uint16_t id = 0;
};

/// A few properties on the stack: those of a thing that is added to the scene without ever being a value.
class PropertyList {
public:
  static constexpr std::size_t most = 24;

  PropertyList() = default;
  PropertyList(const PropertyList&) = delete;
  PropertyList& operator=(const PropertyList&) = delete;
  ~PropertyList() { std::destroy_n(data(), size_); }
  /// There must be room for one more.
  PropertyValue& add() { return *new (data() + size_++) PropertyValue; }
  std::span<PropertyValue> values() { return {data(), size_}; }

private:
  PropertyValue* data() { return reinterpret_cast<PropertyValue*>(memory_); }
  alignas(PropertyValue) std::byte memory_[most * sizeof(PropertyValue)]; // not initialised: most of it is never used
  std::size_t size_ = 0;
};

inline constexpr std::uint16_t parameter_bit = 0x8000;
constexpr std::uint16_t parameter_id(std::size_t parameter) {
  return static_cast<std::uint16_t>(parameter_bit | parameter);
}

/// The steps of `.scale(…)`, `.rotate(…)` and so on.
struct Chain : Cell {
  static constexpr ValueKind cell_kind = ValueKind::chain;
  std::vector<scene::Step> steps;
};

/// The contents of a composite, shared by all its copies: placed often, it is one shape with many objects.
struct Content : Cell {
  static constexpr ValueKind cell_kind = ValueKind::content;
  std::vector<scene::Object> members; ///< until `shape` is made from them
  std::vector<scene::Light> lights;
  std::vector<PropertyValue> defaults;  ///< the properties in a def's body
  std::optional<scene::ShapeRef> shape; ///< in the scene's shapes
  bool is_pending = false;              ///< of a def whose body has not been run yet
  bool is_nothing = false;              ///< there are no members
  bool is_cut = false;                  ///< an empty difference or intersection
};

/// A thing: a noun, the properties that were set, the chain; for a composite, its contents. It is immutable: a copy
/// with changes is a different thing.
struct Thing : Cell {
  static constexpr std::uint32_t no_color = 0xffffffff;
  static constexpr ValueKind cell_kind = ValueKind::thing;
  const NodeType* type = nullptr; ///< `group` for what a def makes
  const FunctionInfo* def = nullptr;
  Ref<Frame> def_frame; ///< where the def was declared
  std::vector<PropertyValue> properties;
  Ref<Chain> chain;
  mutable Ref<Content> content;       ///< of a def: once its body has been run
  Span span;                          ///< where it was written
  std::uint32_t css_color = no_color; ///< `gold` is a material and the name of a colour: 0xrrggbb
  Symbol default_name = no_symbol;    ///< if it has no `name`: of its binding, else of what it is a copy of
  bool is_bound = false;              ///< the binding is its own

  // Cached by the builder of the scene description, so that copies share what they have in common.
  mutable std::optional<scene::ShapeRef> shape;
  mutable std::uint32_t built = 0xffffffff; ///< id of the material or pattern

  const PropertyValue* find(std::uint16_t id) const {
    for (const PropertyValue& p : properties) {
      if (p.id == id) return &p;
    }
    return nullptr;
  }
};

inline Thing& Value::thing() const {
  return *static_cast<Thing*>(expect(ValueKind::thing).cell);
}

} // namespace rt::lang
