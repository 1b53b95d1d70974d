#pragma once

#include <string>
#include <vector>

namespace rt::tools::bench {

/// What a finished process has cost.
struct Cost {
  double user_seconds = 0;
  double system_seconds = 0;
  double wall_seconds = 0;
  double peak_megabytes = 0; ///< of 2²⁰ bytes
};

using Command = std::vector<std::string>;

/// Runs a program in `folder`, its output going to the file `log` there. Throws std::system_error if it cannot be started
/// and std::runtime_error, with the log's last lines, if it fails.
Cost run(const Command& command, const std::string& folder, const std::string& log);

/// As one would type it into a shell.
std::string shell_text(const Command& command);

/// What the program prints, standard error included; empty if it cannot be run.
std::string output_of(const Command& command);

} // namespace rt::tools::bench
