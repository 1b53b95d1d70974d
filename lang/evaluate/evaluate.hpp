#pragma once

#include "lang/builtins/expect.hpp"
#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"
#include "lang/evaluate/limits.hpp"
#include "lang/text/source.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace rt::lang {

struct Evaluated {
  scene::Scene scene;
  std::uint64_t steps = 0;
  Expectations expectations;
  std::vector<Diagnostic> printed; ///< by `print`, in order: notes
};

/// Runs a checked program: its result is the scene, with a default camera and light if it has none. The scene is valid
/// only if the report has no errors afterwards; parts in error are skipped, so that one run finds as many errors as
/// possible. Expectations are tested if there is an observer, and skipped otherwise. It modifies the trees (repeats
/// become one another) and does not restore them.
Evaluated evaluate(Program& program, Report& report, const Limits& limits, const std::atomic<bool>* stop,
                   const ObserverMaker& observe = {});

} // namespace rt::lang
