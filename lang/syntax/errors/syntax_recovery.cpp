#include "lang/syntax/errors/syntax_errors.hpp"
#include "lang/text/tokens.hpp"
#include "lang/text/words.hpp"

#include <algorithm>
#include <string>

namespace rt::lang {

namespace {

char partner(char open) {
  return open == '(' ? ')' : open == '[' ? ']' : '}';
}

bool begins_item(Word word) {
  return word == Word::def_ || word == Word::param_ || word == Word::use_ || word == Word::include_ ||
         word == Word::expect_;
}

Token skip_comments(std::string_view text, Token token) {
  while (token.kind == TokenKind::block_comment) token = next_token(text, token.end);
  return token;
}

std::size_t indentation(std::string_view text, std::uint32_t at) {
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  return std::min(text.find_first_not_of(" \t", begin), text.size()) - begin;
}

bool is_first_on_line(std::string_view text, std::uint32_t at) {
  const std::size_t before = at == 0 ? std::string_view::npos : text.find_last_not_of(" \t", at - 1);
  return before == std::string_view::npos || text[before] == '\n';
}

// The position of the brace that closes the enclosing block.
std::uint32_t end_of_block(std::string_view text, std::uint32_t at) {
  int depth = 0;
  for (Token token = next_token(text, at);; token = next_token(text, token.end)) {
    if (token.kind == TokenKind::open) ++depth;
    if (token.kind == TokenKind::end || (token.kind == TokenKind::close && depth-- == 0)) return token.begin;
  }
}

} // namespace

std::uint32_t resume_after(std::string_view text, std::uint32_t at, const Diagnostic& error) {
  const std::size_t end_of_line = std::min(text.find('\n', at), text.size());
  if (errors::is_hash_comment(error)) return static_cast<std::uint32_t>(end_of_line);
  const std::size_t before = at == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", at - 1);
  const bool begins_block = before != std::string_view::npos && text[before] == '{';
  if (errors::is_vector_without_brackets(error) && begins_block) return end_of_block(text, at);
  if (errors::is_vector_without_brackets(error) && text[at] == '<') { // perhaps one of several
    const std::size_t close = text.substr(0, end_of_line).rfind('>');
    if (close != std::string_view::npos && close > at) return static_cast<std::uint32_t>(close + 1);
  }
  return at;
}

std::uint32_t skip_broken_item(std::string_view text, std::uint32_t from, std::string_view open, bool is_in_braces) {
  std::string stack(open);
  for (Token token = next_token(text, from);; token = next_token(text, token.end)) {
    const char c = text_of(text, token).empty() ? '\0' : text[token.begin];
    switch (token.kind) {
    case TokenKind::end:
      return token.begin;
    case TokenKind::open:
      stack += c;
      break;
    case TokenKind::close: {
      // A brace also closes unclosed brackets inside it; without a partner it ends the enclosing block.
      while (c == '}' && !stack.empty() && stack.back() != '{') stack.pop_back();
      if (!stack.empty() && c == partner(stack.back())) {
        stack.pop_back();
      } else if (c == '}' && is_in_braces) {
        return token.begin;
      }
      break;
    }
    case TokenKind::separator:
      if (stack.empty()) return token.begin;
      break;
    case TokenKind::newline:
      // If a bracket was left unclosed, the next line that looks like an item is one.
      while (!stack.empty() && stack.back() != '{' && looks_like_item(text, token.end)) stack.pop_back();
      if (stack.empty()) return token.begin;
      break;
    default:
      break;
    }
  }
}

bool looks_like_item(std::string_view text, std::uint32_t at) {
  const Token first = skip_comments(text, next_token(text, at));
  if (first.kind != TokenKind::name) return false;
  const Word word = classify(text_of(text, first));
  if (begins_item(word)) return true;
  const Token second = skip_comments(text, next_token(text, first.end));
  if (word == Word::fn_) return second.kind == TokenKind::name;
  if (is_reserved(word)) return false;
  const std::string_view sign = text_of(text, second);
  return sign == ":" || sign == "=";
}

std::string_view declared_name(std::string_view text, std::uint32_t item) {
  const Token first = skip_comments(text, next_token(text, item));
  if (first.kind != TokenKind::name) return {};
  Token second = skip_comments(text, next_token(text, first.end));
  const std::string_view word = text_of(text, first);
  const Word meaning = classify(word);
  if (meaning == Word::use_) { // use "path" as name
    if (second.kind != TokenKind::string) return {};
    const Token as = next_token(text, second.end);
    const Token name = next_token(text, as.end);
    return text_of(text, as) == "as" && name.kind == TokenKind::name ? text_of(text, name) : std::string_view{};
  }
  const bool declares = meaning == Word::def_ || meaning == Word::fn_ || meaning == Word::param_ ||
                        meaning == Word::foreign_variable || meaning == Word::foreign_function || word == "module";
  if (declares && second.kind == TokenKind::name) return text_of(text, second);
  return meaning == Word::plain && text_of(text, second) == "=" ? word : std::string_view{};
}

std::vector<OpenBracket> forgotten_braces(std::string_view text, std::size_t count) {
  std::vector<OpenBracket> open, forgotten;
  for (Token token = next_token(text, 0); token.kind != TokenKind::end; token = next_token(text, token.end)) {
    const char c = text[token.begin];
    if (token.kind == TokenKind::open) open.push_back({token.begin, c});
    if (token.kind != TokenKind::close) continue;
    const bool tells = c == '}' && is_first_on_line(text, token.begin);
    while (tells && open.size() > 1 && indentation(text, open.back().at) > indentation(text, token.begin)) {
      forgotten.push_back(open.back());
      open.pop_back();
    }
    if (!open.empty()) open.pop_back();
  }
  forgotten.insert(forgotten.end(), open.begin(), open.end());
  return forgotten.size() == count ? forgotten : std::vector<OpenBracket>{};
}

} // namespace rt::lang
