#pragma once

#include <termios.h>

#include <atomic>
#include <cstdint>

namespace rt::tools {

/// Of the terminal at standard output; pixels are 0 where it does not say.
struct TerminalSize {
  int columns = 80, rows = 24;
  int pixel_width = 0, pixel_height = 0;
};
TerminalSize terminal_size();

/// What standard input and output are.
enum class Console : std::uint8_t {
  none,  ///< not both a terminal
  plain, ///< one that cannot move its cursor: TERM=dumb, as in an editor's shell
  full,
};
Console console();

/// Between two lines the terminal neither echoes nor waits for whole lines, so that what is typed ahead waits in
/// silence. Its own mode comes back at the end.
class QuietTerminal {
public:
  QuietTerminal();
  ~QuietTerminal();
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;

private:
  termios original_{};
  bool is_set_ = false;
};

/// While it exists the terminal marks what is pasted.
struct BracketedPaste {
  BracketedPaste();
  ~BracketedPaste();
  BracketedPaste(const BracketedPaste&) = delete;
  BracketedPaste& operator=(const BracketedPaste&) = delete;
};

/// While it exists Ctrl-C sets `stop()` and does nothing else. Scopes may be nested.
class InterruptScope {
public:
  InterruptScope();
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

  const std::atomic<bool>& stop() const;
};

namespace detail {
/// The read end of the pipe through which signals arrive as bytes: 'I' for SIGINT outside an InterruptScope, 'W' for
/// SIGWINCH.
int signal_pipe();
void listen_to_terminal_signals();
void restore_terminal_signals();
} // namespace detail

} // namespace rt::tools
