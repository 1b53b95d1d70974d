#pragma once

#include "lang/syntax/parse_state.hpp"

#include <tao/pegtl.hpp>

/// The grammar of the language, included by parse.cpp only. Every rule decides by lookahead, so that actions never have
/// to be undone except after an error; operator precedence is left to the builder.
namespace rt::lang::grammar {

namespace peg = tao::pegtl;
using peg::at, peg::eof, peg::not_at, peg::one, peg::opt, peg::plus, peg::seq, peg::sor, peg::star, peg::string,
    peg::success, peg::until;

// Rules that depend on what has been read -------------------------------------------------------------------------

/// Matches, consuming nothing, if the state says so.
template <auto Question>
struct when {
  using rule_t = when;
  using subs_t = peg::empty_list;
  template <peg::apply_mode, peg::rewind_mode, template <typename...> class, template <typename...> class,
            typename Input>
  static bool match(Input&, ParseState& state) {
    return (state.*Question)();
  }
};

template <Word W>
struct is {
  using rule_t = is;
  using subs_t = peg::empty_list;
  template <peg::apply_mode, peg::rewind_mode, template <typename...> class, template <typename...> class,
            typename Input>
  static bool match(Input&, ParseState& state) {
    return state.last.word == W;
  }
};

/// At a place that looks like the next item although the previous one is not complete.
struct item_here {
  using rule_t = item_here;
  using subs_t = peg::empty_list;
  template <peg::apply_mode, peg::rewind_mode, template <typename...> class, template <typename...> class,
            typename Input>
  static bool match(Input& in, ParseState& state) {
    return looks_like_item(state.text, static_cast<std::uint32_t>(in.current() - in.begin()));
  }
};

/// What is required here: if it is missing, the item is broken, and `expected<Rule>` (grammar_errors.hpp) says why.
template <typename Rule>
struct required {
  using rule_t = required;
  using subs_t = peg::type_list<Rule>;
  template <peg::apply_mode A, peg::rewind_mode, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, ParseState& state) {
    const auto begin = in.iterator();
    if (Control<Rule>::template match<A, peg::rewind_mode::dontcare, Action, Control>(in, state)) return true;
    in.iterator() = begin;
    Control<Rule>::raise(in, state);
  }
};

/// Limits the nesting depth of the rule, so that no input overflows the stack.
template <typename Rule>
struct nested {
  using rule_t = nested;
  using subs_t = peg::type_list<Rule>;
  template <peg::apply_mode A, peg::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, ParseState& state) {
    state.deeper(static_cast<std::uint32_t>(in.current() - in.begin()));
    const bool matched = Control<Rule>::template match<A, M, Action, Control>(in, state);
    state.shallower();
    return matched;
  }
};

/// The head of `for` and `if`: the brace after it begins the body, never an override.
template <typename Rule>
struct before_block {
  using rule_t = before_block;
  using subs_t = peg::type_list<Rule>;
  template <peg::apply_mode A, peg::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, ParseState& state) {
    const bool before = state.without_block();
    const bool matched = Control<Rule>::template match<A, M, Action, Control>(in, state);
    state.set_block_may_follow(before);
    return matched;
  }
};

struct wide_gap;

/// Brackets and their contents. If the closing one is missing the state decides whether to recover.
template <char Open, char Close, typename Content>
struct bracketed {
  using rule_t = bracketed;
  using subs_t = peg::type_list<Content>;
  template <peg::apply_mode A, peg::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, ParseState& state) {
    if (in.empty() || *in.current() != Open) return false;
    const auto offset = [&] { return static_cast<std::uint32_t>(in.current() - in.begin()); };
    const ParseState::Modes modes = state.enter(offset(), Open);
    in.bump_in_this_line();
    (void)Control<Content>::template match<A, M, Action, Control>(in, state);
    const auto before = in.iterator();
    (void)Control<wide_gap>::template match<A, M, Action, Control>(in, state);
    if (!in.empty() && *in.current() == Close) {
      in.bump_in_this_line();
    } else if (state.not_closed(static_cast<std::uint32_t>(before - in.begin()), offset()) ==
               ParseState::Closing::consume) {
      in.bump_in_this_line();
    } else {
      in.iterator() = before;
    }
    state.leave(modes);
    return true;
  }
};

