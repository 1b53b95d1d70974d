#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/syntax/ast.hpp"

namespace rt::lang {

struct ParseOptions {
  int max_depth = 256;        ///< of brackets and of operators within operators
  bool folds_repeats = false; ///< yields `repeat` nodes; if off, every item has its own nodes
  bool is_session = false;    ///< a first line that begins with `.` edits what was placed last (`Kind::previous`)
};

/// A tree (with error nodes where the syntax is wrong) and every syntax error, in source order.
struct Parsed {
  Ast ast;
  std::vector<Diagnostic> diagnostics;
};

/// Text to tree. Names are interned in `symbols`, so that trees of several files can share them.
Parsed parse(const SourceMap& sources, FileId file, SymbolTable& symbols, const ParseOptions& options = {});

/// The same for a text that is a single expression (`-D name=value`): the root is the expression.
Parsed parse_expression(const SourceMap& sources, FileId file, SymbolTable& symbols, const ParseOptions& options = {});

/// Whether a session can submit the text as it is: brackets balance, no comment is open, and it does not end in an
/// operator, a comma, `=` or `:`.
bool is_complete(std::string_view text);

/// How many rules of the grammar might loop without consuming input; anything but 0 is a bug in it (for tests).
std::size_t grammar_problems();

} // namespace rt::lang
