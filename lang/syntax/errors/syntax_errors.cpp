#include "lang/syntax/errors/syntax_errors.hpp"

#include "lang/text/characters.hpp"
#include "lang/text/tokens.hpp"
#include "lang/text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace rt::lang {

namespace {

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 24;
  const bool is_cut = text.size() > longest;
  if (is_cut) {
    std::size_t length = longest;
    while (length > 0 && (text[length] & 0xc0) == 0x80) --length; // not inside a character
    text = text.substr(0, length);
  }
  return fmt::format("`{}{}`", text, is_cut ? "…" : "");
}

/// One failure and the tokens around it.
class Explanation {
public:
  Explanation(const SyntaxPlace& place, Expected expected) : place_(place), expected_(expected) {
    found_ = token_from(place.at);
    read_item();
  }

  Diagnostic diagnostic() const {
    if (auto likely = by_what_is_found()) return *std::move(likely);
    switch (expected_) {
    case Expected::item:
      return item();
    case Expected::item_end:
      return item_end();
    case Expected::expression:
      return expression();
    case Expected::end_of_expression:
      return error(errors::unexpected, "expected the end, found " + found());
    case Expected::property_colon:
      return error(errors::vector_without_brackets, "a vector is written in square brackets",
                   fmt::format("write `{}: [x, y, z]`", word_of_item()));
    case Expected::closing_bracket:
      return closing_bracket();
    case Expected::name:
      return name("expected a name, found " + found());
    case Expected::property_name:
      return name("expected a name after `.`, found " + found());
    case Expected::block:
      return block();
    case Expected::head:
      return head();
    case Expected::loop_in:
      return loop_in();
    case Expected::parameters:
      return parameters();
    case Expected::function_body:
      return error(errors::missing_function_value, "a function's value is missing, found " + found(),
                   "write `= value`, or a block whose last line is the value");
    case Expected::arrow:
      return error(errors::misplaced_arrow, "a function without a name needs `=>`, found " + found(),
                   "`fn (x) => x * x`");
    case Expected::path:
      return error(errors::incomplete_statement, "expected a file's path, found " + found(),
                   "a path is a string: `" + word_of_item() + " \"parts.rtl\"`");
    case Expected::use_as:
      return error(errors::incomplete_statement, "`use` gives the file a name", "`use \"parts.rtl\" as parts`");
    case Expected::claim_t:
      return error(errors::malformed_expect, "expected `t` after `at`, found " + found(),
                   "`expect … hits ball at t 4`");
    case Expected::param_value:
      return error(errors::incomplete_statement, "a `param` needs a value to start from, found " + found(),
                   "`param name = value`");
    case Expected::string_end:
      return string_end();
    case Expected::comment_end:
      return errors::unclosed_comment({place_.file, place_.at - 2, place_.at}, "this comment is not closed",
                                      "expected `*/` before the end of the file");
    case Expected::item_begin:
      if (place_.follows_line) return led_by_operator();
      return error(errors::vector_without_brackets, "a value is written after its property's name",
                   povray_form(place_.text, place_.open.back().at));
    }
    return error(errors::unexpected, "unexpected " + found());
  }

private:
  Token token_from(std::uint32_t at) const {
    Token token = next_token(place_.text, at);
    while (token.kind == TokenKind::block_comment) token = next_token(place_.text, token.end);
    return token;
  }

  // The first tokens of the item and the last before the failure.
  void read_item() {
    std::size_t count = 0;
    for (Token token = token_from(place_.item); token.begin < place_.at && token.kind != TokenKind::end;
         token = token_from(token.end)) {
      if (token.kind == TokenKind::newline || token.kind == TokenKind::line_comment) continue;
      if (count++ == 0) first_ = token;
      earlier_ = before_;
      before_ = token;
    }
    item_tokens_ = count;
  }

  std::string_view text(Token token) const { return text_of(place_.text, token); }
  std::string word_of_item() const { return item_tokens_ > 0 ? std::string(text(first_)) : ""; }
  bool found_is(std::string_view what) const { return text(found_) == what; }
  bool before_is(std::string_view what) const { return item_tokens_ > 0 && text(before_) == what; }
  bool found_word(Word word) const { return found_.kind == TokenKind::name && classify(text(found_)) == word; }
  bool line_ends() const {
    return found_.kind == TokenKind::newline || found_.kind == TokenKind::line_comment || found_.kind == TokenKind::end;
  }
  bool is_at_item_boundary() const { return expected_ == Expected::item || expected_ == Expected::item_end; }

