#pragma once

#include "lang/syntax/grammar.hpp"
#include "lang/text/characters.hpp"
#include "lang/text/literals.hpp"

#include <cmath>

/// What happens when a rule has matched: the tree grows. Included by parse.cpp only.
namespace rt::lang::grammar {

template <typename Rule>
struct action : peg::nothing<Rule> {};

/// Actions that need the place of the match derive from this, and define `at(state, begin, end)`.
template <typename Derived>
struct placed {
  template <typename Input>
  static void apply(const Input& in, ParseState& state) {
    const char* const text = state.text.data();
    Derived::at(state, static_cast<std::uint32_t>(in.begin() - text), static_cast<std::uint32_t>(in.end() - text));
  }
};

// Lexis

template <>
struct action<word> : placed<action<word>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) { state.read_word(begin, end); }
};

template <>
struct action<hash_comment> : placed<action<hash_comment>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t) {
    state.report(errors::hash_comment(state.span(begin, begin + 1), "`#` begins a colour, not a comment",
                                      "comments begin with `//`"));
  }
};

template <>
struct action<number> : placed<action<number>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) { state.number(begin, end); }
};

template <>
struct action<plain_number> : placed<action<plain_number>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    const NumberLiteral literal = read_signed_number(state.text.substr(begin, end - begin));
    const std::uint32_t last = begin + literal.length;
    if (std::isinf(literal.value))
      return state.number(begin + (is_sign(state.text[begin]) ? 1 : 0), last); // reports it
    state.build.number(begin, last, literal.value);
  }
};

template <>
struct action<plain_name> {
  static void apply0(ParseState& state) { state.build.name(state.last.begin, state.last.end, state.symbol()); }
};

template <>
struct action<string_literal> : placed<action<string_literal>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    const std::string_view text = state.text.substr(begin, end - begin);
    std::vector<std::uint32_t> bad_escapes;
    state.build.string(begin, end, read_string(text.substr(1, text.size() - 2), bad_escapes));
    for (const std::uint32_t offset : bad_escapes) state.report(bad_escape(state.span(begin, end), text, offset + 1));
  }
};
template <>
struct action<path> : action<string_literal> {};

template <>
struct action<single_quoted> : placed<action<single_quoted>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    const std::string_view inner = state.text.substr(begin + 1, end - begin - 2);
    state.report(errors::wrong_quotes(state.span(begin, end), "strings are written in double quotes",
                                      "write `\"" + std::string(inner) + "\"`"));
    state.build.string(begin, end, std::string(inner));
  }
};

template <>
struct action<color> : placed<action<color>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) { state.color(begin, end); }
};

template <>
struct action<true_false_none_name> : placed<action<true_false_none_name>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    switch (state.last.word) {
    case Word::true_:
    case Word::false_:
      return state.build.leaf(Kind::boolean, begin, end, state.last.word == Word::true_ ? 1 : 0);
    case Word::none_:
      return state.build.leaf(Kind::none, begin, end);
    default:
      return state.build.name(begin, end, state.symbol());
    }
  }
};

template <>
struct action<newline_separator> {
  static void apply0(ParseState& state) { state.separator(true); }
};
template <>
struct action<mark_separator> {
  static void apply0(ParseState& state) { state.separator(false); }
};

// Declared names, and the beginnings of constructs

struct declares_name {
  static void apply0(ParseState& state) { state.build.name(state.last.begin, state.last.end, state.symbol()); }
};
template <>
struct action<loop_name> : declares_name {};
template <>
struct action<declared_word> : declares_name {};

struct begins_at_word {
  static void apply0(ParseState& state) { state.build.open(state.last.begin); }
};
template <>
struct action<for_begin> : begins_at_word {};
template <>
struct action<def_begin> : begins_at_word {};
template <>
struct action<fn_begin> : begins_at_word {};
template <>
struct action<param_begin> : begins_at_word {};
template <>
struct action<include_begin> : begins_at_word {};
template <>
struct action<use_begin> : begins_at_word {};
template <>
struct action<lambda_begin> : begins_at_word {};
template <>
struct action<clause_begin> : begins_at_word {};
template <>
struct action<filter_begin> : begins_at_word {};
template <>
struct action<if_begin> : begins_at_word {};

struct begins_here : placed<begins_here> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t) { state.build.open(begin); }
};
template <>
struct action<block_begin> : begins_here {};
template <>
struct action<list_begin> : begins_here {};

// Expressions

template <>
struct action<operators_begin> {
  static void apply0(ParseState& state) { state.build.open_expression(); }
};
template <>
struct action<operators_end> {
  static void apply0(ParseState& state) { state.build.close_expression(); }
};

