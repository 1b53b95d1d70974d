#include "lang/diagnostics/report.hpp"

#include "lang/text/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace rt::lang {
namespace {

/// The words of an item in sequence: no blanks, comments and separators, and numbers with their sign.
class Words {
public:
  struct Word {
    TokenKind kind;
    std::uint32_t begin, end;
    std::string_view text; ///< empty for literals
  };

  Words(std::string_view text, Span span) : text_(text), at_(span.begin), end_(span.end) {}

  std::optional<Word> next() {
    std::optional<std::uint32_t> sign;
    for (;;) {
      const Token token = next_token(text_, at_);
      if (token.kind == TokenKind::end || token.begin >= end_) return std::nullopt;
      at_ = token.end;
      const bool was_operand = std::exchange(is_operand_, false);
      if (is_blank(token.kind)) continue;
      const std::string_view text = text_of(text_, token);
      if (token.kind == TokenKind::symbol && (text == "-" || text == "+") && !was_operand) {
        sign = sign.value_or(token.begin);
        continue;
      }
      const bool is_literal = token.kind == TokenKind::number || token.kind == TokenKind::color;
      is_operand_ = is_literal || token.kind == TokenKind::name || token.kind == TokenKind::close;
      return Word{token.kind, sign.value_or(token.begin), token.end, is_literal ? std::string_view{} : text};
    }
  }

private:
  static bool is_blank(TokenKind kind) {
    return kind == TokenKind::newline || kind == TokenKind::line_comment || kind == TokenKind::block_comment ||
           kind == TokenKind::separator;
  }

  std::string_view text_;
  std::uint32_t at_, end_;
  bool is_operand_ = false; // a `-` or `+` after it is not a sign
};

} // namespace

// The same words in the item; the whole item if it is phrased differently (with more brackets, say).
Span RepeatSpans::place(Span span) const {
  if (span.file != model_.file || span.begin < model_.begin || span.end > model_.end) return span;
  const std::string_view text = sources_.file(model_.file).text;
  Words model(text, model_), item(text, item_);
  std::optional<std::uint32_t> begin;
  for (;;) {
    const auto ours = model.next(), theirs = item.next();
    if (!ours || !theirs || ours->kind != theirs->kind || ours->text != theirs->text) return item_;
    if (span.begin >= ours->begin && span.begin < ours->end) begin = theirs->begin;
    if (begin && span.end <= ours->end) return {span.file, *begin, theirs->end};
  }
}

Span Report::place(Span span) const {
  for (const RepeatSpans* s = stand_in_; s; s = s->outer_) span = s->place(span);
  return span;
}

Diagnostic* Report::add(Severity severity, std::string_view code, Span span) {
  if (severity == Severity::error) ++errors_;
  if (is_full()) {
    is_cut_ |= severity == Severity::error;
    return nullptr;
  }
  span = place(span);
  const auto overlaps = [&](const Span& other) {
    return other.file == span.file && other.begin < std::max(span.end, span.begin + 1) &&
           span.begin < std::max(other.end, other.begin + 1);
  };
  if (severity == Severity::error && std::ranges::any_of(malformed_, overlaps)) return nullptr;
  if (!known_.emplace(span.file, span.begin, span.end, std::string(code)).second) return nullptr;
  Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.severity = severity;
  diagnostic.code = code;
  diagnostic.span = span;
  return &diagnostic;
}

Diagnostic* Report::add(Diagnostic diagnostic) {
  Diagnostic* d = add(diagnostic.severity, diagnostic.code, diagnostic.span);
  if (!d) return nullptr;
  diagnostic.span = d->span; // of the item that a model stands for
  *d = std::move(diagnostic);
  return d;
}

void Report::malformed(Diagnostic diagnostic) {
  if (const Diagnostic* d = add(std::move(diagnostic))) malformed_.push_back(d->span);
}

Diagnostic* Report::remark(std::string_view code, Span span) {
  if (!wants_remarks_ || remarks_.size() >= most) return nullptr;
  if (!known_.emplace(span.file, span.begin, span.end, std::string(code)).second) return nullptr;
  Diagnostic& diagnostic = remarks_.emplace_back();
  diagnostic.severity = Severity::warning;
  diagnostic.code = code;
  diagnostic.span = span;
  return &diagnostic;
}

void Report::remark(std::string_view code, Span span, std::string message, std::string label, std::vector<Note> notes) {
  Diagnostic* d = remark(code, span);
  if (!d) return;
  d->message = std::move(message);
  d->label = std::move(label);
  d->notes = std::move(notes);
}

void Report::take(std::vector<Diagnostic> diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == Severity::error) {
      ++errors_;
      malformed_.push_back(diagnostic.span);
    }
    diagnostics_.push_back(std::move(diagnostic));
  }
}

namespace {

std::vector<Diagnostic> sorted(std::vector<Diagnostic> diagnostics) {
  const auto place = [](const Diagnostic& d) { return std::tuple(d.span.file, d.span.begin, d.span.end); };
  std::ranges::stable_sort(diagnostics, {}, place);
  return diagnostics;
}

} // namespace

std::vector<Diagnostic> Report::diagnostics() const {
  std::vector<Diagnostic> all = sorted(diagnostics_);
  if (is_cut_)
    all.back().notes.push_back(
        {std::nullopt, fmt::format("there are more mistakes: only {} mistakes are reported at once", most)});
  return all;
}

std::vector<Diagnostic> Report::remarks() const {
  return sorted(remarks_);
}

} // namespace rt::lang