  std::string found() const {
    switch (found_.kind) {
    case TokenKind::end:
      return "the end of the file";
    case TokenKind::newline:
    case TokenKind::line_comment:
      return "the end of the line";
    default:
      return quoted(text(found_));
    }
  }

  // The end of a line is shown where its text ends.
  Span found_span() const {
    if (!line_ends()) return {place_.file, found_.begin, found_.end};
    std::uint32_t at = found_.begin;
    while (at > 0 &&
           (is_blank(place_.text[at - 1]) || (found_.kind == TokenKind::end && place_.text[at - 1] == '\n'))) {
      --at;
    }
    return {place_.file, at, at};
  }

  Diagnostic error(errors::SyntaxError& make, std::string message, std::string label = "") const {
    return make(found_span(), std::move(message), std::move(label));
  }

  // Errors that do not depend on the context.
  std::optional<Diagnostic> by_what_is_found() const {
    if (expected_ == Expected::string_end || expected_ == Expected::comment_end) return std::nullopt;
    if (item_tokens_ > 0 && is_reserved(classify(text(first_)))) {
      const Token second = token_from(first_.end);
      if (text(second) == ":" || text(second) == "=") return reserved_name(first_);
    }
    if (found_.kind == TokenKind::unknown || found_is("~")) return unknown_character(found_span(), text(found_));
    if (found_.kind == TokenKind::color && is_at_item_boundary()) return misplaced_hash(found_span(), text(found_));
    if (found_.kind == TokenKind::close && expected_ == Expected::item) return stray_bracket();
    if (is_at_item_boundary() || expected_ == Expected::closing_bracket) {
      if (auto foreign = foreign_statement()) return foreign;
    }
    if (found_is("=>"))
      return error(errors::misplaced_arrow, "`=>` belongs to a function without a name", "`fn (x) => x * x`");
    if (found_.kind == TokenKind::name && is_reserved(classify(text(found_)))) return reserved_word();
    return std::nullopt;
  }

  Diagnostic stray_bracket() const {
    return error(errors::bracket_without_partner,
                 fmt::format("there is no open bracket for this {} to close", found()));
  }

  std::optional<Diagnostic> foreign_statement() const {
    const bool is_after_one_word = expected_ == Expected::item_end && item_tokens_ >= 1 && !line_ends();
    if (is_after_one_word && !(before_is(")") && text(first_) == "print")) {
      if (text(token_from(first_.end)) == "(") {
        if (auto method = foreign_method({place_.file, first_.begin, first_.end}, text(first_))) return method;
      }
      if (auto foreign = foreign_word({place_.file, first_.begin, first_.end}, text(first_))) return foreign;
    }
    const bool is_else = found_.kind == TokenKind::name && text(found_).starts_with("el");
    return is_else ? foreign_word(found_span(), text(found_)) : std::nullopt;
  }

  Diagnostic reserved_name(Token token) const {
    return errors::reserved_word({place_.file, token.begin, token.end},
                                 fmt::format("`{}` is a reserved word and cannot be a name", text(token)),
                                 "choose another name");
  }

  Diagnostic reserved_word() const {
    const std::string word(text(found_));
    if (word == "else") {
      return error(errors::else_without_if, "this `else` has no `if`",
                   "`else` must be on the line of the preceding brace");
    }
    const bool needs_name = expected_ == Expected::name || expected_ == Expected::property_name;
    const Token next = token_from(found_.end);
    const bool is_used_as_name = text(next) == ":" || text(next) == "=";
    if (needs_name || (expected_ == Expected::item && is_used_as_name)) return reserved_name(found_);
    if (expected_ == Expected::expression && (word == "if" || word == "fn")) {
      return error(errors::bare_if_or_fn, fmt::format("`{}` inside an expression needs parentheses", word),
                   word == "if" ? "`(if a { b } else { c })`" : "`(fn (x) => x)`");
    }
    if (expected_ == Expected::expression && word == "for") {
      return error(errors::unexpected, "`for` is not a value", "`[x * x for x in xs]` makes a list");
    }
    if (expected_ == Expected::item && (word == "and" || word == "or" || word == "by")) return led_by_operator();
    if (expected_ == Expected::expression) {
      return error(errors::unexpected, fmt::format("expected an expression, found `{}`", word),
                   "it is a reserved word");
    }
    if (expected_ == Expected::item) {
      return error(errors::reserved_word, fmt::format("`{}` is a reserved word and cannot be used here", word));
    }
    return missing_separator();
  }

