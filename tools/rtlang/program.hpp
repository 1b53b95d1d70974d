#pragma once

#include <string>
#include <vector>

namespace rt::tools {

/// The whole program: parses the command line (without the program's name), runs it and returns the exit code. Errors
/// are reported on standard error.
int run(std::vector<std::string> arguments);

} // namespace rt::tools
