#pragma once

#include "lang/syntax/parse.hpp"

#include <string>
#include <vector>

namespace rt::tests {

/// A text, parsed.
struct Text {
  lang::SourceMap sources;
  lang::SymbolTable symbols;
  lang::Parsed parsed;

  const lang::Ast& ast() const { return parsed.ast; }
  std::vector<std::string> codes() const;
  std::string report() const;
};

Text parse_text(std::string text, const lang::ParseOptions& options = {});

/// The tree in parentheses: `(+ 1 (* 2 3))`. Items of a block are separated by "; ".
std::string shape(const lang::Ast& ast, const lang::SymbolTable& symbols, lang::NodeId id);
std::string shape(const Text& text);

/// The shape of a text that must parse without a diagnostic.
std::string parsed(std::string text);

} // namespace rt::tests
