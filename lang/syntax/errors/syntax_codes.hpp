#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <string>

/// One function per code of the parser's; the registry documents each. The message depends on the surrounding text, so
/// the caller provides it.
namespace rt::lang::errors {

using SyntaxError = Diagnostic(Span place, std::string message, std::string label);

Diagnostic unexpected(Span place, std::string message, std::string label = {});
Diagnostic missing_separator(Span place, std::string message, std::string label = {});
Diagnostic open_bracket(Span place, std::string message, std::string label = {});
Diagnostic bracket_without_partner(Span place, std::string message, std::string label = {});
Diagnostic unclosed_string(Span place, std::string message, std::string label = {});
Diagnostic unclosed_comment(Span place, std::string message, std::string label = {});
Diagnostic unknown_escape(Span place, std::string message, std::string label = {});
Diagnostic malformed_number(Span place, std::string message, std::string label = {});
Diagnostic unknown_unit(Span place, std::string message, std::string label = {});
Diagnostic number_not_decimal(Span place, std::string message, std::string label = {});
Diagnostic malformed_color(Span place, std::string message, std::string label = {});
Diagnostic hash_comment(Span place, std::string message, std::string label = {});
Diagnostic wrong_quotes(Span place, std::string message, std::string label = {});
Diagnostic line_begins_with_operator(Span place, std::string message, std::string label = {});
Diagnostic line_begins_with_brace(Span place, std::string message, std::string label = {});
Diagnostic else_without_if(Span place, std::string message, std::string label = {});
Diagnostic chained_operators(Span place, std::string message, std::string label = {});
Diagnostic assignment_in_expression(Span place, std::string message, std::string label = {});
Diagnostic foreign_operator(Span place, std::string message, std::string label = {});
Diagnostic reserved_word(Span place, std::string message, std::string label = {});
Diagnostic foreign_statement(Span place, std::string message, std::string label = {});
Diagnostic nothing_between_separators(Span place, std::string message, std::string label = {});
Diagnostic meaningless_character(Span place, std::string message, std::string label = {});
Diagnostic not_utf8(Span place, std::string message, std::string label = {});
Diagnostic nested_too_deep(Span place, std::string message, std::string label = {});
Diagnostic missing_block(Span place, std::string message, std::string label = {});
Diagnostic missing_name(Span place, std::string message, std::string label = {});
Diagnostic missing_in(Span place, std::string message, std::string label = {});
Diagnostic misplaced_arrow(Span place, std::string message, std::string label = {});
Diagnostic missing_parameters(Span place, std::string message, std::string label = {});
Diagnostic loose_not(Span place, std::string message, std::string label = {});
Diagnostic item_in_record(Span place, std::string message, std::string label = {});
Diagnostic missing_function_value(Span place, std::string message, std::string label = {});
Diagnostic incomplete_statement(Span place, std::string message, std::string label = {});
Diagnostic vector_without_brackets(Span place, std::string message, std::string label = {});
Diagnostic bare_if_or_fn(Span place, std::string message, std::string label = {});
Diagnostic equals_for_colon(Span place, std::string message, std::string label = {});
Diagnostic by_without_range(Span place, std::string message, std::string label = {});
Diagnostic malformed_expect(Span place, std::string message, std::string label = {});

/// Whether it is one of these, after which parsing continues differently.
bool is_hash_comment(const Diagnostic& diagnostic);
bool is_vector_without_brackets(const Diagnostic& diagnostic);

} // namespace rt::lang::errors