/// An item, or an error node in its place, up to the next separator or closing brace.
template <typename Rule>
struct recovered {
  using rule_t = recovered;
  using subs_t = peg::type_list<Rule>;
  template <peg::apply_mode A, peg::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, ParseState& state) {
    const auto begin = static_cast<std::uint32_t>(in.current() - in.begin());
    if (const auto end = state.repeat_item(begin)) {
      in.bump(*end - begin);
      return true;
    }
    const ParseState::Checkpoint checkpoint = state.begin_item(begin);
    try {
      (void)Control<required<Rule>>::template match<A, M, Action, Control>(in, state);
      state.finish_item(checkpoint);
    } catch (const SyntaxError& error) {
      if (error.is_fatal) throw;
      in.iterator() = in.begin() + state.replace_item(checkpoint, begin, error);
    } catch (const TooDeep& deep) {
      state.too_deep(deep.begin, deep.end);
      throw SyntaxError{deep.end, true};
    }
    return true;
  }
};

// Lexis -----------------------------------------------------------------------------------------------------------

struct blank : one<' ', '\t', '\r'> {};
struct newline : one<'\n'> {};
struct hash_comment // an error
    : seq<one<'#'>, at<sor<one<' ', '\t', '\r', '\n', '!', '#', '-', '='>, eof>>, until<at<sor<newline, eof>>>> {};
struct line_comment : seq<string<'/', '/'>, until<at<sor<newline, eof>>>> {};
struct comment_rest : until<string<'*', '/'>> {};
struct block_comment : seq<string<'/', '*'>, required<comment_rest>> {};
struct comment : seq<at<one<'/', '#'>>, sor<line_comment, block_comment, hash_comment>> {};
// Comments are rare: blanks are tried first.
struct narrow_gap : seq<star<blank>, opt<at<one<'/', '#'>>, star<sor<comment, blank>>>> {};
struct wide_gap : seq<star<sor<blank, newline>>, opt<at<one<'/', '#'>>, star<sor<comment, blank, newline>>>> {};
struct gap : sor<seq<when<&ParseState::newline_is_space>, wide_gap>, narrow_gap> {};

struct word : peg::identifier {};
struct plain_word : seq<word, when<&ParseState::word_is_plain>> {};
template <Word W>
struct keyword : seq<word, is<W>> {};

struct digits : plus<peg::digit> {};
struct fraction : seq<one<'.'>, digits> {};
struct exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, digits> {};
/// `1.`, but neither the range `1..2` nor the member `1.x`.
struct bare_point : seq<one<'.'>, sor<at<exponent>, not_at<sor<one<'.'>, peg::identifier_first>>>> {};
struct decimal : seq<sor<seq<digits, opt<sor<fraction, bare_point>>>, fraction>, opt<exponent>> {};
struct suffix_word : plus<peg::identifier_other> {}; // a unit, or an error
struct number : seq<decimal, opt<suffix_word>> {};

struct string_rest : seq<star<sor<seq<one<'\\'>, peg::not_one<'\n'>>, peg::not_one<'"', '\n', '\\'>>>, one<'"'>> {};
struct string_literal : seq<one<'"'>, required<string_rest>> {};
struct single_quoted : seq<one<'\''>, star<peg::not_one<'\'', '\n'>>, one<'\''>> {}; // an error
struct color : seq<one<'#'>, plus<peg::identifier_other>> {};

struct equals : seq<one<'='>, not_at<one<'=', '>'>>> {};
struct colon : one<':'> {};
struct comma : one<',', ';'> {};

// Separators of blocks and lists. A newline, a comma and a semicolon are equivalent.
struct newlines : seq<newline, wide_gap> {};
struct newline_separator : newlines {};
struct mark_separator : seq<opt<newlines>, comma, wide_gap> {};
struct separator : seq<narrow_gap, sor<mark_separator, newline_separator>> {};

// Expressions -----------------------------------------------------------------------------------------------------

struct expression;
struct items;

struct block_begin : at<one<'{'>> {};
struct block : seq<block_begin, bracketed<'{', '}', items>> {};
struct misplaced_brace : seq<narrow_gap, newlines, at<one<'{'>>> {}; // an error
/// The mandatory block of a construct.
struct own_block : seq<gap, opt<misplaced_brace>, block> {};

