#pragma once

#include <stdexcept>

namespace rt::tools {

/// What the program ends with. A signal that stopped it gives 128 and its number, so 130 after Ctrl-C, and a reader
/// that closed the pipe gives 141, as for any other program.
enum ExitCode : int {
  exit_fine = 0,
  exit_scene_is_wrong = 1, ///< or, of commands that judge: what was asked for does not hold
  exit_usage = 2,          ///< the command line makes no sense
  exit_environment = 3,    ///< disk, memory, a missing program
  exit_signal_base = 128,
  exit_broken_pipe = 141,
};

/// A command line that makes no sense; the message is for the user.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Work was ended early because a signal asked for it.
struct Interrupted {};

} // namespace rt::tools
