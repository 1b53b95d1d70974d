#pragma once

#include <functional>
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

/// Runs a program in `folder`, its output going to the file `log` there. Throws std::system_error if it cannot be
/// started and std::runtime_error, with the log's last lines, if it fails.
Cost run(const Command& command, const std::string& folder, const std::string& log);

/// Runs `work` in a process of its own, so that this one stays small: the peak memory of a program that it starts
/// counts from its own size. Throws std::runtime_error if it fails; what it throws is printed.
void run_apart(const std::function<void()>& work);

/// As one would type it into a shell.
std::string shell_text(const Command& command);

} // namespace rt::tools::bench