struct record : seq<when<&ParseState::block_may_follow>, block_begin, bracketed<'{', '}', items>> {};

template <typename Item>
struct comma_separated : seq<gap, opt<Item, star<gap, comma, gap, Item>, opt<gap, comma>>> {};

struct loop_name : plain_word {};
struct loop_in : keyword<Word::in_> {};
struct head : before_block<expression> {};
struct loop_names : seq<required<loop_name>, opt<gap, one<','>, gap, required<loop_name>>> {};

struct clause_begin : keyword<Word::for_> {};
struct clause : seq<clause_begin, gap, loop_names, gap, required<loop_in>, wide_gap, required<expression>> {};
struct filter_begin : keyword<Word::if_> {};
struct filter : seq<filter_begin, wide_gap, required<expression>> {};
struct comprehension_rest : seq<clause, star<wide_gap, sor<clause, filter>>> {};

// Fast paths for values that stand alone: most are numbers and names with nothing after them. All of it could be parsed
// as an expression, to the same effect.
struct plain_number_text : seq<opt<one<'-', '+'>>, decimal, not_at<sor<peg::identifier_other, one<'.'>>>> {};
struct plain_number : seq<plain_number_text, star<blank>, at<one<',', ']', '}', '\n', ';'>>> {};
struct plain_name : seq<plain_word, star<blank>, at<one<',', ']', '}', ';'>>> {};
struct value : sor<plain_number, plain_name, expression> {};

/// What follows may be on the next line, if that line does not look like a separate item.
struct next_line : seq<newlines, not_at<item_here>> {};
struct value_gap : seq<narrow_gap, opt<at<newline>, required<next_line>>> {};

struct list_begin : at<one<'['>> {};
struct more_elements : star<separator, not_at<one<']', '}', ')'>>, not_at<when<&ParseState::follows_line>, item_here>,
                            not_at<eof>, required<value>> {};
struct list_content
    : seq<wide_gap, opt<not_at<one<']'>>, required<value>, sor<seq<wide_gap, comprehension_rest>, more_elements>,
                        opt<separator, at<one<']'>>>>> {};
struct list : seq<list_begin, bracketed<'[', ']', list_content>> {};

struct paren : bracketed<'(', ')', seq<wide_gap, required<expression>>> {};

struct true_false_none_name : seq<word, when<&ParseState::word_is_primary>> {};
struct primary : sor<number, true_false_none_name, string_literal, list, paren, color, record, single_quoted> {};

struct argument_begin : seq<plain_word, gap, sor<colon, equals>> {};
struct argument_value : seq<wide_gap, required<expression>> {};
struct named_argument : seq<argument_begin, argument_value> {};
struct argument : sor<named_argument, seq<not_at<one<')', ']', '}'>>, not_at<eof>, required<expression>>> {};
struct call_begin : at<one<'('>> {};
struct call : seq<call_begin, bracketed<'(', ')', comma_separated<argument>>> {};

struct index : bracketed<'[', ']', seq<wide_gap, required<expression>>> {};

struct property_name : plain_word {};
struct member : seq<one<'.'>, not_at<one<'.'>>, required<property_name>> {};
struct override_block : seq<when<&ParseState::block_may_follow>, block> {};
struct suffix : seq<at<one<'(', '[', '.', '{'>>, sor<call, index, member, override_block>> {};
/// A line that begins with a dot continues the previous one; a line that begins with a brace is meant to.
struct dot_on_new_line : seq<at<one<'.'>, peg::identifier_first>, member> {};
struct brace_on_new_line : at<one<'{'>> {}; // an error
struct override_on_new_line : seq<when<&ParseState::brace_may_be_misplaced>, brace_on_new_line, block> {};
struct suffix_on_new_line : seq<narrow_gap, at<newline>, newlines, sor<dot_on_new_line, override_on_new_line>> {};
struct any_suffix : sor<seq<gap, suffix>, suffix_on_new_line> {};
struct suffixes : star<any_suffix> {};

