#pragma once

#include "lang/syntax/grammar_actions.hpp"

/// The actions of a block's items. Included by parse.cpp only.
namespace rt::lang::grammar {

// A brace or an `else` on a line of its own

struct brace_stands_alone : placed<brace_stands_alone> {
  static void at(ParseState& state, std::uint32_t, std::uint32_t end) {
    state.report(errors::line_begins_with_brace(state.span(end, end + 1), "a line cannot begin with `{`",
                                                "it stands on the line of what it belongs to"));
  }
};
template <>
struct action<misplaced_brace> : brace_stands_alone {};
template <>
struct action<brace_on_new_line> : brace_stands_alone {};
template <>
struct action<else_on_new_line> : placed<action<else_on_new_line>> {
  static void at(ParseState& state, std::uint32_t, std::uint32_t end) {
    state.report(errors::else_without_if(state.span(end - 4, end), "a line cannot begin with `else`",
                                         "it stands on the line of the brace before it"));
  }
};

// Items

template <>
struct action<items_begin> {
  static void apply0(ParseState& state) { state.begin_items(); }
};
template <>
struct action<foreign_variable> : placed<action<foreign_variable>> {
  static void at(ParseState& state, std::uint32_t, std::uint32_t) {
    state.report(errors::foreign_statement(state.span(state.last.begin, state.last.end),
                                           "no word comes before the name that is bound", "write `name = value`"));
  }
};
template <>
struct action<foreign_function> {
  static void apply0(ParseState& state) {
    state.report(errors::foreign_statement(state.span(state.last.begin, state.last.end),
                                           "a function is declared with `fn`", "`fn name(x) = x * x`"));
    state.build.open(state.last.begin);
  }
};
template <>
struct action<property_colon> {
  static void apply0(ParseState& state) { state.build.open(state.last.begin, state.symbol()); }
};
template <>
struct action<property_item> {
  static void apply0(ParseState& state) { state.build.close_named(Kind::property); }
};
template <>
struct action<bind_sign> {
  static void apply0(ParseState& state) {
    state.build.open(state.last.begin);
    state.build.name(state.last.begin, state.last.end, state.symbol());
  }
};
template <>
struct action<bind_item> {
  static void apply0(ParseState& state) { state.build.close_pair(Kind::bind, state.build.top().end); }
};
template <>
struct action<name_first> {
  static void apply0(ParseState& state) {
    state.build.open_expression();
    state.build.name(state.last.begin, state.last.end, state.symbol());
  }
};
template <>
struct action<previous_begin> : placed<action<previous_begin>> {
  static void at(ParseState& state, std::uint32_t begin, std::uint32_t) {
    state.build.open_expression();
    state.build.leaf(Kind::previous, begin, begin);
  }
};

struct closes_for {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_loop(Kind::for_, end); }
};
struct closes_def {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_function(Kind::def, end); }
};
struct closes_fn {
  static void close(ParseState& state, std::uint32_t) { state.build.close_function(Kind::fn, state.build.top().end); }
};
struct closes_include {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_text(Kind::include, end); }
};
struct closes_use {
  static void close(ParseState& state, std::uint32_t end) { state.build.close_text(Kind::use, end); }
};
struct closes_param {
  static void close(ParseState& state, std::uint32_t end) { state.close_param(end); }
};
template <>
struct action<expect_begin> : begins_at_word {};
template <Claim C>
struct claims {
  static void apply0(ParseState& state) { state.build.mark().symbol = Symbol{static_cast<std::uint32_t>(C)}; }
};
template <>
struct action<claims_near> : claims<Claim::near> {};
template <>
struct action<claims_hit> : claims<Claim::hits> {};
template <>
struct action<claims_miss> : claims<Claim::misses> {};
/// What was omitted among the parts of an `expect`.
template <std::uint32_t Parts>
struct completes_claim {
  static void apply0(ParseState& state) {
    if (state.build.parts() < Parts) state.build.nothing(state.build.top().end);
  }
};
template <>
struct action<without_other> : completes_claim<2> {};
template <>
struct action<without_parameter> : completes_claim<3> {};
template <>
struct action<without_tolerance> : completes_claim<4> {};
struct closes_expect {
  static void close(ParseState& state, std::uint32_t end) { state.close_expect(end); }
};
template <>
struct action<expect_item> : ends_here<closes_expect> {};
template <>
struct action<for_item> : ends_here<closes_for> {};
template <>
struct action<def_item> : ends_here<closes_def> {};
template <>
struct action<function_rest> : ends_here<closes_fn> {};
template <>
struct action<include_item> : ends_here<closes_include> {};
template <>
struct action<use_item> : ends_here<closes_use> {};
template <>
struct action<param_item> : ends_here<closes_param> {};

} // namespace rt::lang::grammar
