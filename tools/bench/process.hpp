#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rt::tools::bench {

/// The resources used by a finished process.
struct Cost {
  double user_seconds = 0;
  double system_seconds = 0;
  double wall_seconds = 0;
  double peak_megabytes = 0; ///< in units of 2²⁰ bytes
};

using Command = std::vector<std::string>;

/// Runs a program in `folder`, with its output in the file `log` there. Throws std::system_error if it cannot be
/// started and std::runtime_error, with the log's last lines, if it fails.
Cost run(const Command& command, const std::string& folder, const std::string& log);

/// Runs `work` in a separate process, so that this one stays small: the peak memory of a child is counted from its
/// parent's size on. Throws std::runtime_error if it fails; what it throws is printed.
void run_apart(const std::function<void()>& work);

/// As typed into a shell.
std::string shell_text(const Command& command);

} // namespace rt::tools::bench
