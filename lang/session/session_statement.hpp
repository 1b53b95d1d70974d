#pragma once

#include "lang/check/check.hpp"
#include "lang/evaluate/evaluator.hpp"
#include "renderer/math/box3.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rt::lang {

/// Where a statement's text was first read: what diagnostics about it refer to.
struct TextOrigin {
  std::string name;
  std::string path;       ///< canonical, empty if it is not from a file
  std::uint32_t line = 1; ///< of the text's first line
};

/// One statement of a session's document, with all its results. It never changes once it is accepted; a modified one
/// replaces it.
struct Statement {
  std::uint64_t id = 0;    ///< kept when its text is edited or it is evaluated again
  std::uint64_t stamp = 0; ///< of its results: a new one after each evaluation

  std::string text; ///< the comments above it, itself, the comment after it
  TextOrigin origin;
  Kind kind = Kind::none; ///< of its first node; `none`: only comments
  Symbol key = no_symbol; ///< the name it declares, or the property of the scene that it sets
  bool may_print = false; ///< typed, not read from a file

  Unit* unit = nullptr;
  std::vector<NodeId> nodes; ///< more than one only of anonymous things
  std::vector<TopName> names;
  std::vector<Symbol> uses;    ///< sorted; names of other statements
  std::vector<Symbol> globals; ///< sorted; names that no statement declares

  StatementResult made;
  Box3 finite_box; ///< around its visible finite objects

  bool declares() const {
    return kind == Kind::bind || kind == Kind::def || kind == Kind::fn || kind == Kind::use || kind == Kind::param;
  }
  bool is_function() const { return kind == Kind::def || kind == Kind::fn; }
  bool is_comment() const { return kind == Kind::none; }
};

using StatementRef = std::shared_ptr<const Statement>;

} // namespace rt::lang