struct minus : one<'-'> {};
struct prefix_not : keyword<Word::not_> {};
struct plus_sign : seq<one<'+'>, not_at<one<'='>>> {};      // the second of `++` is an error
struct foreign_prefix : seq<one<'!'>, not_at<one<'='>>> {}; // an error
struct prefix : sor<minus, plus_sign, seq<at<one<'n'>>, prefix_not>, foreign_prefix> {};

struct operand_rest : seq<primary, suffixes> {};
struct operand : sor<seq<plus<prefix, wide_gap>, required<operand_rest>>, operand_rest> {};

struct infix_symbol : sor<string<'.', '.', '.'>, string<'.', '.', '<'>, string<'.', '.'>, string<'=', '='>,
                          string<'!', '='>, string<'<', '='>, string<'>', '='>, string<'&', '&'>, string<'|', '|'>,
                          string<'*', '*'>, equals, one<'+', '-', '*', '/', '%', '^', '|', '&', '<', '>'>> {};
struct infix_word : seq<word, when<&ParseState::word_is_infix>> {};
struct infix : sor<seq<at<one<'.', '=', '!', '<', '>', '&', '|', '+', '-', '*', '/', '%', '^'>>, infix_symbol>,
                   seq<at<one<'a', 'b', 'o'>>, infix_word>> {};
struct operators_rest : star<gap, infix, value_gap, required<operand>> {};
struct operators_begin : success {};
struct operators_end : success {};
struct operators : seq<operators_begin, operand, operators_rest, operators_end> {};

struct if_begin : keyword<Word::if_> {};
struct else_word : seq<gap, keyword<Word::else_>> {};
struct else_on_new_line : seq<narrow_gap, newlines, keyword<Word::else_>> {}; // an error
struct any_else : sor<else_word, else_on_new_line> {};
struct else_if_begin : seq<any_else, gap, keyword<Word::if_>> {};
struct else_block : seq<any_else, gap, required<own_block>> {};
struct if_expression : seq<if_begin, wide_gap, required<head>, required<own_block>,
                           star<else_if_begin, wide_gap, required<head>, required<own_block>>, opt<else_block>> {};

struct declared_word : plain_word {};
struct default_sign : sor<equals, colon> {}; // the colon is an error
struct default_value : seq<gap, default_sign, wide_gap, required<expression>> {};
struct parameter_name : plain_word {};
struct parameter : seq<not_at<one<')', '{'>>, not_at<eof>, required<parameter_name>, opt<default_value>> {};
struct parameter_list : bracketed<'(', ')', comma_separated<parameter>> {};
struct no_parameters : at<sor<one<'{', '='>, seq<newlines, one<'{'>>>> {}; // an error
struct parameters : sor<parameter_list, no_parameters> {};

struct arrow : sor<string<'=', '>'>, equals> {}; // `=` is an error
struct lambda_begin : keyword<Word::fn_> {};
struct lambda : seq<lambda_begin, gap, required<parameter_list>, gap, required<arrow>, wide_gap, required<expression>> {
};

struct expression : sor<seq<at<one<'i'>>, nested<if_expression>>, seq<at<one<'f'>>, nested<lambda>>, operators> {};

// Items -----------------------------------------------------------------------------------------------------------

struct for_begin : is<Word::for_> {};
struct for_item
    : seq<for_begin, gap, loop_names, gap, required<loop_in>, wide_gap, required<head>, required<own_block>> {};

struct def_begin : is<Word::def_> {};
struct def_item : seq<def_begin, gap, required<declared_word>, gap, required<parameters>, required<own_block>> {};

struct function_sign : sor<equals, string<'=', '>'>> {}; // `=>` is an error
struct function_body : sor<seq<function_sign, wide_gap, required<expression>>, own_block> {};
struct function_rest : seq<gap, required<declared_word>, gap, required<parameters>, gap, required<function_body>> {};
struct fn_begin : seq<is<Word::fn_>, at<gap, peg::identifier_first>> {};
struct fn_item : seq<fn_begin, function_rest> {};
struct foreign_function // an error
    : seq<is<Word::foreign_function>, at<gap, peg::identifier, gap, one<'('>>> {};
struct foreign_function_item : seq<foreign_function, function_rest> {};

