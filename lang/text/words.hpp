#pragma once

#include <cstdint>
#include <string_view>

namespace rt::lang {

/// What a word is to the grammar.
enum class Word : std::uint8_t {
  plain, ///< a name
  and_,
  or_,
  not_,
  if_,
  else_,
  for_,
  in_,
  by_,
  def_,
  fn_,
  use_,
  as_,
  include_,
  param_,
  true_,
  false_,
  none_,
  expect_,
  // Plain words that begin a declaration in other languages; here they are ordinary names
  foreign_variable, ///< let, var, const, local, val
  foreign_function, ///< function, func, fun
};

/// Classifies a word; the whole word must be given.
Word classify(std::string_view word);

constexpr bool is_reserved(Word word) {
  return word != Word::plain && word < Word::foreign_variable;
}

/// The words that cannot be names, in the order of `Word`.
std::string_view spelling(Word word);

} // namespace rt::lang
