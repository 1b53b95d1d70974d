#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/text/source.hpp"

#include <cstddef>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace rt::lang {

class RepeatSpans;

/// Collects the diagnostics of check and evaluation: each error once per place, however often a loop repeats it.
class Report {
public:
  static constexpr std::size_t most = 1'000;

  /// The diagnostic to be filled in, valid until the next call; null if this code was already reported here, or if
  /// there are too many.
  Diagnostic* add(Severity severity, std::string_view code, Span span);
  Diagnostic* error(std::string_view code, Span span) { return add(Severity::error, code, span); }
  /// The same, filled in.
  Diagnostic* add(Diagnostic diagnostic);
  void error(std::string_view code, Span span, std::string message, std::string label = {},
             std::vector<Note> notes = {}) {
    add(make_error(code, span, std::move(message), std::move(label), std::move(notes)));
  }
  /// As `error`; later errors about the same place are consequences and are dropped.
  void malformed(Diagnostic diagnostic);
  /// From now on `remark` takes the lint's warnings; they are kept separately.
  void want_remarks() { wants_remarks_ = true; }
  bool wants_remarks() const { return wants_remarks_; }
  /// A lint warning to be filled in; null if not requested, or already given here. Of items that a model stands for,
  /// only the first one's place is reported.
  Diagnostic* remark(std::string_view code, Span span);
  /// The same, filled in.
  void remark(std::string_view code, Span span, std::string message, std::string label, std::vector<Note> notes = {});
  /// All remarks, by file and place.
  std::vector<Diagnostic> remarks() const;

  /// Takes over the parser's diagnostics. Later errors about the same places are consequences and are dropped.
  void take(std::vector<Diagnostic> diagnostics);

  bool has_errors() const { return errors_ > 0; }
  /// Including those that were not listed.
  std::size_t error_count() const { return errors_; }
  bool is_full() const { return diagnostics_.size() >= most; }
  /// The real place of something given by its place in a model: see RepeatSpans.
  Span place(Span span) const;
  /// All of them, by file and place.
  std::vector<Diagnostic> diagnostics() const;

private:
  friend class RepeatSpans;

  std::vector<Diagnostic> diagnostics_;
  std::vector<Diagnostic> remarks_;
  std::vector<Span> malformed_; // where the syntax is wrong
  std::set<std::tuple<FileId, std::uint32_t, std::uint32_t, std::string>> known_;
  std::size_t errors_ = 0;
  bool is_cut_ = false; // there were more errors
  bool wants_remarks_ = false;
  const RepeatSpans* stand_in_ = nullptr;
};

/// During its lifetime a model stands in for items that differ from it only in literals (Repeat): diagnostics about a
/// place in the model are reported for the same words of the item.
class RepeatSpans {
public:
  RepeatSpans(Report& report, const SourceMap& sources, Span model)
      : report_(report), sources_(sources), model_(model), item_(model), outer_(report.stand_in_) {
    report_.stand_in_ = this;
  }
  ~RepeatSpans() { report_.stand_in_ = outer_; }
  RepeatSpans(const RepeatSpans&) = delete;
  RepeatSpans& operator=(const RepeatSpans&) = delete;

  /// From now on it stands in for this one.
  void stand_for(Span item) { item_ = item; }

private:
  friend class Report;

  Span place(Span span) const;

  Report& report_;
  const SourceMap& sources_;
  Span model_, item_;
  const RepeatSpans* outer_;
};

} // namespace rt::lang