template <>
struct action<minus> : placed<action<minus>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t) { state.build.prefix(Op::negate, begin); }
};
template <>
struct action<plus_sign> : placed<action<plus_sign>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) { state.plus_sign(begin, end); }
};
template <>
struct action<prefix_not> : placed<action<prefix_not>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    state.complain(state.build.prefix(Op::not_, begin), begin, end);
  }
};
template <>
struct action<foreign_prefix> : placed<action<foreign_prefix>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    state.report(foreign_operator(state.span(begin, end), "!"));
  }
};
template <>
struct action<infix_symbol> : placed<action<infix_symbol>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) { state.infix_symbol(begin, end); }
};
template <>
struct action<infix_word> : placed<action<infix_word>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) { state.infix_word(begin, end); }
};

/// Constructs that end where their rule ends.
template <typename Rule>
struct ends_here : placed<ends_here<Rule>> {
  static void at(ParseState& state, std::uint32_t, std::uint32_t end) { Rule::close(state, end); }
};

struct closes_block {
  static void close(ParseState& state, std::uint32_t end) { state.close_block(end); }
};
struct closes_list {
  static void close(ParseState& state, std::uint32_t end) { state.close_list(end); }
};
struct closes_record {
  static void close(ParseState& state, std::uint32_t end) { state.close_record(end); }
};
template <>
struct action<block> : ends_here<closes_block> {};
template <>
struct action<list> : ends_here<closes_list> {};
template <>
struct action<record> : ends_here<closes_record> {};

template <>
struct action<paren> : placed<action<paren>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    state.build.top().begin = begin;
    state.build.top().end = end;
  }
};

template <>
struct action<comprehension_rest> {
  static void apply0(ParseState& state) { state.build.mark().symbol = comprehension_mark; }
};
struct closes_clause {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_loop(Kind::clause, end); }
};
struct closes_filter {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_filter(end); }
};
template <>
struct action<clause> : ends_here<closes_clause> {};
template <>
struct action<filter> : ends_here<closes_filter> {};

template <>
struct action<property_name> : placed<action<property_name>> {
  static void at(ParseState& state, std::uint32_t, std::uint32_t end) { state.build.member(state.symbol(), end); }
};
struct closes_index {
  static void close(ParseState& state, std::uint32_t end) { state.build.index(end); }
};
template <>
struct action<index> : ends_here<closes_index> {};
template <>
struct action<call_begin> {
  static void apply0(ParseState& state) { state.build.open_suffix(); }
};
struct closes_call {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_counted(Kind::call, end, 1); }
};
template <>
struct action<call> : ends_here<closes_call> {};

struct overrides {
  static void apply0(ParseState& state) { state.build.override_block(); }
};
template <>
struct action<override_block> : overrides {};
template <>
struct action<override_on_new_line> : overrides {};

template <>
struct action<argument_begin> : placed<action<argument_begin>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    if (state.text[end - 1] == '=') {
      const std::string name(state.text.substr(state.last.begin, state.last.end - state.last.begin));
      state.report(errors::equals_for_colon(state.span(end - 1, end), "a named argument is written with `:`",
                                            "write `" + name + ": …`"));
    }
    state.build.open(begin, state.symbol());
  }
};
template <>
struct action<named_argument> {
  static void apply0(ParseState& state) { state.build.close_named(Kind::argument); }
};

template <>
struct action<else_if_begin> {
  static void apply0(ParseState& state) { state.build.open(state.last.begin, chained_if); }
};
template <>
struct action<if_expression> : placed<action<if_expression>> {
  static void at(ParseState& state, std::uint32_t, std::uint32_t end) { state.close_if(end); }
};

template <>
struct action<parameter_name> : placed<action<parameter_name>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    state.build.open(begin);
    state.build.name(begin, end, state.symbol());
  }
};
template <>
struct action<default_sign> : placed<action<default_sign>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    if (state.text[begin] != ':') return;
    state.report(errors::equals_for_colon(state.span(begin, end), "a default value is written with `=`"));
  }
};
struct closes_parameter {
  static void close(ParseState& state, std::uint32_t end) {
    if (state.build.parts() == 1) state.build.nothing(end);
    state.build.close_pair(Kind::parameter, state.build.top().end);
  }
};
template <>
struct action<parameter> : ends_here<closes_parameter> {};
template <>
struct action<no_parameters> : placed<action<no_parameters>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t) {
    state.report(errors::missing_parameters(state.span(begin, begin + 1), "the parameters are missing",
                                            "write `()` before it where there are none"));
  }
};

/// `=` instead of `=>` and vice versa.
template <>
struct action<arrow> : placed<action<arrow>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    if (end - begin == 2) return;
    state.report(
        errors::misplaced_arrow(state.span(begin, end), "a function without a name needs `=>`", "`fn (x) => x * x`"));
  }
};
template <>
struct action<function_sign> : placed<action<function_sign>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t end) {
    if (end - begin == 1) return;
    state.report(
        errors::misplaced_arrow(state.span(begin, end), "`=>` belongs to a function without a name", "write `=`"));
  }
};
struct closes_lambda {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_function(Kind::lambda, end); }
};
template <>
struct action<lambda> : ends_here<closes_lambda> {};

} // namespace rt::lang::grammar
