#pragma once

#include "lang/values/node_types.hpp"
#include "lang/values/thing.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt::lang {

/// Properties as they come in, for a thing or for the scene.
struct PropertyBlock {
  const NodeType* type = nullptr;
  const FunctionInfo* def = nullptr; ///< its parameters come first
  std::vector<PropertyValue> values; ///< to begin with, what is inherited
  struct Written {
    std::uint16_t id;
    Span name;
  };
  std::vector<Written> written; ///< in this block
  bool is_broken = false;       ///< part of the block is in error, so that what it describes is not known
};

/// What the items of a block are put into.
struct Target {
  enum class Kind : std::uint8_t {
    scene,
    content,  ///< of a group, a combination or a def
    bare,     ///< the block of a thing that nothing can be put into
    discarded ///< the top level of a file that `use` reads
  };
  Kind kind = Kind::bare;
  std::vector<scene::Object>* objects = nullptr;
  std::vector<scene::Light>* lights = nullptr;
  const NodeType* type = nullptr;      ///< the composite that is filled
  PropertyBlock* properties = nullptr; ///< null where the block is of something in error
  std::uint16_t depth = 0;             ///< of what was put in
  std::uint32_t things = 0;            ///< how many were put in
  bool is_first_missing = false;       ///< the first operand is nothing
  bool is_one_missing = false;         ///< an operand is nothing
  Span owner;                          ///< the thing whose block it is, for messages

  bool is_combination() const { return type && type->category == Category::combination; }
};

/// What fills a composite's content.
Target target_for(Content& content, const NodeType& type, Span owner);

/// A thing on its way into the scene.
struct ThingView {
  const NodeType* type;
  std::span<const PropertyValue> properties;
  const Chain* chain;
  Span place;
  const Thing* thing;        ///< null for what was never a value
  Content* inside = nullptr; ///< a composite's
};

} // namespace rt::lang
