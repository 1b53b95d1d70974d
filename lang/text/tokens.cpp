#include "lang/text/tokens.hpp"

#include "lang/text/characters.hpp"
#include "lang/text/literals.hpp"

#include <algorithm>

namespace rt::lang {

namespace {

class Scanner {
public:
  Scanner(std::string_view text, std::uint32_t at) : text_(text), begin_(at), at_(at) {}

  Token token() {
    while (is_blank(peek())) ++at_;
    begin_ = at_;
    if (at_ >= text_.size()) return {TokenKind::end, begin_, begin_};
    const TokenKind kind = scan(text_[at_]);
    return {kind, begin_, std::min(at_, static_cast<std::uint32_t>(text_.size()))};
  }

private:
  char peek(std::uint32_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  template <typename Predicate>
  void skip_while(Predicate predicate) {
    while (at_ < text_.size() && predicate(text_[at_])) ++at_;
  }

  void skip_to(std::string_view what) {
    at_ = static_cast<std::uint32_t>(std::min(text_.find(what, at_), text_.size()));
  }

  TokenKind scan(char c) {
    if (is_name_start(c)) return skip_while(is_name_part), TokenKind::name;
    if (begins_number(text_.substr(at_))) return number();
    switch (c) {
    case '\n':
      return ++at_, TokenKind::newline;
    case '"':
      return string();
    case '#':
      return ++at_, skip_while(is_name_part), TokenKind::color;
    case '(':
    case '[':
    case '{':
      return ++at_, TokenKind::open;
    case ')':
    case ']':
    case '}':
      return ++at_, TokenKind::close;
    case ',':
    case ';':
      return ++at_, TokenKind::separator;
    default:
      return comment_or_symbol(c);
    }
  }

  TokenKind number() {
    at_ += read_number(text_.substr(at_)).length;
    skip_while(is_name_part);
    return TokenKind::number;
  }

  TokenKind string() {
    for (++at_; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '"') return ++at_, TokenKind::string;
      if (text_[at_] == '\\' && peek(1) != '\n') ++at_;
    }
    return TokenKind::string;
  }

  TokenKind comment_or_symbol(char c) {
    if (c == '/' && peek(1) == '/') {
      skip_to("\n");
      if (text_[at_ - 1] == '\r') --at_; // part of the line ending
      return TokenKind::line_comment;
    }
    if (c == '/' && peek(1) == '*') {
      at_ += 2;
      skip_to("*/");
      at_ += 2;
      return TokenKind::block_comment;
    }
    for (const std::string_view symbol : {"...", "..<", "..", "==", "!=", "<=", ">=", "=>"}) {
      if (text_.substr(at_, symbol.size()) == symbol) {
        at_ += static_cast<std::uint32_t>(symbol.size());
        return TokenKind::symbol;
      }
    }
    ++at_;
    if (std::string_view("+-*/%^|&<>=:.~").find(c) != std::string_view::npos) return TokenKind::symbol;
    skip_while([](char next) { return (next & 0xc0) == 0x80; }); // the rest of a character
    return TokenKind::unknown;
  }

  std::string_view text_;
  std::uint32_t begin_;
  std::uint32_t at_;
};

} // namespace

Token next_token(std::string_view text, std::uint32_t at) {
  return Scanner(text, at).token();
}

} // namespace rt::lang
