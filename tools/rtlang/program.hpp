#pragma once

#include <string>
#include <vector>

namespace rt::tools {

/// The whole program: reads the command line (without the program's name), does what it says and returns the exit code.
/// Errors are told on standard error.
int run(std::vector<std::string> arguments);

/// One subcommand of it for a session, which listens to signals by itself.
int run_for_session(std::vector<std::string> arguments);

} // namespace rt::tools