  Diagnostic led_by_operator() const {
    const std::string op = found();
    if (!place_.follows_line) {
      return error(errors::unexpected, fmt::format("{} has nothing on its left", op));
    }
    const std::string way_out = found_is("-") ? "; a negative value on a line of its own needs parentheses" : "";
    return error(errors::line_begins_with_operator, fmt::format("a line cannot begin with {}", op),
                 fmt::format("to continue the line before, end that line with {}{}", op, way_out));
  }

  Diagnostic item() const {
    if (found_.kind == TokenKind::separator) {
      return error(errors::nothing_between_separators, fmt::format("there is nothing before this {}", found()));
    }
    if (found_is(".") && !place_.follows_line) {
      return error(errors::line_begins_with_operator, "this `.` has nothing before it",
                   "a line that begins with `.` continues the thing before");
    }
    if (found_is(":") || found_is("=")) {
      return error(errors::missing_name, fmt::format("a name is missing before {}", found()));
    }
    if (found_is("<") && !place_.open.empty() && place_.open.back().bracket == '{') {
      const std::uint32_t brace = place_.open.back().at;
      return error(errors::vector_without_brackets, "a vector is written in square brackets",
                   povray_form(place_.text, brace));
    }
    if (found_.kind == TokenKind::symbol) return led_by_operator();
    return error(errors::unexpected, "expected a thing, a property or a name, found " + found());
  }

  Diagnostic item_end() const {
    if (found_is(":")) {
      return error(errors::missing_name, "a name is expected before `:`", "a property is written `name: value`");
    }
    return missing_separator();
  }

  Diagnostic missing_separator() const {
    const bool is_lone_name = item_tokens_ == 1 && first_.kind == TokenKind::name && !place_.open.empty() &&
                              expected_ == Expected::item_end && found_.kind != TokenKind::symbol;
    if (is_lone_name) {
      const std::string_view value = place_.text.substr(found_.begin, found_.end - found_.begin);
      return error(errors::missing_separator, fmt::format("`:` is missing between `{}` and its value", text(first_)),
                   found_.kind == TokenKind::open ? fmt::format("write `{}: …`", text(first_))
                                                  : fmt::format("write `{}: {}`", text(first_), value));
    }
    if (found_.kind == TokenKind::symbol) return error(errors::unexpected, "unexpected " + found());
    return error(errors::missing_separator, fmt::format("a separator is missing before {}", found()),
                 "expected a comma or a new line");
  }

  Diagnostic closing_bracket() const {
    const OpenBracket open = place_.open.back();
    if (open.bracket == '(' && found_is(",")) {
      return error(errors::vector_without_brackets, "parentheses contain a single value",
                   "a vector is written `[x, y, z]`");
    }
    if (found_is(":") && open.bracket == '[') {
      return error(errors::open_bracket, "a list cannot contain properties",
                   "is the list not closed, or is `{ name: value }` meant?");
    }
    if (found_.kind == TokenKind::symbol) return error(errors::unexpected, "unexpected " + found());
    return error(errors::missing_separator, fmt::format("a comma is missing before {}", found()),
                 fmt::format("expected `,` or `{}`", open.bracket == '(' ? ')' : ']'));
  }

