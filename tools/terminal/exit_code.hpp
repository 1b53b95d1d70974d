#pragma once

#include <stdexcept>

namespace rt::tools {

/// The program's exit codes. If a signal stopped it, the code is 128 plus its number, so 130 after Ctrl-C, and 141 if
/// the reader closed the pipe, as for any other program.
enum ExitCode : int {
  exit_fine = 0,
  exit_scene_is_wrong = 1, ///< or, for commands that check something: the check failed
  exit_usage = 2,          ///< the command line is invalid
  exit_environment = 3,    ///< disk, memory, a missing program
  exit_signal_base = 128,
  exit_broken_pipe = 141,
};

/// An invalid command line; the message is for the user.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Work was ended early because a signal requested it.
struct Interrupted {};

} // namespace rt::tools
