#pragma once

#include "lang/check/references.hpp"
#include "lang/syntax/ast.hpp"
#include "lang/values/node_types.hpp"

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rt::lang {

struct ModuleInfo;

/// The tree of one text. A file that is included twice is two units: its names may resolve differently in each.
struct Unit {
  Ast ast;
  std::vector<std::pair<NodeId, Unit*>> includes;         ///< by the `include` node
  std::vector<std::pair<NodeId, const ModuleInfo*>> uses; ///< by the `use` node

  Unit* included(NodeId node) const { return find(includes, node); }
  const ModuleInfo* used(NodeId node) const { return find(uses, node); }

private:
  template <class T>
  static T* find(const std::vector<std::pair<NodeId, T*>>& list, NodeId node) {
    for (const auto& [id, target] : list) {
      if (id == node) return target;
    }
    return nullptr;
  }
};

/// What check found out about a def, fn or lambda.
struct FunctionInfo {
  struct Parameter {
    Symbol name;
    std::uint32_t slot = 0;
    NodeId default_value = no_node;
    NodeId node = no_node; ///< its name
    DeclarationId declaration = no_declaration;
  };
  Unit* unit = nullptr;
  NodeId node = no_node;
  Kind kind = Kind::fn; ///< def, fn or lambda
  Symbol name = no_symbol;
  std::vector<Parameter> parameters;
  NodeId body = no_node;
  std::uint32_t frame_size = 0;
  DeclarationId declaration = no_declaration;
  bool is_at_top_level = false;       ///< of its file
  const ModuleInfo* module = nullptr; ///< the used file that contains it, null for the scene itself
  mutable bool was_run = false;

  std::optional<std::size_t> find(Symbol parameter) const {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name == parameter) return i;
    }
    return std::nullopt;
  }
};

/// A file named by `use`.
struct ModuleInfo {
  struct Export {
    Symbol name;
    std::uint32_t slot = 0;
    const FunctionInfo* function = nullptr; ///< a def or fn, else a value in `slot`
    const NodeType* type = nullptr;         ///< of a thing, if known
    DeclarationId declaration = no_declaration;
  };
  Unit* unit = nullptr;
  std::string path; ///< canonical
  std::uint32_t frame_size = 0;
  std::vector<Export> exports;

  const Export* find(Symbol name) const {
    for (const Export& e : exports) {
      if (e.name == name) return &e;
    }
    return nullptr;
  }
};

/// A value from the command line, `-D name=text`, as an expression that sees only built-in names.
struct Define {
  Symbol name;
  Unit* unit = nullptr;
  std::uint32_t frame_size = 0;
  bool is_used = false; ///< there is a `param` of this name
};

/// Everything that was read for one scene, with the names resolved.
struct Program {
  NodeTypes types;
  SymbolTable symbols;
  SourceMap sources;
  std::deque<Unit> units; ///< a deque: references stay valid
  std::deque<FunctionInfo> functions;
  std::deque<ModuleInfo> modules;
  std::vector<Define> defines;
  std::vector<std::string_view> choices; ///< all words of all properties
  Unit* main = nullptr;
  Unit* library = nullptr;
  std::uint32_t main_frame_size = 0;
  std::uint32_t library_frame_size = 0;
  struct LibraryName {
    Symbol name;
    std::uint32_t slot;
    Span span;
    DeclarationId declaration;
  };
  std::vector<LibraryName> library_names;
  std::vector<Symbol> param_names; ///< in the main file and what it includes
  References references;

  Program();
  /// The last one wins.
  const Define* find_define(Symbol name) const {
    const Define* found = nullptr;
    for (const Define& define : defines) {
      if (define.name == name) found = &define;
    }
    return found;
  }
};

/// What check resolved a name to. In a name node: `Ast::slot` and, in `Node::extra`, the resolution in the upper four
/// bits and in the lower twelve the number of frames outwards.
enum class Resolution : std::uint16_t {
  none,     ///< in error, reported
  local,    ///< slot of a frame
  function, ///< index in `Program::functions`, and the frame it was declared in
  type,     ///< index in `Program::types`
  builtin,  ///< index in the table of built-in functions
  constant, ///< index in the table of built-in constants
  color,    ///< a CSS colour: 0xrrggbb
  choice,   ///< index of the word in the table of choices
  question, ///< index in the table of questions
};

constexpr std::uint16_t pack(Resolution resolution, std::size_t depth) {
  return static_cast<std::uint16_t>(static_cast<unsigned>(resolution) << 12 | (depth & 0xfff));
}
constexpr Resolution resolution(const Node& name) {
  return static_cast<Resolution>(name.extra >> 12);
}
constexpr std::size_t frames_out(const Node& name) {
  return name.extra & 0xfff;
}

} // namespace rt::lang
