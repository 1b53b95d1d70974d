#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/text/source.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What all parts of the lint share: its rules by name, and the comments that allow what a rule would warn of.
namespace rt::lang {

/// A rule has a code of the registry and a name to write in a scene.
struct LintRule {
  std::string_view code; ///< "W0101"
  std::string_view name; ///< "never_placed"
};
/// All of them, in the order of their codes.
std::span<const LintRule> lint_rules();
/// By code or name; null where there is none.
const LintRule* find_lint_rule(std::string_view word);
/// The rules as a table for the reference.
std::string lint_rules_markdown();

/// `found` without what the scene allows: what a comment `// lint: allow NAME, …` names, on the line of its code or,
/// where it stands alone, on the next line with code; in all of a file with `in this file` behind the names; and
/// everywhere what `allowed` names. A comment that names no rule is a warning itself. Sorted by place; what is about
/// the scene as a whole comes last, and is allowed by a comment for the first file.
std::vector<Diagnostic> without_allowed(std::vector<Diagnostic> found, const SourceMap& sources,
                                        std::span<const std::string> allowed);

} // namespace rt::lang
