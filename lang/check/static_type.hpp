#pragma once

#include "lang/values/builtin.hpp"
#include "lang/values/node_types.hpp"

#include <cstdint>

namespace rt::lang {

struct FunctionInfo;
struct ModuleInfo;

/// What is known of a value without running anything.
struct StaticType {
  enum class What : std::uint8_t { nothing, thing, function, builtin, module } what = What::nothing;
  const NodeType* type = nullptr;         ///< of a thing; a def's is `group`
  const FunctionInfo* function = nullptr; ///< of a function; of a thing that a def makes: the def
  const Builtin* builtin = nullptr;
  const ModuleInfo* module = nullptr;
  bool is_bare_noun = false; ///< the name of a noun or def itself: no property is written yet

  bool is_thing() const { return what == What::thing; }
};

/// The thing whose block is being read, to which the properties there belong.
struct Owner {
  const NodeType* type = nullptr;    ///< null where no property is expected
  const FunctionInfo* def = nullptr; ///< whose parameters come first
  bool is_unknown = false;           ///< some thing, known only when the program runs
  bool is_def_body = false;          ///< the inside of a `def`, where properties are defaults
};

} // namespace rt::lang