struct path : string_literal {};
struct include_begin : is<Word::include_> {};
struct include_item : seq<include_begin, gap, required<path>> {};
struct use_begin : is<Word::use_> {};
struct use_as : keyword<Word::as_> {};
struct use_item : seq<use_begin, gap, required<path>, gap, required<use_as>, gap, required<declared_word>> {};

struct param_begin : is<Word::param_> {};
struct param_value : equals {};
struct param_range : seq<gap, keyword<Word::in_>, wide_gap, required<expression>> {};
struct param_item : seq<param_begin, gap, required<declared_word>, gap, required<param_value>, wide_gap,
                        required<expression>, opt<param_range>> {};

// `hits`, `misses`, `at t` and `within` are keywords only in an `expect`.
template <char... C>
struct claim_word : seq<string<C...>, not_at<peg::identifier_other>> {};
struct expect_begin : is<Word::expect_> {};
struct claims_near : one<'~'> {};
struct claims_hit : claim_word<'h', 'i', 't', 's'> {};
struct claims_miss : claim_word<'m', 'i', 's', 's', 'e', 's'> {};
struct claim_ends : sor<one<'\n', ',', ';', '}'>, claim_word<'w', 'i', 't', 'h', 'i', 'n'>, eof> {};
struct claim : sor<seq<claims_near, wide_gap, required<expression>>, seq<claims_hit, gap, required<expression>>,
                   seq<claims_miss, opt<gap, not_at<claim_ends>, required<expression>>>> {};
struct claim_at : claim_word<'a', 't'> {};
struct claim_t : claim_word<'t'> {};
struct claim_parameter : seq<claim_at, gap, required<claim_t>, gap, required<expression>> {};
struct claim_within : claim_word<'w', 'i', 't', 'h', 'i', 'n'> {};
struct claim_tolerance : seq<claim_within, gap, required<expression>> {};
struct without_other : success {};
struct without_parameter : success {};
struct without_tolerance : success {};
struct expect_item : seq<expect_begin, gap, required<expression>, opt<gap, claim>, without_other,
                         opt<gap, claim_parameter>, without_parameter, opt<gap, claim_tolerance>, without_tolerance> {};

struct foreign_variable : seq<is<Word::foreign_variable>, at<gap, peg::identifier, gap, equals>> {}; // an error
struct property_colon : colon {};
struct property_item : seq<property_colon, value_gap, required<value>> {};
struct bind_sign : equals {};
struct bind_item : seq<bind_sign, value_gap, required<value>> {};
struct name_first : success {};
/// An expression whose first word, a name, has already been read.
struct named_expression : seq<name_first, suffixes, operators_rest, operators_end> {};
struct named_item : seq<opt<foreign_variable, gap, word>, when<&ParseState::word_is_plain>, gap,
                        sor<property_item, bind_item, named_expression>> {};

/// If a later kind of item begins with a reserved word, it joins the first list.
struct reserved_item : seq<when<&ParseState::word_is_reserved>,
                           sor<for_item, def_item, fn_item, include_item, use_item, param_item, expect_item>> {};
struct word_item : seq<word, sor<reserved_item, foreign_function_item, named_item>> {};

struct previous_begin : seq<when<&ParseState::may_edit_previous>, at<one<'.'>, peg::identifier_first>> {};
struct previous_item : seq<previous_begin, plus<any_suffix>, operators_rest, operators_end> {};

struct item_begin : seq<sor<not_at<one<'-', '+'>>, not_at<when<&ParseState::follows_line>>>,
                        not_at<when<&ParseState::begins_with_bare_value>>> {};
struct item_end : at<narrow_gap, sor<one<'\n', ',', ';', '}'>, eof>> {};
struct item : seq<required<item_begin>, sor<word_item, previous_item, expression>, required<item_end>> {};

struct items_begin : success {};
struct items_end : sor<eof, seq<when<&ParseState::is_in_braces>, one<'}'>>> {};
struct items : seq<items_begin, wide_gap, star<not_at<items_end>, recovered<item>, narrow_gap, opt<separator>>> {};

struct file : seq<items, eof> {};
struct end_of_expression : eof {};
struct single_expression : seq<wide_gap, required<expression>, wide_gap, required<end_of_expression>> {};

} // namespace rt::lang::grammar
