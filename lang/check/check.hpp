#pragma once

#include "lang/check/files.hpp"
#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"

namespace rt::lang {

/// Resolves every name of the program to its slot, reads the files that it includes and uses, and reports what can be
/// said without running it: names, properties, arguments, duplicates. `program.main`, `program.library` and the defines
/// must be parsed. What is in error is marked so that evaluation passes over it in silence.
void check(Program& program, Files& files, Report& report);

} // namespace rt::lang
