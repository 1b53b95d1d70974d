#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/text/source.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What all parts of the lint share: its rules by name, and the comments that suppress warnings.
namespace rt::lang {

/// A rule has a code in the registry and a name to write in a scene.
struct LintRule {
  std::string_view code; ///< "W0101"
  std::string_view name; ///< "never_placed"
};
/// The names by which the code refers to the rules.
namespace lint_rule {
inline constexpr LintRule unknown_rule{"W0001", "unknown_rule"};
inline constexpr LintRule never_placed{"W0101", "never_placed"};
inline constexpr LintRule never_used{"W0102", "never_used"};
inline constexpr LintRule unused_parameter{"W0103", "unused_parameter"};
inline constexpr LintRule radians{"W0104", "radians"};
inline constexpr LintRule hides_noun{"W0105", "hides_noun"};
inline constexpr LintRule no_ior{"W0106", "no_ior"};
inline constexpr LintRule camera_inside{"W0201", "camera_inside"};
inline constexpr LintRule light_inside{"W0202", "light_inside"};
inline constexpr LintRule nothing_in_view{"W0203", "nothing_in_view"};
inline constexpr LintRule behind_camera{"W0204", "behind_camera"};
inline constexpr LintRule coincident{"W0205", "coincident"};
inline constexpr LintRule too_small{"W0206", "too_small"};
inline constexpr LintRule hidden{"W0207", "hidden"};
inline constexpr LintRule overlapping_media{"W0208", "overlapping_media"};
inline constexpr LintRule nearly_flat{"W0209", "nearly_flat"};
inline constexpr LintRule dark_light{"W0301", "dark_light"};
inline constexpr LintRule black_picture{"W0302", "black_picture"};
inline constexpr LintRule clipped_picture{"W0303", "clipped_picture"};
inline constexpr LintRule depth_reached{"W0304", "depth_reached"};
} // namespace lint_rule

/// All of them, in the order of their codes.
std::span<const LintRule> lint_rules();
/// By code or name; null if there is none.
const LintRule* find_lint_rule(std::string_view word);
/// The rules as a table for the reference.
std::string lint_rules_markdown();

/// `found` without what the scene suppresses: the rules named by a comment `// lint: allow NAME, …`, on the line of its
/// code or, if it stands alone, on the next line with code; in a whole file with `in this file` after the names; and
/// everywhere those in `allowed`. A comment that names no rule is itself a warning. Sorted by place; what concerns the
/// scene as a whole comes last and is suppressed by a comment for the first file.
std::vector<Diagnostic> without_allowed(std::vector<Diagnostic> found, const SourceMap& sources,
                                        std::span<const std::string> allowed);

} // namespace rt::lang
