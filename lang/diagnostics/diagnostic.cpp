#include "lang/diagnostics/diagnostic.hpp"

#include "lang/text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace rt::lang {

namespace {

constexpr std::size_t tab_width = 4;
constexpr std::size_t widest_line = 100; // longer lines are clipped around the carets
constexpr std::size_t most_before =
    1'000; // characters of a line that are examined before the carets, and twice as many after them

// A message may quote the scene: terminal control characters become replacement characters.
std::string harmless(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Character c = decode(text);
    append_utf8(out, is_control(c.code_point) ? U'\ufffd' : c.code_point);
    text.remove_prefix(c.bytes);
  }
  return out;
}

// A source line as a terminal shows it, with the range that the carets mark, in columns from 0.
struct Excerpt {
  std::string text;
  std::size_t mark_begin = 0;
  std::size_t mark_end = 0;
};

// One character of a line as displayed.
struct ShownCharacter {
  std::string text;
  std::size_t column;
  std::size_t width;
};

std::vector<ShownCharacter> cells(std::string_view line, std::size_t most) {
  std::vector<ShownCharacter> out;
  std::size_t column = 0;
  while (!line.empty() && out.size() < most) {
    const Character c = decode(line);
    ShownCharacter cell{"", column, 1};
    if (c.code_point == U'\t') {
      cell.width = tab_width - column % tab_width;
      cell.text.assign(cell.width, ' ');
    } else if (is_control(c.code_point)) {
      append_utf8(cell.text, U'\ufffd');
    } else {
      append_utf8(cell.text, c.code_point);
      cell.width = static_cast<std::size_t>(display_width(c.code_point));
    }
    column += cell.width;
    out.push_back(std::move(cell));
    line.remove_prefix(c.bytes);
  }
  return out;
}

// `begin` and `end` count characters of the line.
Excerpt excerpt(std::string_view line, std::size_t begin, std::size_t end) {
  // A line may be as long as a file; only a part around the carets is shown.
  const std::size_t skipped = begin > most_before ? begin - most_before : 0;
  for (std::size_t i = 0; i < skipped && !line.empty(); ++i) line.remove_prefix(decode(line).bytes);
  begin -= skipped;
  end -= skipped;
  const std::vector<ShownCharacter> all = cells(line, 3 * most_before);
  const auto column = [&](std::size_t i) {
    return i < all.size() ? all[i].column : all.empty() ? 0 : all.back().column + all.back().width;
  };
  const std::size_t full_width = column(all.size());
  std::size_t from = 0, to = full_width;
  Excerpt out{"", column(begin), column(end)};
  if (full_width > widest_line) {
    // Keep the start of the line if the mark is visible then; else put the start of the mark at a third.
    if (out.mark_end > widest_line) from = out.mark_begin - std::min(out.mark_begin, widest_line / 3);
    to = std::min(full_width, from + widest_line);
  }
  std::size_t shift = 0; // how many columns the displayed text is to the left of the source's
  for (const ShownCharacter& cell : all) {
    if (cell.column < from) continue;
    if (cell.column + cell.width > to) break;
    if (out.text.empty() && from > 0) {
      out.text = "…";
      shift = cell.column - 1;
    }
    out.text += cell.text;
  }
  if (to < full_width) out.text += "…";
  out.mark_end = std::min(out.mark_end, to) - shift;
  out.mark_begin -= shift;
  out.mark_end = std::max(out.mark_end, out.mark_begin + 1);
  return out;
}

class Renderer {
public:
  Renderer(const SourceMap& sources, bool use_color) : sources_(sources), use_color_(use_color) {}

  std::string render(const Diagnostic& diagnostic) {
    gutter_ = gutter(diagnostic);
    const std::string_view color = color_of(diagnostic.severity);
    paint(color, diagnostic.code.empty() ? std::string(spelling(diagnostic.severity))
                                         : fmt::format("{}[{}]", spelling(diagnostic.severity), diagnostic.code));
    paint(bold, ": " + harmless(diagnostic.message));
    out_ += '\n';
    const bool is_about_all = diagnostic.severity != Severity::error && diagnostic.span.begin == diagnostic.span.end;
    if (!is_about_all) snippet(diagnostic.span, diagnostic.label, color);
    for (const Note& note : diagnostic.notes) this->note(note);
    call_stack(diagnostic.call_stack);
    return std::move(out_);
  }

private:
  static constexpr std::string_view bold = "1";
  static constexpr std::string_view blue = "1;34";
  static constexpr std::string_view green = "1;32";

