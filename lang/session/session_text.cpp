#include "lang/session/session_text.hpp"

#include "lang/text/tokens.hpp"

#include <algorithm>

namespace rt::lang {
namespace {

bool is_comment(TokenKind kind) {
  return kind == TokenKind::line_comment || kind == TokenKind::block_comment;
}

/// Where an item's text ends: after it, or after the comment that follows it on its line.
struct ItemEnd {
  std::uint32_t text_end;
  std::uint32_t next; ///< where what belongs to the next item begins
};

ItemEnd end_of_item(std::string_view source, std::uint32_t item_end, std::uint32_t next_item) {
  ItemEnd end{item_end, item_end};
  for (std::uint32_t at = item_end; at < next_item;) {
    const Token token = next_token(source, at);
    if (token.kind == TokenKind::end || token.begin >= next_item) break;
    at = end.next = token.end;
    if (token.kind == TokenKind::newline) break;
    if (is_comment(token.kind)) end.text_end = token.end;
    if (token.kind == TokenKind::block_comment && text_of(source, token).find('\n') != std::string_view::npos) break;
  }
  return end;
}

bool has_comment(std::string_view text) {
  for (Token token = next_token(text, 0); token.kind != TokenKind::end; token = next_token(text, token.end))
    if (is_comment(token.kind)) return true;
  return false;
}

/// The text between two items without blanks and separators at its ends; blank lines above comments are kept.
std::uint32_t begin_of_trivia(std::string_view source, std::uint32_t begin, std::uint32_t item) {
  const std::string_view trivia = source.substr(begin, item - begin);
  if (trivia.find('\n') == std::string_view::npos && !has_comment(trivia)) return item;
  return begin;
}

std::uint32_t line_of(std::string_view source, std::uint32_t offset) {
  return static_cast<std::uint32_t>(std::count(source.begin(), source.begin() + offset, '\n')) + 1;
}

std::string_view without_blanks_at_end(std::string_view text) {
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

} // namespace

std::vector<ItemText> cut_items(std::string_view source, const Ast& ast, NodeList items) {
  std::vector<ItemText> texts;
  texts.reserve(items.size() + 1);
  std::uint32_t at = source.starts_with("\xef\xbb\xbf") ? 3 : 0;
  std::uint32_t line = 1, counted = 0; // lines up to `counted`
  const auto line_at = [&](std::uint32_t offset) {
    line += static_cast<std::uint32_t>(std::count(source.begin() + counted, source.begin() + offset, '\n'));
    counted = offset;
    return line;
  };
  const auto size = static_cast<std::uint32_t>(source.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Node& node = ast[items[i]];
    const std::uint32_t begin = begin_of_trivia(source, at, node.begin);
    const ItemEnd end = end_of_item(source, node.end, i + 1 < items.size() ? ast[items[i + 1]].begin : size);
    texts.push_back({std::string(source.substr(begin, end.text_end - begin)), line_at(begin)});
    at = end.next;
  }
  const std::string_view rest = source.substr(std::min<std::size_t>(at, source.size()));
  if (has_comment(rest)) texts.push_back({std::string(without_blanks_at_end(rest)), line_of(source, at)});
  return texts;
}

namespace {

// Puts tokens on a single line, with a separator where a line break served as one.
class OneLine {
public:
  explicit OneLine(std::string_view text) : text_(text) {}

  std::string run(std::size_t longest) {
    for (Token token = next_token(text_, 0); token.kind != TokenKind::end; token = next_token(text_, token.end)) {
      if (is_comment(token.kind)) continue;
      if (token.kind == TokenKind::newline)
        had_newline_ = true;
      else
        take(token);
      if (line_.size() > longest) break;
    }
    return std::move(line_);
  }

private:
  void take(Token token) {
    const std::string_view word = text_of(text_, token);
    const bool had_blank = token.begin > 0 && (text_[token.begin - 1] == ' ' || text_[token.begin - 1] == '\t');
    if (had_newline_ && separates(token, word)) line_ += open_.empty() ? ';' : ',';
    if ((had_newline_ || had_blank) && !line_.empty()) line_ += ' ';
    line_ += word;
    if (token.kind == TokenKind::open) open_ += word;
    if (token.kind == TokenKind::close && !open_.empty()) open_.pop_back();
    last_ = token.kind;
    had_newline_ = false;
  }

  // Whether the line break before the token separates.
  bool separates(Token token, std::string_view word) const {
    const bool goes_on = last_ == TokenKind::end || last_ == TokenKind::open || last_ == TokenKind::symbol ||
                         last_ == TokenKind::separator;
    if (goes_on || token.kind == TokenKind::close || token.kind == TokenKind::separator || word == ".") return false;
    if (open_.empty()) return true;
    const bool is_clause = open_.back() == '[' && (word == "for" || word == "if");
    return open_.back() != '(' && !is_clause;
  }