  Diagnostic expression() const {
    const bool is_value = before_is(":") || before_is("=") || before_is("(") || before_is("[") || before_is(",");
    if (found_is("<") && is_value) {
      return error(errors::vector_without_brackets, "a vector is written in square brackets", "`[x, y, z]`");
    }
    if (found_is("=") && before_.kind == TokenKind::symbol && before_.end == found_.begin) {
      return errors::foreign_operator({place_.file, before_.begin, found_.end},
                                      fmt::format("there is no `{}=`", text(before_)),
                                      before_is("==") || before_is("!=") ? fmt::format("write `{}`", text(before_))
                                      : before_is(":")                   ? "write `=`"
                                                                         : "a name keeps its value");
    }
    if (found_is(">") && before_is("-")) {
      return error(errors::foreign_operator, "there is no `->` here",
                   "a function without a name is written `fn (x) => x * x`");
    }
    if (found_.kind == TokenKind::separator && before_.kind == TokenKind::separator) {
      return error(errors::nothing_between_separators, fmt::format("there is nothing before this {}", found()));
    }
    if (item_tokens_ == 0 || before_.kind == TokenKind::separator)
      return error(errors::unexpected, "expected an expression, found " + found());
    return error(errors::unexpected,
                 fmt::format("expected an expression after {}, found {}", quoted(text(before_)), found()));
  }

  Diagnostic name(std::string message) const {
    const bool is_loop = word_of_item() == "for" && before_is("for");
    if (is_loop && found_is("(")) {
      return error(errors::foreign_statement, "a `for` iterates over elements",
                   "`for i in 0..9 { … }`, without parentheses");
    }
    if (found_.kind == TokenKind::number && expected_ == Expected::property_name) {
      if (earlier_.kind == TokenKind::number) return error(errors::malformed_number, "a number has one decimal point");
      return error(errors::missing_name, std::move(message), "`[ ]` takes an element: `list[0]`");
    }
    return error(errors::missing_name, std::move(message));
  }

  Diagnostic block() const {
    std::string label = "expected `{`";
    if (found_is(":")) label = "a block is written in braces: `{ … }`";
    if (found_is("then") || found_is("do")) label = fmt::format("write `{{` in place of `{}`", text(found_));
    return error(errors::missing_block, fmt::format("a block is missing, found {}", found()), label);
  }

  Diagnostic head() const {
    const bool is_loop = before_is("in");
    return error(errors::unexpected,
                 fmt::format("expected an expression after {}, found {}", quoted(text(before_)), found()),
                 is_loop ? "a `for` needs a list or a range" : "an `if` needs a condition");
  }

  Diagnostic loop_in() const {
    return error(errors::missing_in, fmt::format("`in` is missing, found {}", found()),
                 "`for x in xs { … }`, `for i, x in xs { … }`");
  }

  Diagnostic parameters() const {
    if (found_.kind == TokenKind::name && before_is("fn")) {
      return error(errors::misplaced_arrow, "a function inside an expression has no name", "`fn (x) => x * x`");
    }
    return error(errors::missing_parameters, fmt::format("expected the parameters in parentheses, found {}", found()),
                 "`()` if there are none");
  }

  Diagnostic string_end() const {
    const std::uint32_t begin = place_.at - 1;
    const auto end = static_cast<std::uint32_t>(std::min(place_.text.find_first_of("\r\n", begin), place_.text.size()));
    return errors::unclosed_string({place_.file, begin, end}, "this string is not closed",
                                   "expected `\"` before the end of the line");
  }

  const SyntaxPlace& place_;
  Expected expected_;
  Token found_{};
  Token first_{};
  Token before_{};
  Token earlier_{}; ///< the one before that
  std::size_t item_tokens_ = 0;
};

} // namespace

Diagnostic explain_failure(const SyntaxPlace& place, Expected expected) {
  return Explanation(place, expected).diagnostic();
}

Diagnostic unclosed_bracket(FileId file, OpenBracket bracket) {
  const char closing = bracket.bracket == '(' ? ')' : bracket.bracket == '[' ? ']' : '}';
  return errors::open_bracket({file, bracket.at, bracket.at + 1},
                              fmt::format("this `{}` is not closed", bracket.bracket),
                              fmt::format("expected a `{}`", closing));
}

Diagnostic mismatched_bracket(FileId file, OpenBracket bracket, std::uint32_t at, char found) {
  const char closing = bracket.bracket == '(' ? ')' : bracket.bracket == '[' ? ']' : '}';
  Diagnostic diagnostic = errors::bracket_without_partner(
      {file, at, at + 1}, fmt::format("`{}` does not close `{}`", found, bracket.bracket),
      fmt::format("expected `{}`", closing));
  diagnostic.notes.push_back(
      {Span{file, bracket.at, bracket.at + 1}, fmt::format("the `{}` is here", bracket.bracket)});
  return diagnostic;
}

} // namespace rt::lang
