#pragma once

#include "lang/syntax/grammar.hpp"

/// What is missing where a `required` rule does not match. A rule without a row does not compile.
namespace rt::lang::grammar {

template <typename Rule>
inline constexpr bool has_no_row = false;

template <typename Rule>
constexpr Expected expected() {
  static_assert(has_no_row<Rule>, "give this rule a row in grammar_errors.hpp");
  return Expected::item;
}

// clang-format off
template <> constexpr Expected expected<item>() { return Expected::item; }
template <> constexpr Expected expected<item_end>() { return Expected::item_end; }
template <> constexpr Expected expected<item_begin>() { return Expected::item_begin; }
template <> constexpr Expected expected<expression>() { return Expected::expression; }
template <> constexpr Expected expected<value>() { return Expected::expression; }
template <> constexpr Expected expected<operand>() { return Expected::expression; }
template <> constexpr Expected expected<operand_rest>() { return Expected::expression; }
template <> constexpr Expected expected<next_line>() { return Expected::expression; }
template <> constexpr Expected expected<end_of_expression>() { return Expected::end_of_expression; }
template <> constexpr Expected expected<loop_name>() { return Expected::name; }
template <> constexpr Expected expected<declared_word>() { return Expected::name; }
template <> constexpr Expected expected<parameter_name>() { return Expected::name; }
template <> constexpr Expected expected<property_name>() { return Expected::property_name; }
template <> constexpr Expected expected<own_block>() { return Expected::block; }
template <> constexpr Expected expected<head>() { return Expected::head; }
template <> constexpr Expected expected<loop_in>() { return Expected::loop_in; }
template <> constexpr Expected expected<parameters>() { return Expected::parameters; }
template <> constexpr Expected expected<parameter_list>() { return Expected::parameters; }
template <> constexpr Expected expected<function_body>() { return Expected::function_body; }
template <> constexpr Expected expected<arrow>() { return Expected::arrow; }
template <> constexpr Expected expected<path>() { return Expected::path; }
template <> constexpr Expected expected<use_as>() { return Expected::use_as; }
template <> constexpr Expected expected<claim_t>() { return Expected::claim_t; }
template <> constexpr Expected expected<param_value>() { return Expected::param_value; }
template <> constexpr Expected expected<string_rest>() { return Expected::string_end; }
template <> constexpr Expected expected<comment_rest>() { return Expected::comment_end; }
// clang-format on

/// PEGTL's control, with our own error messages.
template <typename Rule>
struct control : peg::normal<Rule> {
  template <typename Input>
  [[noreturn]] static void raise(const Input& in, ParseState& state) {
    state.fail(expected<Rule>(), static_cast<std::uint32_t>(in.current() - in.begin()));
  }
};

} // namespace rt::lang::grammar
