#pragma once

#include "lang/diagnostic.hpp"

#include <cstddef>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

namespace rt::lang {

/// Collects what check and evaluation have to say: each mistake once for each place, however often a loop comes by.
class Report {
public:
  static constexpr std::size_t most = 1'000;

  /// The diagnostic to be filled in, valid until the next call; null where this code was reported here already, or where
  /// there are too many.
  Diagnostic* add(Severity severity, std::string_view code, Span span);
  Diagnostic* error(std::string_view code, Span span) { return add(Severity::error, code, span); }
  /// Takes over the parser's diagnostics. What is said later about the same places follows from them and is left out.
  void take(std::vector<Diagnostic> diagnostics);

  bool has_errors() const { return errors_ > 0; }
  bool is_full() const { return diagnostics_.size() >= most; }
  /// All of them, in the order of their places in each file.
  std::vector<Diagnostic> finish();

private:
  std::vector<Diagnostic> diagnostics_;
  std::vector<Span> malformed_; // where the parser found errors
  std::set<std::tuple<FileId, std::uint32_t, std::uint32_t, std::string>> known_;
  std::size_t errors_ = 0;
};

} // namespace rt::lang
