#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"

namespace rt::lang {

/// Warns of what is well formed but probably not meant, as far as the text alone shows it. The program is checked, and
/// its references are kept.
void lint_text(const Program& program, Report& report);

/// Names that lead to nothing in the scene.
void lint_unused_names(const Program& program, Report& report);
/// Names that hide a thing of the language.
void lint_hidden_nouns(const Program& program, Report& report);
/// Radians where degrees are meant.
void lint_angles(const Program& program, Report& report);

} // namespace rt::lang
