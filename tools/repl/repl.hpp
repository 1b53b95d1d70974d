#pragma once

#include "lang/load.hpp"

#include <string>

namespace rt::tools {

struct ReplOptions {
  std::string scene;        ///< the file to start with; empty: none
  bool keeps_going = false; ///< after an error, if the input is not a terminal
  lang::LoadOptions load;
};

/// The interactive session; without line editing on a terminal that cannot move its cursor; a script (no prompt, no
/// colours, ended by the first error) if standard input or output is not a terminal. Returns the exit code.
int run_repl(const ReplOptions& options);

} // namespace rt::tools
