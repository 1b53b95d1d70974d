#include "lang/format/format_tree.hpp"

#include "lang/text/utf8.hpp"
#include "lang/text/words.hpp"

#include <algorithm>
#include <iterator>

namespace rt::lang::layout {

bool is_comment(TokenKind kind) {
  return kind == TokenKind::line_comment || kind == TokenKind::block_comment;
}

namespace {

std::vector<Token> tokens_of(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  std::uint32_t at = text.starts_with(byte_order_mark) ? 3 : 0;
  std::vector<Token> tokens;
  do {
    tokens.push_back(next_token(text, at));
    at = tokens.back().end;
  } while (tokens.back().kind != TokenKind::end);
  return tokens;
}

// Whether a line that ends in the piece continues on the next.
bool continues(const Piece& piece) {
  if (piece.group) return false;
  if (piece.kind == TokenKind::symbol) return true;
  if (piece.kind != TokenKind::name) return false;
  const Word word = classify(piece.text);
  return is_reserved(word) && word != Word::true_ && word != Word::false_ && word != Word::none_;
}

class Reader {
public:
  explicit Reader(std::string_view text) : text_(text), tokens_(tokens_of(text)) {}

  Group file() {
    Group group;
    fill(group, true);
    group.is_broken = true;
    return group;
  }

private:
  const Token& token(std::size_t i) const { return tokens_[std::min(i, tokens_.size() - 1)]; }
  TokenKind kind() const { return token(at_).kind; }
  std::string_view said(std::size_t i) const { return text_of(text_, token(i)); }
  bool ends_line(std::size_t i) const { return token(i).kind == TokenKind::newline || token(i).kind == TokenKind::end; }

  // Reads up to and including the closing bracket.
  void fill(Group& group, bool is_file) {
    FormatEntry entry;
    for (bool is_first = true;; is_first = false) {
      int newlines = 0;
      for (; kind() == TokenKind::newline; ++at_) ++newlines;
      if (newlines > 0) {
        group.is_broken = true;
        if (newline_separates(group, entry, at_)) finish(group, entry);
      }
      group.ends_on_new_line = newlines > 0;
      if (kind() == TokenKind::end || kind() == TokenKind::close) break;
      if (kind() == TokenKind::separator && !is_within_loop_names(entry)) {
        pass_separator(group, entry);
      } else if (!is_comment(kind()) || !take_comment(group, entry, newlines, is_first && !is_file)) {
        take_piece(entry, newlines);
      }
    }
    finish(group, entry);
    ++at_;
  }

  static void finish(Group& group, FormatEntry& entry) {
    const bool holds_comments_only = std::all_of(entry.pieces.begin(), entry.pieces.end(),
                                                 [](const Piece& piece) { return is_comment(piece.kind); });
    FormatEntry* const before = group.entries.empty() ? nullptr : &group.entries.back();
    const bool belongs_to_one_before = holds_comments_only && !entry.begins_line && before != nullptr &&
                                       before->trailing_comment.empty() && !before->is_comment && group.bracket != '(';
    if (belongs_to_one_before) {
      std::move(entry.pieces.begin(), entry.pieces.end(), std::back_inserter(before->pieces));
    } else if (!entry.pieces.empty()) {
      entry.is_comment = holds_comments_only && entry.begins_line && group.bracket != '(';
      group.entries.push_back(std::move(entry));
    }
    entry = FormatEntry{};
  }

  // The comma of `for i, x in xs`.
  static bool is_within_loop_names(const FormatEntry& entry) {
    const Piece* last = nullptr;
    for (auto piece = entry.pieces.rbegin(); piece != entry.pieces.rend(); ++piece) {
      if (is_comment(piece->kind)) continue;
      if (last != nullptr) return last->kind == TokenKind::name && piece->text == "for";
      last = &*piece;
    }
    return false;
  }

  // Comments between an argument and its comma move behind the comma.
  void pass_separator(Group& group, FormatEntry& entry) {
    std::vector<Piece> comments;
    while (group.bracket == '(' && !entry.pieces.empty() && is_comment(entry.pieces.back().kind)) {
      comments.insert(comments.begin(), std::move(entry.pieces.back()));
      entry.pieces.pop_back();
    }
    finish(group, entry);
    entry.pieces = std::move(comments);
    ++at_;
  }

  // `next` is the first token after the newline.
  bool newline_separates(const Group& group, const FormatEntry& entry, std::size_t next) const {
    if (group.bracket == '(' || entry.pieces.empty()) return false;
    const auto last = std::find_if(entry.pieces.rbegin(), entry.pieces.rend(),
                                   [](const Piece& piece) { return !is_comment(piece.kind); });
    if (last != entry.pieces.rend() && continues(*last)) return false;
    while (token(next).kind == TokenKind::newline || is_comment(token(next).kind)) ++next;
    if (said(next) == "." && token(next + 1).kind == TokenKind::name) return false;
    return group.bracket != '[' || !begins_clause(entry, said(next));
  }

  // Whether the word continues the entry as a comprehension.
  static bool begins_clause(const FormatEntry& entry, std::string_view word) {
    if (word == "for") return true;
    return word == "if" && std::any_of(entry.pieces.begin(), entry.pieces.end(), [](const Piece& piece) {
             return piece.kind == TokenKind::name && piece.text == "for";
           });
  }

  // A comment after an entry, after the opening bracket, or on lines of its own; false for one among the tokens.
  bool take_comment(Group& group, FormatEntry& entry, int newlines, bool is_behind_bracket) {
    if (group.bracket == '(' || !ends_line(at_ + 1)) return false;
    if (!entry.pieces.empty()) {
      if (newlines > 0 || !newline_separates(group, entry, at_ + 1)) return false;
      take_trailing_comment(entry);
      finish(group, entry);
      return true;
    }
    FormatEntry* const before = group.entries.empty() ? nullptr : &group.entries.back();
    if (newlines == 0 && is_behind_bracket) {
      group.opening_comment = said(at_++);
    } else if (newlines == 0 && before != nullptr && before->trailing_comment.empty() && !before->is_comment) {
      take_trailing_comment(*before); // there was a separator between them
    } else {
      take_piece(entry, newlines);
      entry.begins_line = true;
      finish(group, entry);
    }
    return true;
  }

  void take_trailing_comment(FormatEntry& entry) {
    const std::size_t begin = token(at_).begin;
    const std::size_t newline = begin == 0 ? std::string_view::npos : text_.rfind('\n', begin - 1);
    const std::size_t line = newline == std::string_view::npos ? 0 : newline + 1;
    entry.comment_column = display_width(text_.substr(line, begin - line));
    entry.trailing_comment = said(at_++);
  }

  void take_piece(FormatEntry& entry, int newlines) {
    const bool is_first = entry.pieces.empty();
    if (is_first) {
      entry.begins_line = newlines > 0;
      entry.follows_blank_line = newlines > 1;
    }
    Piece piece{kind(), said(at_), newlines > 0 && !is_first, nullptr};
    const bool is_sign = piece.text == "=" || piece.text == "{";
    if (entry.pieces.size() == 1 && is_sign && entry.pieces[0].kind == TokenKind::name && !piece.begins_line) {
      entry.sign_column = static_cast<std::size_t>(piece.text.data() - entry.pieces[0].text.data());
    }
    ++at_;
    if (piece.kind == TokenKind::open) {
      piece.group = std::make_unique<Group>();
      piece.group->bracket = piece.text[0];
      fill(*piece.group, false);
    }
    entry.pieces.push_back(std::move(piece));
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

} // namespace

Group read(std::string_view text) {
  return Reader(text).file();
}

} // namespace rt::lang::layout
