#include "lang/format/format_layout.hpp"

#include "lang/text/words.hpp"

#include <algorithm>
#include <utility>

namespace rt::lang::layout {

namespace {

constexpr std::size_t shortest_filled = 40; // shorter lists stay on their line

bool is_keyword(const Piece& piece) {
  if (piece.kind != TokenKind::name) return false;
  const Word word = classify(piece.text);
  return is_reserved(word) && word != Word::true_ && word != Word::false_ && word != Word::none_;
}

bool is_symbol(const Piece& piece, std::string_view text) {
  return piece.kind == TokenKind::symbol && piece.text == text;
}

bool is_tight(const Piece& piece) {
  return is_symbol(piece, ".") || is_symbol(piece, "..") || is_symbol(piece, "..<");
}

// Without the space, `1. .. 2` and `+ +x` would mean something else.
bool would_join(std::string_view left, std::string_view right) {
  return (left.ends_with('.') && right.starts_with('.')) || (left == "+" && right == "+");
}

bool is_for(const Piece& piece) {
  return piece.kind == TokenKind::name && piece.text == "for";
}

// Whether a value is expected at the piece: after an operator or a word that needs one, or first.
bool is_value_wanted(const std::vector<Piece>& pieces, std::size_t i) {
  while (i > 0 && is_comment(pieces[i - 1].kind)) --i;
  return i == 0 || pieces[i - 1].kind == TokenKind::symbol || is_keyword(pieces[i - 1]);
}

// Whether the piece is a sign, not a subtraction.
bool is_sign(const std::vector<Piece>& pieces, std::size_t i) {
  return (is_symbol(pieces[i], "-") || is_symbol(pieces[i], "+")) && is_value_wanted(pieces, i);
}

bool has_clause(const FormatEntry& entry) {
  return std::any_of(entry.pieces.begin(), entry.pieces.end(), is_for);
}

bool has_broken_clauses(const FormatEntry& entry) {
  for (std::size_t i = 1; i < entry.pieces.size(); ++i) {
    if (entry.pieces[i].begins_line && begins_clause(entry.pieces, i)) return true;
  }
  return false;
}

bool has_line_break(const Group& group) {
  if (group.is_broken || group.ends_on_new_line) return true;
  return std::any_of(group.entries.begin(), group.entries.end(),
                     [](const FormatEntry& entry) { return entry.begins_line || has_line_break_within(entry); });
}

bool ends_in_line_comment(const FormatEntry& entry) {
  return entry.is_comment || !entry.trailing_comment.empty() || entry.pieces.back().kind == TokenKind::line_comment;
}

void settle(FormatEntry& entry) {
  for (std::size_t i = 0; i < entry.pieces.size(); ++i) {
    if (i > 0 && entry.pieces[i - 1].kind == TokenKind::line_comment) entry.pieces[i].begins_line = true;
    if (entry.pieces[i].group) layout::settle(*entry.pieces[i].group);
  }
}

// The ways to break a group; each returns whether it changed anything.

bool break_block(Group& block) {
  return !std::exchange(block.is_broken, true);
}

bool break_clauses(Group& comprehension) {
  FormatEntry& element = comprehension.entries.front();
  if (comprehension.entries.size() > 1 || element.begins_line || !has_clause(element)) return false;
  for (std::size_t i = 1; i < element.pieces.size(); ++i) {
    if (begins_clause(element.pieces, i)) element.pieces[i].begins_line = true;
  }
  element.begins_line = true;
  comprehension.ends_on_new_line = true;
  return true;
}

bool fill_list(Group& list, std::size_t (*flat_width)(Group&)) {
  const bool can_be_filled =
      list.entries.size() > 1 && std::none_of(list.entries.begin(), list.entries.end(), [](const FormatEntry& entry) {
        return entry.is_comment || !entry.trailing_comment.empty() || has_line_break_within(entry);
      });
  if (!can_be_filled || flat_width(list) < shortest_filled) return false;
  return !std::exchange(list.is_filled, true);
}

} // namespace

bool has_space_before(const std::vector<Piece>& pieces, std::size_t i) {
  const Piece& left = pieces[i - 1];
  const Piece& right = pieces[i];
  if (is_comment(left.kind) || is_comment(right.kind)) return true;
  if (right.kind == TokenKind::separator || is_symbol(right, ":")) return false;
  if (would_join(left.text, right.text)) return true;
  if (is_tight(left) || is_tight(right) || is_sign(pieces, i - 1)) return false;
  if (left.kind == TokenKind::symbol || right.kind == TokenKind::symbol) return true;
  const bool is_suffix = right.group && right.group->bracket != '{';
  return !is_suffix || is_keyword(left);
}

bool begins_clause(const std::vector<Piece>& pieces, std::size_t i) {
  if (pieces[i].kind != TokenKind::name || (pieces[i].text != "for" && pieces[i].text != "if")) return false;
  if (is_value_wanted(pieces, i)) return false; // an `if` with blocks: `= if a { … } else if b { … }`
  return pieces[i].text == "for" ||
         std::any_of(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i), is_for);
}

