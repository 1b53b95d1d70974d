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

/// Runs a checked program: what it says becomes the scene, with a camera and a light where it has none. The scene is
/// worth looking at only if the report has no error afterwards; parts that are in error are passed over, so that one
/// run finds as many mistakes as there are. Expectations are tried where there is an observer, and passed over
/// otherwise. Trees are changed by it (repeats become one another), and not restored.
Evaluated evaluate(Program& program, Report& report, const Limits& limits, const std::atomic<bool>* stop,
                   const ObserverMaker& observe = {});

} // namespace rt::lang
