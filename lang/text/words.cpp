#include "lang/text/words.hpp"

namespace rt::lang {

namespace {

Word one_of(std::string_view word, std::string_view spelling, Word meaning) {
  return word == spelling ? meaning : Word::plain;
}

Word one_of(std::string_view word, std::string_view first, Word first_meaning, std::string_view second,
            Word second_meaning) {
  return word == first ? first_meaning : one_of(word, second, second_meaning);
}

Word starting_with_f(std::string_view word) {
  if (word == "fn") return Word::fn_;
  if (word == "for") return Word::for_;
  if (word == "false") return Word::false_;
  if (word == "function" || word == "func" || word == "fun") return Word::foreign_function;
  return Word::plain;
}

Word starting_with_i(std::string_view word) {
  if (word == "include") return Word::include_;
  return one_of(word, "if", Word::if_, "in", Word::in_);
}

} // namespace

// By the first letter, because this is called for every word of a scene.
Word classify(std::string_view word) {
  if (word.size() < 2 || word.size() > 8) return Word::plain;
  switch (word[0]) {
  case 'a':
    return one_of(word, "and", Word::and_, "as", Word::as_);
  case 'b':
    return one_of(word, "by", Word::by_);
  case 'c':
    return one_of(word, "const", Word::foreign_variable);
  case 'd':
    return one_of(word, "def", Word::def_);
  case 'e':
    return one_of(word, "else", Word::else_, "expect", Word::expect_);
  case 'f':
    return starting_with_f(word);
  case 'i':
    return starting_with_i(word);
  case 'l':
    return one_of(word, "let", Word::foreign_variable, "local", Word::foreign_variable);
  case 'n':
    return one_of(word, "not", Word::not_, "none", Word::none_);
  case 'o':
    return one_of(word, "or", Word::or_);
  case 'p':
    return one_of(word, "param", Word::param_);
  case 't':
    return one_of(word, "true", Word::true_);
  case 'u':
    return one_of(word, "use", Word::use_);
  case 'v':
    return one_of(word, "var", Word::foreign_variable, "val", Word::foreign_variable);
  default:
    return Word::plain;
  }
}

std::string_view spelling(Word word) {
  switch (word) {
  case Word::and_:
    return "and";
  case Word::or_:
    return "or";
  case Word::not_:
    return "not";
  case Word::if_:
    return "if";
  case Word::else_:
    return "else";
  case Word::for_:
    return "for";
  case Word::in_:
    return "in";
  case Word::by_:
    return "by";
  case Word::def_:
    return "def";
  case Word::fn_:
    return "fn";
  case Word::use_:
    return "use";
  case Word::as_:
    return "as";
  case Word::include_:
    return "include";
  case Word::param_:
    return "param";
  case Word::true_:
    return "true";
  case Word::false_:
    return "false";
  case Word::none_:
    return "none";
  case Word::expect_:
    return "expect";
  case Word::plain:
  case Word::foreign_variable:
  case Word::foreign_function:
    break;
  }
  return "";
}

} // namespace rt::lang
