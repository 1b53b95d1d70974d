#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"

namespace rt::lang {

/// Warns of what is valid but probably not intended, as far as the text alone shows it. The program must be checked,
/// with its references kept.
void lint_text(const Program& program, Report& report);

/// Names that do not contribute to the scene.
void lint_unused_names(const Program& program, Report& report);
/// Names that hide a thing of the language.
void lint_hidden_nouns(const Program& program, Report& report);
/// Radians where degrees are expected.
void lint_angles(const Program& program, Report& report);

} // namespace rt::lang
