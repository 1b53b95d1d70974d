#pragma once

#include "lang/values/node_types.hpp"
#include "lang/values/thing.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt::lang {

/// Properties as they are evaluated, for a thing or for the scene.
struct PropertyBlock {
  const NodeType* type = nullptr;
  const FunctionInfo* def = nullptr; ///< its parameters come first
  std::vector<PropertyValue> values; ///< initially, what is inherited
  struct Written {
    std::uint16_t id;
    Span name;
  };
  std::vector<Written> written; ///< in this block
  bool is_broken = false;       ///< part of the block is in error, so that what it describes is unknown
};

/// Where the results of a block's items go.
struct Target {
  enum class Kind : std::uint8_t {
    scene,
    content,  ///< of a group, a combination or a def
    bare,     ///< the block of a thing that cannot contain anything
    discarded ///< the top level of a file read by `use`
  };
  Kind kind = Kind::bare;
  std::vector<scene::Object>* objects = nullptr;
  std::vector<scene::Light>* lights = nullptr;
  const NodeType* type = nullptr;      ///< the composite being filled
  PropertyBlock* properties = nullptr; ///< null if the block's owner is in error
  std::uint16_t depth = 0;             ///< of what was put in
  std::uint32_t things = 0;            ///< how many were put in
  bool is_first_missing = false;       ///< the first operand is empty
  bool is_one_missing = false;         ///< an operand is empty
  Span owner;                          ///< the thing whose block it is, for messages

  bool is_combination() const { return type && type->category == Category::combination; }
};

/// The target that fills a composite's content.
Target target_for(Content& content, const NodeType& type, Span owner);

/// A thing about to be added to the scene.
struct ThingView {
  const NodeType* type;
  std::span<const PropertyValue> properties;
  const Chain* chain;
  Span place;
  const Thing* thing;        ///< null for what was never a value
  Content* inside = nullptr; ///< a composite's
};

} // namespace rt::lang
