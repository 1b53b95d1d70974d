#pragma once

#include "lang/load.hpp"

#include <string>

namespace rt::tools {

struct ReplOptions {
  std::string scene;        ///< the file to begin with; empty: none
  bool keeps_going = false; ///< after an error, where the input is no terminal
  lang::LoadOptions load;
};

/// The interactive session; at a terminal that cannot move its cursor with prompts alone; a script (no prompt, no
/// colours, ended by the first error) where standard input or output is no terminal. The result is the exit code.
int run_repl(const ReplOptions& options);

} // namespace rt::tools