  static std::string_view color_of(Severity severity) {
    switch (severity) {
    case Severity::note:
      return green;
    case Severity::warning:
      return "1;33";
    case Severity::error:
      break;
    }
    return "1;31";
  }

  void paint(std::string_view color, std::string_view text) {
    if (use_color_ && !text.empty()) {
      fmt::format_to(std::back_inserter(out_), "\x1b[{}m{}\x1b[0m", color, text);
    } else {
      out_ += text;
    }
  }

  std::string place(Span span) const {
    const Position at = sources_.position(span.file, span.begin);
    return fmt::format("{}:{}:{}", harmless(sources_.file(span.file).name), at.line, at.column);
  }

  // The width of the largest line number shown.
  std::size_t gutter(const Diagnostic& diagnostic) const {
    std::uint32_t line = sources_.position(diagnostic.span.file, diagnostic.span.begin).line;
    for (const Note& note : diagnostic.notes) {
      if (note.span) line = std::max(line, sources_.position(note.span->file, note.span->begin).line);
    }
    return std::to_string(line).size();
  }

  void bar(std::string_view number) { paint(blue, fmt::format("{:>{}} |", number, gutter_)); }

  void advice(std::string_view text) {
    paint(blue, fmt::format("{:>{}} =", "", gutter_));
    out_ += ' ';
    out_ += text;
    out_ += '\n';
  }

  void arrow(Span span) {
    paint(blue, fmt::format("{:>{}}-->", "", gutter_ + 1));
    out_ += ' ' + place(span) + '\n';
    for (FileId file = span.file; sources_.file(file).included_from.file != file;) {
      const Span from = sources_.file(file).included_from;
      out_ += fmt::format("{:>{}} included from {}\n", "", gutter_ + 4, place(from));
      file = from.file;
    }
  }

  void snippet(Span span, std::string_view label, std::string_view color) {
    arrow(span);
    const Position begin = sources_.position(span.file, span.begin);
    const Position end = sources_.position(span.file, span.end);
    const std::string_view line = sources_.line(span.file, begin.line);
    const std::size_t first = begin.column - 1;
    const std::size_t last = end.line == begin.line ? end.column - 1 : line.size(); // beyond the line: its end
    const Excerpt shown = excerpt(line, first, last);
    bar("");
    out_ += '\n';
    bar(std::to_string(begin.line));
    out_ += (shown.text.empty() ? "" : " ") + shown.text + '\n';
    bar("");
    out_ += ' ' + std::string(shown.mark_begin, ' ');
    std::string mark(shown.mark_end - shown.mark_begin, '^');
    if (!label.empty()) mark += ' ' + harmless(label);
    paint(color, mark);
    out_ += '\n';
  }

  void note(const Note& note) {
    if (!note.span) return advice("note: " + harmless(note.message));
    paint(green, "note");
    paint(bold, ": " + harmless(note.message));
    out_ += '\n';
    snippet(*note.span, "", green);
  }

  void call_stack(const std::vector<Note>& calls) {
    constexpr std::size_t most = 8, first = 5, last = 2; // innermost first
    for (std::size_t i = 0; i < calls.size(); ++i) {
      if (calls.size() > most && i == first) {
        const std::size_t left_out = calls.size() - first - last;
        advice(fmt::format("... {} more calls", left_out));
        i += left_out;
      }
      advice(harmless(calls[i].message) + (calls[i].span ? " at " + place(*calls[i].span) : ""));
    }
  }

  const SourceMap& sources_;
  bool use_color_;
  std::size_t gutter_ = 1;
  std::string out_;
};

} // namespace

Diagnostic make_error(std::string_view code, Span place, std::string message, std::string label,
                      std::vector<Note> notes) {
  return {Severity::error, std::string(code), std::move(message), place, std::move(label), std::move(notes), {}};
}

std::string_view spelling(Severity severity) {
  switch (severity) {
  case Severity::note:
    return "note";
  case Severity::warning:
    return "warning";
  case Severity::error:
    break;
  }
  return "error";
}

std::string render(const Diagnostic& diagnostic, const SourceMap& sources, bool use_color) {
  return Renderer(sources, use_color).render(diagnostic);
}

std::string render_line(const Diagnostic& diagnostic, const SourceMap& sources) {
  const Span span = diagnostic.span;
  const Position position = sources.position(span.file, span.begin);
  return fmt::format("{}:{}:{}: {}\n", sources.file(span.file).name, position.line, position.column,
                     harmless(diagnostic.message));
}

} // namespace rt::lang
