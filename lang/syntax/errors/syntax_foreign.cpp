// Syntax of other languages, and characters inserted by word processors.

#include "lang/syntax/errors/syntax_errors.hpp"
#include "lang/text/characters.hpp"
#include "lang/text/tokens.hpp"
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
    ForeignWord{"assert", "`expect length(v) > 1`: `rtlang test` tries it"},
    ForeignWord{"print", "write `print(…)`"},
    ForeignWord{"echo", "write `print(…)`"},
    ForeignWord{"new", "a thing's own name makes it: `sphere { radius: 2 }`"},
    ForeignWord{"object", "a thing's own name places it: `table { width: 3 }`"},
};

constexpr std::array methods{
    ForeignWord{"translate", "write `thing.move([x, y, z])`"}, ForeignWord{"move", "write `thing.move([x, y, z])`"},
    ForeignWord{"rotate", "write `thing.rotate([x, y, z])`"},  ForeignWord{"scale", "write `thing.scale([x, y, z])`"},
    ForeignWord{"mirror", "write `thing.mirror([x, y, z])`"},  ForeignWord{"color", "write `thing { material: red }`"},
};

// What follows the names of POV-Ray's things, in its order.
struct PovrayForm {
  std::string_view theirs, ours;
  std::array<std::string_view, 4> properties;
};
constexpr std::array povray_forms{
    PovrayForm{"sphere", "sphere", {"at", "radius"}},
    PovrayForm{"box", "box", {"from", "to"}},
    PovrayForm{"cylinder", "cylinder", {"from", "to", "radius"}},
    PovrayForm{"cone", "cone", {"from", "radius", "to", "top_radius"}},
    PovrayForm{"plane", "plane", {"normal", "offset"}},
    PovrayForm{"disc", "disc", {"at", "normal", "radius", "hole"}},
    PovrayForm{"triangle", "triangle", {"points"}},
    PovrayForm{"light_source", "light", {"at"}},
};

bool is_vector(std::string_view property) {
  return property == "at" || property == "from" || property == "to" || property == "normal";
}

// The form of the thing whose block the brace opens, if it has one.
const PovrayForm* form_at(std::string_view text, std::uint32_t brace) {
  std::size_t end = brace;
  while (end > 0 && (is_blank(text[end - 1]) || text[end - 1] == '\n')) --end;
  std::size_t begin = end;
  while (begin > 0 && is_name_part(text[begin - 1])) --begin;
  const auto* const form = std::find_if(povray_forms.begin(), povray_forms.end(), [&](const PovrayForm& f) {
    return f.theirs == text.substr(begin, end - begin);
  });
  return form == povray_forms.end() ? nullptr : form;
}

// A vector in short: `y`, `-z`, or a number that stands for all three parts. Empty for anything else.
std::string short_vector(std::string_view text, Token& token) {
  Token last = token;
  const bool is_negative = text_of(text, last) == "-";
  if (is_negative) last = next_token(text, last.end);
  const std::string_view word = text_of(text, last);
  const std::string one = fmt::format("{}{}", is_negative ? "-" : "", last.kind == TokenKind::number ? word : "1");
  if (last.kind != TokenKind::number && word != "x" && word != "y" && word != "z") return {};
  token = next_token(text, last.end);
  const auto part = [&](std::string_view axis) {
    return last.kind == TokenKind::number || word == axis ? std::string_view(one) : "0";
  };
  return fmt::format("[{}, {}, {}]", part("x"), part("y"), part("z"));
}

// The next of POV-Ray's values as it is written here, empty where there is none. Moves `token` behind its comma.
std::string povray_value(std::string_view text, Token& token, bool is_vector) {
  const auto skip_newlines = [&] {
    while (token.kind == TokenKind::newline) token = next_token(text, token.end);
  };
  skip_newlines();
  std::string value;
  if (is_vector && text_of(text, token) != "<") value = short_vector(text, token);
  const bool is_read = !value.empty();
  for (int depth = 0; !is_read && (token.kind == TokenKind::number || token.kind == TokenKind::symbol || depth > 0);
       token = next_token(text, token.end)) {
    const std::string_view word = text_of(text, token);
    if (token.kind == TokenKind::end || token.kind == TokenKind::close) break;
    depth += word == "<" ? 1 : word == ">" ? -1 : 0;
    if (token.kind == TokenKind::newline) continue;
    value += word == "<" ? "[" : word == ">" ? "]" : word == "," ? ", " : word;
    if (is_vector && depth == 0) {
      token = next_token(text, token.end);
      break;
    }
  }
  if (text_of(text, token) == ",") token = next_token(text, token.end);
  skip_newlines();
  return value;
}

// All the vectors that follow, as a list.
std::string povray_points(std::string_view text, Token& token) {
  std::string points;
  while (text_of(text, token) == "<")
    points += fmt::format("{}{}", points.empty() ? "" : ", ", povray_value(text, token, true));
  return points.empty() ? "" : fmt::format("[{}]", points);
}

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
      code < 0x80 ? "" : "names consist of a-z, A-Z, 0-9 and _; other letters are allowed in strings and comments");
}

} // namespace

std::optional<Diagnostic> foreign_word(Span span, std::string_view word) {
  const auto* const found =
      std::find_if(statements.begin(), statements.end(), [&](const ForeignWord& f) { return f.word == word; });
  if (found == statements.end()) return std::nullopt;
  const std::string message =
      word == "print" ? "`print` takes its values in parentheses" : fmt::format("there is no `{}` here", word);
  return errors::foreign_statement(span, message, std::string(found->way_out));
}

std::optional<Diagnostic> foreign_method(Span span, std::string_view word) {
  const auto* const found =
      std::find_if(methods.begin(), methods.end(), [&](const ForeignWord& f) { return f.word == word; });
  if (found == methods.end()) return std::nullopt;
  return errors::foreign_statement(span, fmt::format("`{}` is written after a thing", word),
                                   std::string(found->way_out));
}

bool is_povray_thing(std::string_view text, std::uint32_t brace) {
  return form_at(text, brace) != nullptr;
}

std::string povray_form(std::string_view text, std::uint32_t brace) {
  const PovrayForm* form = form_at(text, brace);
  if (!form) return "write `name: [x, y, z]`";
  std::string written;
  Token token = next_token(text, brace + 1);
  for (const std::string_view property : form->properties) {
    const std::string value = property == "points" ? povray_points(text, token)
                              : property.empty()   ? ""
                                                   : povray_value(text, token, is_vector(property));
    if (value.empty()) break;
    written += fmt::format("{}{}: {}", written.empty() ? "" : ", ", property, value);
  }
  const bool is_all = token.kind == TokenKind::close || token.kind == TokenKind::end;
  return fmt::format("write `{} {{ {}{} }}`", form->ours, written, is_all ? "" : ", …");
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
  if (c == "$")
    return errors::meaningless_character(span, "`$` has no meaning here",
                                         "names have none; surfaces are exact, without `$fn`");
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
