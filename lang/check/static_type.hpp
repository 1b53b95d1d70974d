#pragma once

#include "lang/values/builtin.hpp"
#include "lang/values/node_types.hpp"

#include <cstdint>

namespace rt::lang {

struct FunctionInfo;
struct ModuleInfo;

/// What is known about a value without running anything.
struct StaticType {
  enum class What : std::uint8_t { nothing, thing, function, builtin, module } what = What::nothing;
  const NodeType* type = nullptr;         ///< of a thing; a def's is `group`
  const FunctionInfo* function = nullptr; ///< of a function; for a thing made by a def: the def
  const Builtin* builtin = nullptr;
  const ModuleInfo* module = nullptr;
  bool is_bare_noun = false; ///< the name of a noun or def itself: no property is set yet

  bool is_thing() const { return what == What::thing; }
};

/// The thing whose block is being read, which owns the properties there.
struct Owner {
  const NodeType* type = nullptr;    ///< null if no property is expected
  const FunctionInfo* def = nullptr; ///< whose parameters come first
  bool is_unknown = false;           ///< a thing whose type is known only at run time
  bool is_def_body = false;          ///< the body of a `def`, where properties are defaults
};

} // namespace rt::lang
