#pragma once

#include "lang/load.hpp"

#include <atomic>
#include <string>
#include <vector>

/// What is valid and probably not intended.
namespace rt::tools::explain {

struct LintOptions {
  double depth_share = 5;                  ///< percent of the pixels that may end at max_depth
  int threads = 0;                         ///< 0: one per core
  std::vector<std::string> allowed;        ///< rules by name or code
  const std::atomic<bool>* stop = nullptr; ///< set from outside: it ends early, and the result is meaningless
};

/// The warnings about a scene that was loaded with `LoadOptions::lint`, sorted by place: from its text, its
/// description, and the rays of its picture, without those that its comments suppress. If there is no scene, only those
/// about the text. The same for any number of threads.
///
/// The work is bounded: at most 600,000 pixels are examined (a regular grid of them in a larger picture), about 8,000
/// of them with all their reflections and shadows (ten times as many if a light seems to reach nothing). If more than
/// 300,000 shapes are placed, none is reported as too small or hidden.
std::vector<lang::Diagnostic> lint(const lang::Loaded& loaded, const LintOptions& options);

/// Throws QuestionError unless each word is a rule's name or code.
void require_rules(const std::vector<std::string>& words);
/// The warnings with excerpts of the text, a blank line after each.
std::string lint_text(const std::vector<lang::Diagnostic>& warnings, const lang::SourceMap& sources, bool use_color);

} // namespace rt::tools::explain
