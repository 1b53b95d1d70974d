#include "lang/syntax/errors/syntax_codes.hpp"

#include <string_view>
#include <utility>

namespace rt::lang::errors {
namespace {

constexpr std::string_view hash_comment_code = "E0112", vector_code = "E0135";

Diagnostic syntax_error(std::string_view code, Span place, std::string message, std::string label) {
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.message = std::move(message);
  diagnostic.span = place;
  diagnostic.label = std::move(label);
  return diagnostic;
}

} // namespace

Diagnostic unexpected(Span place, std::string message, std::string label) {
  return syntax_error("E0101", place, std::move(message), std::move(label));
}

Diagnostic missing_separator(Span place, std::string message, std::string label) {
  return syntax_error("E0102", place, std::move(message), std::move(label));
}

Diagnostic open_bracket(Span place, std::string message, std::string label) {
  return syntax_error("E0103", place, std::move(message), std::move(label));
}

Diagnostic bracket_without_partner(Span place, std::string message, std::string label) {
  return syntax_error("E0104", place, std::move(message), std::move(label));
}

Diagnostic unclosed_string(Span place, std::string message, std::string label) {
  return syntax_error("E0105", place, std::move(message), std::move(label));
}

Diagnostic unclosed_comment(Span place, std::string message, std::string label) {
  return syntax_error("E0106", place, std::move(message), std::move(label));
}

Diagnostic unknown_escape(Span place, std::string message, std::string label) {
  return syntax_error("E0107", place, std::move(message), std::move(label));
}

Diagnostic malformed_number(Span place, std::string message, std::string label) {
  return syntax_error("E0108", place, std::move(message), std::move(label));
}

Diagnostic unknown_unit(Span place, std::string message, std::string label) {
  return syntax_error("E0109", place, std::move(message), std::move(label));
}

Diagnostic number_not_decimal(Span place, std::string message, std::string label) {
  return syntax_error("E0110", place, std::move(message), std::move(label));
}

Diagnostic malformed_color(Span place, std::string message, std::string label) {
  return syntax_error("E0111", place, std::move(message), std::move(label));
}

Diagnostic hash_comment(Span place, std::string message, std::string label) {
  return syntax_error(hash_comment_code, place, std::move(message), std::move(label));
}

Diagnostic wrong_quotes(Span place, std::string message, std::string label) {
  return syntax_error("E0113", place, std::move(message), std::move(label));
}

Diagnostic line_begins_with_operator(Span place, std::string message, std::string label) {
  return syntax_error("E0114", place, std::move(message), std::move(label));
}

Diagnostic line_begins_with_brace(Span place, std::string message, std::string label) {
  return syntax_error("E0115", place, std::move(message), std::move(label));
}

Diagnostic else_without_if(Span place, std::string message, std::string label) {
  return syntax_error("E0116", place, std::move(message), std::move(label));
}

Diagnostic chained_operators(Span place, std::string message, std::string label) {
  return syntax_error("E0117", place, std::move(message), std::move(label));
}

Diagnostic assignment_in_expression(Span place, std::string message, std::string label) {
  return syntax_error("E0118", place, std::move(message), std::move(label));
}

Diagnostic foreign_operator(Span place, std::string message, std::string label) {
  return syntax_error("E0119", place, std::move(message), std::move(label));
}

Diagnostic reserved_word(Span place, std::string message, std::string label) {
  return syntax_error("E0120", place, std::move(message), std::move(label));
}

Diagnostic foreign_statement(Span place, std::string message, std::string label) {
  return syntax_error("E0121", place, std::move(message), std::move(label));
}

Diagnostic nothing_between_separators(Span place, std::string message, std::string label) {
  return syntax_error("E0122", place, std::move(message), std::move(label));
}

Diagnostic meaningless_character(Span place, std::string message, std::string label) {
  return syntax_error("E0123", place, std::move(message), std::move(label));
}

Diagnostic not_utf8(Span place, std::string message, std::string label) {
  return syntax_error("E0124", place, std::move(message), std::move(label));
}

Diagnostic nested_too_deep(Span place, std::string message, std::string label) {
  return syntax_error("E0125", place, std::move(message), std::move(label));
}

Diagnostic missing_block(Span place, std::string message, std::string label) {
  return syntax_error("E0126", place, std::move(message), std::move(label));
}

Diagnostic missing_name(Span place, std::string message, std::string label) {
  return syntax_error("E0127", place, std::move(message), std::move(label));
}

Diagnostic missing_in(Span place, std::string message, std::string label) {
  return syntax_error("E0128", place, std::move(message), std::move(label));
}

Diagnostic misplaced_arrow(Span place, std::string message, std::string label) {
  return syntax_error("E0129", place, std::move(message), std::move(label));
}

Diagnostic missing_parameters(Span place, std::string message, std::string label) {
  return syntax_error("E0130", place, std::move(message), std::move(label));
}

Diagnostic loose_not(Span place, std::string message, std::string label) {
  return syntax_error("E0131", place, std::move(message), std::move(label));
}

Diagnostic item_in_record(Span place, std::string message, std::string label) {
  return syntax_error("E0132", place, std::move(message), std::move(label));
}

Diagnostic missing_function_value(Span place, std::string message, std::string label) {
  return syntax_error("E0133", place, std::move(message), std::move(label));
}

Diagnostic incomplete_statement(Span place, std::string message, std::string label) {
  return syntax_error("E0134", place, std::move(message), std::move(label));
}

Diagnostic vector_without_brackets(Span place, std::string message, std::string label) {
  return syntax_error(vector_code, place, std::move(message), std::move(label));
}

Diagnostic bare_if_or_fn(Span place, std::string message, std::string label) {
  return syntax_error("E0136", place, std::move(message), std::move(label));
}

Diagnostic equals_for_colon(Span place, std::string message, std::string label) {
  return syntax_error("E0137", place, std::move(message), std::move(label));
}

Diagnostic by_without_range(Span place, std::string message, std::string label) {
  return syntax_error("E0138", place, std::move(message), std::move(label));
}

Diagnostic malformed_expect(Span place, std::string message, std::string label) {
  return syntax_error("E0139", place, std::move(message), std::move(label));
}

bool is_hash_comment(const Diagnostic& diagnostic) {
  return diagnostic.code == hash_comment_code;
}

bool is_vector_without_brackets(const Diagnostic& diagnostic) {
  return diagnostic.code == vector_code;
}

} // namespace rt::lang::errors
