// What comes from other languages, and from word processors.

#include "lang/syntax/errors/syntax_errors.hpp"
#include "lang/text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rt::lang {

namespace {

using namespace std::string_view_literals;

struct ForeignWord {
  std::string_view word, way_out;
};

constexpr std::array statements{
    ForeignWord{"while", "`for i in 0..9 { … }` repeats"},
    ForeignWord{"repeat", "`for i in 1..10 { … }` repeats"},
    ForeignWord{"foreach", "`for x in xs { … }`"},
    ForeignWord{"return", "the last line of a function's block is its value"},
    ForeignWord{"switch", "`if a { … } else if b { … } else { … }`"},
    ForeignWord{"import", "`include \"file.rtl\"`, or `use \"file.rtl\" as name`"},
    ForeignWord{"module", "`def name(width = 1) { … }` makes a noun"},
    ForeignWord{"class", "`def name(width = 1) { … }` makes a noun"},
    ForeignWord{"define", "`name = value`, or `def name() { … }`"},
    ForeignWord{"elif", "`else if`, on the line of the closing brace"},
    ForeignWord{"elsif", "`else if`, on the line of the closing brace"},
    ForeignWord{"elseif", "`else if`, on the line of the closing brace"},
    ForeignWord{"then", "`if condition { … }`"},
    ForeignWord{"object", "a thing's own name places it: `table { width: 3 }`"},
};

// POV-Ray's.
constexpr std::array directives{"declare"sv, "local"sv,  "include"sv, "version"sv, "macro"sv,  "while"sv,
                                "if"sv,      "else"sv,   "end"sv,     "for"sv,     "define"sv, "default"sv,
                                "ifdef"sv,   "ifndef"sv, "switch"sv,  "undef"sv};

// Characters that look like one of the language.
Diagnostic look_alike(Span span, std::string_view c, char32_t code) {
  if (code >= 0x2018 && code <= 0x201f) {
    return errors::meaningless_character(span, "typographic quotes do not delimit a string", "write `\"`");
  }
  if (code == 0xa0)
    return errors::meaningless_character(span, "a no-break space does not count as a space here",
                                         "type the space again");
  if (code == 0x2212 || code == 0x2013) {
    return errors::meaningless_character(span, fmt::format("`{}` is not a minus sign", c), "write `-`");
  }
  if (code == 0xd7 || code == 0xb7) {
    return errors::meaningless_character(span, fmt::format("`{}` is not an operator", c), "write `*`");
  }
  if (is_control(code)) {
    return errors::meaningless_character(
        span, fmt::format("a control character (U+{:04X}) stands here", std::uint32_t{code}));
  }
  return errors::meaningless_character(
      span, fmt::format("`{}` has no meaning here", c),
      code < 0x80 ? "" : "names are made of a-z, A-Z, 0-9 and _; other letters stand in strings and comments");
}

} // namespace

std::optional<Diagnostic> foreign_word(Span span, std::string_view word) {
  const auto* const found =
      std::find_if(statements.begin(), statements.end(), [&](const ForeignWord& f) { return f.word == word; });
  if (found == statements.end()) return std::nullopt;
  return errors::foreign_statement(span, fmt::format("there is no `{}` here", word), std::string(found->way_out));
}

Diagnostic unknown_character(Span span, std::string_view c) {
  if (c == "'") return errors::wrong_quotes(span, "strings are written in double quotes", "`\"text\"`");
  if (c == "?") {
    return errors::foreign_operator(span, "there is no `?` here", "`if condition { a } else { b }` chooses a value");
  }
  if (c == "~") {
    return errors::foreign_operator(span, "there is no `~` here",
                                    "`expect a ~ b` compares approximately, and nothing else does");
  }
  if (c == "!") return errors::foreign_operator(span, "there is no `!` here", "write `not`");
  return look_alike(span, c, decode(c).code_point);
}

Diagnostic misplaced_hash(Span span, std::string_view text) {
  const std::string_view word = text.substr(1);
  if (std::find(directives.begin(), directives.end(), word) == directives.end()) {
    return errors::hash_comment(span, "`#` begins a colour, not a comment", "comments begin with `//`");
  }
  const bool declares = word == "declare" || word == "local";
  return errors::foreign_statement(span, fmt::format("`#{}` is not a statement here", word),
                                   declares            ? "`name = value` gives a value a name"
                                   : word == "include" ? "`include \"file.rtl\"`"
                                                       : "there are no directives");
}

} // namespace rt::lang