  std::string_view text_;
  std::string line_, open_; // unclosed brackets
  TokenKind last_ = TokenKind::end;
  bool had_newline_ = false;
};

} // namespace

std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 100;
  std::string line = OneLine(text).run(longest);
  if (line.size() <= longest) return line;
  line.resize(longest);
  while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0) == 0x80) line.pop_back();
  if (!line.empty() && static_cast<unsigned char>(line.back()) >= 0xc0) line.pop_back();
  return line + "…";
}

NodeId innermost(const Ast& ast, NodeId node) {
  while (true) {
    switch (ast.kind(node)) {
    case Kind::call:
      node = ast.call(node).callee;
      break;
    case Kind::member:
      node = ast.member(node).base;
      break;
    case Kind::override_:
      node = ast.override_(node).base;
      break;
    case Kind::index:
      node = ast.index(node).base;
      break;
    case Kind::binary:
      node = ast.left(node);
      break;
    default:
      return node;
    }
  }
}

bool edits_previous(const Ast& ast, NodeId item) {
  return ast.kind(innermost(ast, item)) == Kind::previous;
}

namespace {

// The thing's own block, inside the chain of calls after it.
NodeId below_chain(const Ast& ast, NodeId node) {
  while (ast.kind(node) == Kind::call && ast.kind(ast.call(node).callee) == Kind::member)
    node = ast.member(ast.call(node).callee).base;
  return node;
}

std::string with_new_line(std::string_view text, const Node& block, const std::string& property) {
  const std::uint32_t brace = block.end - 1;
  const std::string_view inside = text.substr(block.begin + 1, brace - block.begin - 1);
  const std::size_t newline = inside.rfind('\n');
  if (newline == std::string_view::npos) {
    const std::string_view kept = without_blanks_at_end(text.substr(0, brace));
    const bool is_empty = inside.find_first_not_of(" \t") == std::string_view::npos;
    return std::string(kept) + (is_empty ? " " : ", ") + property + " " + std::string(text.substr(brace));
  }
  // Indented like its neighbours.
  const std::size_t first = inside.find_first_not_of(" \t", inside.find('\n') + 1);
  const std::size_t line = inside.find('\n') + 1;
  const std::string indent(first == std::string_view::npos ? "  " : inside.substr(line, first - line));
  const std::string_view before = without_blanks_at_end(text.substr(0, brace));
  return std::string(before) + "\n" + indent + property + "\n" +
         std::string(text.substr(block.begin + 1 + newline + 1));
}

} // namespace

std::optional<std::string> with_property(std::string_view text, const Ast& ast, NodeId node, Symbol property,
                                         std::string_view property_name, std::string_view value) {
  node = below_chain(ast, node);
  const std::string written = std::string(property_name) + ": " + std::string(value);
  if (ast.kind(node) == Kind::override_) {
    const NodeId block = ast.override_(node).block;
    for (const NodeId item : ast.children(block)) {
      if (ast.kind(item) != Kind::property || ast.named(item).symbol != property) continue;
      const Node& old = ast[ast.named(item).value];
      return std::string(text.substr(0, old.begin)) + std::string(value) + std::string(text.substr(old.end));
    }
    return with_new_line(text, ast[block], written);
  }
  const Kind kind = ast.kind(node);
  if (kind != Kind::name && kind != Kind::member && kind != Kind::index && kind != Kind::call && kind != Kind::binary)
    return std::nullopt;
  const Node& whole = ast[node];
  std::string thing(text.substr(whole.begin, whole.end - whole.begin));
  if (kind == Kind::binary) thing = "(" + thing + ")";
  return std::string(text.substr(0, whole.begin)) + thing + " { " + written + " }" +
         std::string(text.substr(whole.end));
}

std::string with_name_replaced(std::string_view text, const Ast& ast, NodeId node, Symbol symbol,
                               std::string_view replacement) {
  std::vector<Node> places;
  const Node& whole = ast[node];
  for (const Node& candidate : ast.nodes) {
    const bool is_inside = candidate.begin >= whole.begin && candidate.end <= whole.end;
    if (is_inside && candidate.kind == Kind::name && Symbol{candidate.a} == symbol) places.push_back(candidate);
  }
  std::sort(places.begin(), places.end(), [](const Node& a, const Node& b) { return a.begin > b.begin; });
  std::string result(text);
  for (const Node& place : places) result.replace(place.begin, place.end - place.begin, replacement);
  return result;
}

} // namespace rt::lang
