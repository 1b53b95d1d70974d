#pragma once

#include "lang/syntax/parse.hpp"

#include <string>
#include <vector>

namespace rt::lang::testing {

/// A text, parsed.
struct Text {
  SourceMap sources;
  SymbolTable symbols;
  Parsed parsed;

  const Ast& ast() const { return parsed.ast; }
  std::vector<std::string> codes() const;
  std::string report() const;
};

Text parse_text(std::string text, const ParseOptions& options = {});

/// The tree in parentheses: `(+ 1 (* 2 3))`. Items of a block are separated by "; ".
std::string shape(const Ast& ast, const SymbolTable& symbols, NodeId id);
std::string shape(const Text& text);

/// The shape of a text that must parse without a diagnostic.
std::string parsed(std::string text);

} // namespace rt::lang::testing
