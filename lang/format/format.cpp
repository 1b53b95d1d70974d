#include "lang/format/format.hpp"

#include "lang/format/format_layout.hpp"
#include "lang/syntax/parse.hpp"
#include "lang/text/utf8.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rt::lang {

namespace {

using layout::FormatEntry;
using layout::Group;
using layout::Piece;
using layout::step;
using layout::widest;

constexpr std::size_t none = std::string::npos;

class Writer {
public:
  std::string file(Group& group) {
    layout::settle(group);
    items(group, 0);
    return std::move(out_);
  }

  /// The width of an entry on a single line.
  static std::size_t width(FormatEntry& entry) {
    Writer flat;
    flat.pieces(entry, 0);
    return display_width(flat.out_);
  }

  static std::size_t flat_width(Group& list) {
    std::size_t sum = 0;
    for (FormatEntry& entry : list.entries) sum += width(entry) + 2;
    return sum;
  }

private:
  void measure() {
    const std::size_t end = std::min(comment_, out_.size());
    widest_ = std::max(widest_, display_width(std::string_view(out_).substr(line_, end - line_)));
  }

  void begin_line(std::size_t indent) {
    line_ = out_.size();
    comment_ = none;
    out_.append(indent, ' ');
  }

  void new_line(std::size_t indent) {
    measure();
    out_ += '\n';
    begin_line(indent);
  }

  // Comments have no width: they never cause a line to be broken.
  void comment(std::string_view text) {
    measure();
    if (comment_ == none) comment_ = out_.size();
    text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
    std::copy_if(text.begin(), text.end(), std::back_inserter(out_), [](char c) { return c != '\r'; });
    const std::size_t newline = out_.rfind('\n');
    if (newline != none && newline >= line_) line_ = comment_ = newline + 1;
  }

  // One entry per line, starting at the beginning of the line.
  void items(Group& group, std::size_t indent) {
    const std::size_t outer_widest = widest_;
    layout::mark_commas(group.entries);
    for (FormatEntry& item : group.entries) {
      if (item.sign_column > 0 && is_too_wide(item, indent)) item.sign_column = 0; // it will be broken
    }
    const std::vector<std::size_t> columns = layout::aligned_columns(group.entries);
    std::vector<std::size_t> comments(group.entries.size(), none);
    for (std::size_t i = 0; i < group.entries.size(); ++i) {
      FormatEntry& item = group.entries[i];
      item.sign_column = columns[i];
      if (item.follows_blank_line && i > 0) out_ += '\n';
      begin_line(indent);
      comments[i] = fitting(item, indent);
      out_ += '\n';
    }
    align_comments(group.entries, comments);
    widest_ = outer_widest;
  }

  static bool is_too_wide(FormatEntry& item, std::size_t indent) {
    return layout::has_line_break_within(item) || indent + width(item) > widest;
  }

