#pragma once

#include "lang/load.hpp"

#include <atomic>
#include <string>
#include <vector>

/// What is well formed and hardly meant.
namespace rt::tools::explain {

struct LintOptions {
  double depth_share = 5;                  ///< percent of the pixels that may end at max_depth
  int threads = 0;                         ///< 0: one for each core
  std::vector<std::string> allowed;        ///< rules by name or code
  const std::atomic<bool>* stop = nullptr; ///< set from outside: it ends early, and what it returns means nothing
};

/// The warnings about a scene that was loaded with `LoadOptions::lint`, sorted by place: what its text shows, what its
/// description shows, and what the rays of its picture meet, with what comments in it allow left out. Without a scene
/// there are those of the text alone. The same for any number of threads.
///
/// The work is bounded: at most 600,000 pixels are looked at (of a larger picture, a regular grid of them), about 8,000
/// of them with all their reflections and shadows (ten times as many where a light seems to reach nothing). Where more
/// than 300,000 shapes are placed, none is called too small or hidden.
std::vector<lang::Diagnostic> lint(const lang::Loaded& loaded, const LintOptions& options);

/// Throws QuestionError unless each word is a rule's name or code.
void require_rules(const std::vector<std::string>& words);
/// The warnings with their places in the text, a blank line after each.
std::string lint_text(const std::vector<lang::Diagnostic>& warnings, const lang::SourceMap& sources, bool use_color);

} // namespace rt::tools::explain
