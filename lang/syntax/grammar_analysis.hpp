#pragma once

#include "lang/syntax/grammar.hpp"

#include <tao/pegtl/contrib/analyze.hpp>

/// For PEGTL's `analyze`: which of our own rules consume input.
namespace tao::pegtl {
namespace grammar_of_scenes = rt::lang::grammar;

template <typename Name, auto Question>
struct analyze_traits<Name, grammar_of_scenes::when<Question>> : analyze_opt_traits<> {};
template <typename Name, rt::lang::Word W>
struct analyze_traits<Name, grammar_of_scenes::is<W>> : analyze_opt_traits<> {};
template <typename Name>
struct analyze_traits<Name, grammar_of_scenes::item_here> : analyze_opt_traits<> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, grammar_of_scenes::required<Rule>> : analyze_seq_traits<Rule> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, grammar_of_scenes::nested<Rule>> : analyze_seq_traits<Rule> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, grammar_of_scenes::before_block<Rule>> : analyze_seq_traits<Rule> {};
template <typename Name, char Open, char Close, typename Content>
struct analyze_traits<Name, grammar_of_scenes::bracketed<Open, Close, Content>>
    : analyze_seq_traits<one<Open>, Content, one<Close>> {};
template <typename Name, typename Rule>
struct analyze_traits<Name, grammar_of_scenes::recovered<Rule>> : analyze_seq_traits<Rule> {};

} // namespace tao::pegtl