bool has_line_break_within(const FormatEntry& entry) {
  return std::any_of(entry.pieces.begin(), entry.pieces.end(), [](const Piece& piece) {
    return piece.begins_line || (piece.group && has_line_break(*piece.group));
  });
}

void settle(Group& group) {
  bool is_list_broken = group.ends_on_new_line || !group.opening_comment.empty();
  bool must_break = !group.opening_comment.empty();
  for (FormatEntry& entry : group.entries) {
    settle(entry);
    if (group.bracket != '{') entry.sign_column = 0;
    entry.begins_line = entry.begins_line || must_break;
    must_break = ends_in_line_comment(entry);
    is_list_broken = is_list_broken || entry.begins_line || has_broken_clauses(entry);
  }
  if (group.entries.empty()) {
    group.is_broken = must_break;
    group.ends_on_new_line = must_break;
    return;
  }
  group.ends_on_new_line = group.ends_on_new_line || must_break;
  // In other brackets the line break may have been before a comma, where none is kept.
  group.is_broken = group.bracket == '{' && has_line_break(group);
  if (group.bracket == '[' && is_list_broken) {
    group.entries.front().begins_line = true;
    group.ends_on_new_line = true;
  }
}

bool break_more(FormatEntry& entry, std::size_t (*flat_width)(Group&)) {
  const auto in_groups = [&](char bracket, auto&& action) {
    bool has_changed = false;
    for (Piece& piece : entry.pieces) {
      const bool is_meant = piece.group && piece.group->bracket == bracket && !piece.group->entries.empty();
      if (is_meant && action(*piece.group)) has_changed = true;
    }
    return has_changed;
  };
  const auto fill = [&](Group& group) { return fill_list(group, flat_width); };
  const auto break_inner = [&](Group& group) {
    bool has_changed = false;
    for (FormatEntry& inner : group.entries) has_changed = break_more(inner, flat_width) || has_changed;
    return has_changed;
  };
  return in_groups('[', break_clauses) || in_groups('{', break_block) || in_groups('[', fill) ||
         in_groups('(', break_inner) || in_groups('[', break_inner);
}

void mark_commas(std::vector<FormatEntry>& items) {
  FormatEntry* before = nullptr;
  for (FormatEntry& item : items) {
    if (item.is_comment) continue;
    const auto first = std::find_if(item.pieces.begin(), item.pieces.end(),
                                    [](const Piece& piece) { return !is_comment(piece.kind); });
    const bool is_odd = first != item.pieces.end() && (is_symbol(*first, "-") || first->text == "{");
    if (before != nullptr) before->needs_comma = is_odd;
    before = &item;
  }
}

std::vector<std::size_t> aligned_columns(const std::vector<FormatEntry>& items) {
  const auto goes_on = [&](std::size_t i) {
    return items[i].sign_column == items[i - 1].sign_column && !items[i].follows_blank_line &&
           items[i].pieces[1].text == items[i - 1].pieces[1].text;
  };
  std::vector<std::size_t> columns(items.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
    end = begin + 1;
    if (items[begin].sign_column == 0) continue;
    while (end < items.size() && goes_on(end)) ++end;
    std::size_t shortest = items[begin].pieces[0].text.size(), longest = shortest;
    for (std::size_t i = begin; i < end; ++i) {
      shortest = std::min(shortest, items[i].pieces[0].text.size());
      longest = std::max(longest, items[i].pieces[0].text.size());
    }
    if (shortest == longest) continue;
    for (std::size_t i = begin; i < end; ++i) columns[i] = longest + 1;
  }
  return columns;
}

std::vector<std::size_t> comment_padding(const std::vector<FormatEntry>& items,
                                         const std::vector<std::size_t>& widths) {
  std::vector<std::size_t> padding(items.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
    end = begin + 1;
    if (items[begin].trailing_comment.empty()) continue;
    std::size_t widest_line = widths[begin];
    for (; end < items.size() && !items[end].trailing_comment.empty() && !items[end].follows_blank_line &&
           items[end].comment_column == items[begin].comment_column;
         ++end)
      widest_line = std::max(widest_line, widths[end]);
    for (std::size_t i = begin; i < end; ++i) padding[i] = widest_line - widths[i];
  }
  return padding;
}

} // namespace rt::lang::layout