  // `places`: of the trailing comments of what was just written, up to the beginning of the current line.
  void align_comments(const std::vector<FormatEntry>& entries, const std::vector<std::size_t>& places) {
    std::vector<std::size_t> widths(entries.size(), 0);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (places[i] == none) continue;
      const std::size_t newline = places[i] == 0 ? none : out_.rfind('\n', places[i] - 1);
      const std::size_t line = newline == none ? 0 : newline + 1;
      widths[i] = display_width(std::string_view(out_).substr(line, places[i] - line));
    }
    const std::vector<std::size_t> padding = layout::comment_padding(entries, widths);
    const auto first = std::find_if(padding.begin(), padding.end(), [](std::size_t spaces) { return spaces > 0; });
    if (first == padding.end()) return;
    std::size_t at = places[static_cast<std::size_t>(first - padding.begin())];
    const std::string tail = out_.substr(at);
    const std::size_t offset = at;
    out_.resize(at);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (padding[i] == 0) continue;
      out_.append(tail, at - offset, places[i] - at);
      out_.append(padding[i], ' ');
      at = places[i];
    }
    out_.append(tail, at - offset);
    line_ += out_.size() - offset - tail.size();
  }

  // An entry with lines of its own: written as it is, and again with more line breaks for as long as it is too wide.
  // Returns the place of its trailing comment.
  std::size_t fitting(FormatEntry& entry, std::size_t indent) {
    const std::size_t outer_widest = std::exchange(widest_, 0);
    const std::size_t begin = out_.size(), line = line_;
    for (;;) {
      pieces(entry, indent);
      measure();
      if (widest_ <= widest || !layout::break_more(entry, flat_width)) break;
      out_.resize(begin);
      line_ = line;
      comment_ = none;
      widest_ = 0;
    }
    const std::size_t place = trailing_comment(entry);
    widest_ = outer_widest;
    return place;
  }

  // The place before its space; `none` if there is none.
  std::size_t trailing_comment(const FormatEntry& entry) {
    if (entry.needs_comma) out_ += ',';
    if (entry.trailing_comment.empty()) return none;
    const std::size_t place = out_.size();
    out_ += ' ';
    comment(entry.trailing_comment);
    return place;
  }

  void pieces(FormatEntry& entry, std::size_t indent) {
    std::size_t inner = indent;
    for (std::size_t i = 0; i < entry.pieces.size(); ++i) {
      Piece& piece = entry.pieces[i];
      if (piece.begins_line) {
        inner = layout::begins_clause(entry.pieces, i) ? indent : indent + step;
        new_line(inner);
      } else if (i == 1 && entry.sign_column > 0) {
        out_.append(entry.sign_column - entry.pieces[0].text.size(), ' ');
      } else if (i > 0 && layout::has_space_before(entry.pieces, i)) {
        out_ += ' ';
      }
      if (piece.group) {
        group(*piece.group, inner);
      } else if (layout::is_comment(piece.kind)) {
        comment(piece.text);
      } else {
        out_ += piece.text;
      }
    }
  }

  void group(Group& group, std::size_t indent) {
    out_ += group.bracket;
    if (!group.opening_comment.empty()) {
      out_ += ' ';
      comment(group.opening_comment);
    }
    if (group.bracket == '{') return block(group, indent);
    if (group.is_filled) fill(group, indent + step);
    std::vector<std::size_t> comments(group.entries.size(), none);
    for (std::size_t i = 0; i < group.entries.size(); ++i) comments[i] = element(group, i, indent);
    if (group.ends_on_new_line) {
      new_line(indent);
      align_comments(group.entries, comments);
    }
    out_ += group.bracket == '[' ? ']' : ')';
  }

  void block(Group& group, std::size_t indent) {
    if (group.is_broken) {
      measure();
      out_ += '\n';
      items(group, indent + step);
      begin_line(indent);
    } else {
      for (FormatEntry& entry : group.entries) {
        entry.sign_column = 0;
        out_ += &entry == &group.entries.front() ? " " : ", ";
        pieces(entry, indent);
      }
      if (!group.entries.empty()) out_ += ' ';
    }
    out_ += '}';
  }

  // In a list a line break separates as a comma does. Returns the place of a trailing comment.
  std::size_t element(Group& group, std::size_t i, std::size_t indent) {
    FormatEntry& entry = group.entries[i];
    if (i > 0 && (group.bracket == '(' || !entry.begins_line)) out_ += ',';
    if (entry.begins_line) {
      if (entry.follows_blank_line && i > 0 && group.bracket == '[') {
        measure();
        out_ += '\n';
        line_ = out_.size();
        out_ += '\n';
        begin_line(indent + step);
      } else {
        new_line(indent + step);
      }
    } else if (i > 0) {
      out_ += ' ';
    }
    const bool is_last_of_line =
        i + 1 < group.entries.size() ? group.entries[i + 1].begins_line : group.ends_on_new_line;
    const bool is_indented = group.entries.front().begins_line || entry.begins_line;
    if (entry.begins_line && is_last_of_line) return fitting(entry, indent + step);
    pieces(entry, is_indented ? indent + step : indent);
    return trailing_comment(entry);
  }

  // As many elements per line as fit: on every write, because its surroundings may have moved it since.
  void fill(Group& group, std::size_t indent) {
    if (std::any_of(group.entries.begin(), group.entries.end(), layout::has_line_break_within)) return; // broken by now
    std::size_t column = 0;
    for (FormatEntry& entry : group.entries) {
      const std::size_t size = width(entry);
      entry.begins_line = column == 0 || column + 2 + size > widest;
      entry.follows_blank_line = false;
      column = entry.begins_line ? indent + size : column + 2 + size;
    }
    group.ends_on_new_line = true;
  }

  std::string out_;
  std::size_t line_ = 0;       ///< where the current line begins
  std::size_t comment_ = none; ///< where its comment begins
  std::size_t widest_ = 0;     ///< of the lines of the current entry
};

} // namespace

Formatted format(const SourceMap& sources, FileId file) {
  const std::string& text = sources.file(file).text;
  SymbolTable symbols;
  Parsed before = parse(sources, file, symbols);
  if (!before.diagnostics.empty()) return {text, std::move(before.diagnostics)};
  layout::Group tree = layout::read(text);
  std::string formatted = Writer().file(tree);
  SourceMap rewritten;
  const Parsed after = parse(rewritten, rewritten.add("", "", formatted), symbols);
  // Whatever the layout, the meaning of a file must not change.
  const bool is_faithful = after.diagnostics.empty() && equal(before.ast, symbols, after.ast, symbols);
  return {is_faithful ? std::move(formatted) : text, {}};
}

} // namespace rt::lang
