#pragma once

#include "lang/analyse.hpp"
#include "lang/builtins/expect.hpp"
#include "lang/diagnostics/diagnostic.hpp"
#include "lang/evaluate/limits.hpp"
#include "renderer/scene/scene.hpp"

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt::lang {

struct LoadOptions : AnalyseOptions {
  Limits limits;
  bool needs_things = false;               ///< a scene in which nothing is visible is an error
  ObserverMaker observe;                   ///< observes the scene for its expectations; if empty, they are not tested
  const std::atomic<bool>* stop = nullptr; ///< set from outside: loading ends early with a diagnostic
};

struct LoadStatistics {
  double parse_seconds = 0, check_seconds = 0, evaluate_seconds = 0;
  std::uint64_t bytes = 0, steps = 0;
};

/// The result of loading: a scene unless there is an error among the diagnostics; notes report the defaults assumed.
struct Loaded {
  std::optional<scene::Scene> scene;
  std::vector<Diagnostic> diagnostics;
  std::vector<Diagnostic> remarks; ///< of the lint, if requested: what the text alone shows
  std::vector<Diagnostic> printed; ///< by `print`, in order: notes
  SourceMap sources;
  LoadStatistics statistics;
  Expectations expectations;
};

/// Text to scene description: analyse, then evaluate. A file that cannot be read is an exception (std::system_error)
/// for the scene itself, a diagnostic for an include.
Loaded load_file(const std::string& path, const LoadOptions& options);
/// The same for a text that is not a file; relative includes are resolved against `folder`.
Loaded load_text(std::string text, std::string name, const std::string& folder, const LoadOptions& options);

} // namespace rt::lang
