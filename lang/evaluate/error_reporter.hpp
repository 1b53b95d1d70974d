#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"
#include "lang/values/properties.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt::lang {

/// Reports run-time errors, with the call stack.
class ErrorReporter {
  struct CallFrame {
    const FunctionInfo* function;
    Span place;
    const CallFrame* caller;
  };

public:
  ErrorReporter(Report& report, const SymbolTable& symbols) : report_(report), symbols_(symbols) {}

  /// Reports an error, with the call stack; returns poison, to be passed on.
  Value fail(Diagnostic error);

  /// The output of `print`, unless it may never run.
  void print(std::string text, Span place);
  /// What was printed since the last call, in order: notes.
  std::vector<Diagnostic> take_printed() { return std::exchange(printed_, {}); }
  std::size_t printed_count() const { return printed_.size(); }

  Report& report() { return report_; }
  std::string_view name(Symbol symbol) const { return symbols_.name(symbol); }
  bool is_in_call() const { return calls_ != nullptr; }
  /// A condition is in error, so that the current code may never run: nothing is built.
  bool is_unsure() const { return unsure_ > 0; }

  /// During its lifetime it is uncertain whether the current code runs at all.
  class Unsure {
  public:
    explicit Unsure(ErrorReporter& reporter) : reporter_(reporter) { ++reporter_.unsure_; }
    Unsure(const Unsure&) = delete;
    Unsure& operator=(const Unsure&) = delete;
    ~Unsure() { --reporter_.unsure_; }

  private:
    ErrorReporter& reporter_;
  };

  /// During its lifetime errors are in a call of this function from that place.
  class TracedCall {
  public:
    TracedCall(ErrorReporter& reporter, const FunctionInfo& function, Span place)
        : reporter_(reporter), frame_{&function, place, reporter.calls_} {
      reporter_.calls_ = &frame_;
    }
    TracedCall(const TracedCall&) = delete;
    TracedCall& operator=(const TracedCall&) = delete;
    ~TracedCall() { reporter_.calls_ = frame_.caller; }

  private:
    ErrorReporter& reporter_;
    CallFrame frame_;
  };

  /// While it lives, a function is being compiled for the renderer.
  class Compilation {
  public:
    explicit Compilation(ErrorReporter& reporter) : reporter_(reporter) { ++reporter_.compilations_; }
    Compilation(const Compilation&) = delete;
    Compilation& operator=(const Compilation&) = delete;
    ~Compilation() { --reporter_.compilations_; }

  private:
    ErrorReporter& reporter_;
  };

private:
  Report& report_;
  const SymbolTable& symbols_;
  const CallFrame* calls_ = nullptr;
  int unsure_ = 0;
  int compilations_ = 0;
  std::vector<Diagnostic> printed_;
};

} // namespace rt::lang
