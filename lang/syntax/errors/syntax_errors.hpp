#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/syntax/ast_builder.hpp"
#include "lang/syntax/errors/syntax_codes.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The wording of syntax errors. The grammar knows where it failed and what it expected; what the author most likely
/// meant is inferred from the surrounding text.
namespace rt::lang {

/// What the grammar expected.
enum class Expected : std::uint8_t {
  item,
  item_end, ///< a separator or the end of the block
  expression,
  end_of_expression, ///< of a text that is a single expression
  property_colon,    ///< where a vector in another language's syntax follows a name
  closing_bracket,   ///< of ( or [, or a comma
  name,
  property_name, ///< after a dot
  block,
  head, ///< of for and if
  loop_in,
  parameters,
  function_body,
  arrow, ///< => of a lambda
  path,
  use_as,
  claim_t, ///< of `at t` in an `expect`
  param_value,
  string_end,
  comment_end,
  item_begin, ///< not a sign in the line after another item, nor a value of POV-Ray's without a name
};

struct OpenBracket {
  std::uint32_t at;
  char bracket;
};

/// A place in a text that is being parsed.
struct SyntaxPlace {
  std::string_view text;
  FileId file;
  std::uint32_t at;                     ///< where the grammar stopped
  std::uint32_t item;                   ///< where the innermost item began
  bool follows_line;                    ///< that item began a line, after another item
  const std::vector<OpenBracket>& open; ///< outermost first
};

Diagnostic explain_failure(const SyntaxPlace& place, Expected expected);

// Syntax of other languages.

/// A word that begins a statement in another language; nothing for others.
std::optional<Diagnostic> foreign_word(Span span, std::string_view word);
/// `translate(…) sphere {}`: what precedes a thing in other languages, and follows it here; nothing for other words.
std::optional<Diagnostic> foreign_method(Span span, std::string_view word);
/// How to write what stands at a brace followed by values alone, `sphere { <0, 1, 0>, 1 }`.
std::string povray_form(std::string_view text, std::uint32_t brace);
/// Whether the brace is of a thing that POV-Ray has, too, and describes by values without names.
bool is_povray_thing(std::string_view text, std::uint32_t brace);
Diagnostic unknown_character(Span span, std::string_view c);
/// `#` where no colour is meant: a comment, or a POV-Ray directive.
Diagnostic misplaced_hash(Span span, std::string_view text);

Diagnostic unclosed_bracket(FileId file, OpenBracket bracket);
Diagnostic mismatched_bracket(FileId file, OpenBracket bracket, std::uint32_t at, char found);
/// Of the brackets `open` at the end of the file, those that appear unclosed (by the indentation of their lines).
std::vector<OpenBracket> forgotten_braces(std::string_view text, std::size_t count);

// Errors that parsing recovers from: what was meant is clear enough to continue.

/// `left` is the text before the operator.
Diagnostic misused_operator(Complaint complaint, Span op, std::string_view op_text, std::string_view left);
/// `&&`, `||`, `!`, `**`, `++`, `...`, and `=` in an expression.
Diagnostic foreign_operator(Span op, std::string_view op_text);
/// What is wrong with a number literal, if anything; its suffix begins at `digits`.
std::optional<Diagnostic> malformed_number(Span span, std::string_view text, std::uint32_t digits, double value);
Diagnostic malformed_color(Span span, std::string_view text);
Diagnostic bad_escape(Span string, std::string_view text, std::uint32_t offset);

/// Where to continue after the error at `at`: behind characters that are not in the language at all.
std::uint32_t resume_after(std::string_view text, std::uint32_t at, const Diagnostic& error);

/// Where parsing continues after an error at `from`: at the separator or closing brace that ends the broken item.
/// `open` are the brackets that were open within the item.
std::uint32_t skip_broken_item(std::string_view text, std::uint32_t from, std::string_view open, bool is_in_braces);

/// The name that a broken item was to declare, empty if none: its uses are not errors.
std::string_view declared_name(std::string_view text, std::uint32_t item);

/// Whether the text at `at` looks like the start of an item, not of an element or operand: `name:`, `name =`, `for`.
bool looks_like_item(std::string_view text, std::uint32_t at);

} // namespace rt::lang
