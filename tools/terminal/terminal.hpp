#pragma once

#include <termios.h>

#include <atomic>
#include <cstdint>

namespace rt::tools {

/// The size of the terminal at standard output; pixels are 0 if unknown.
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

/// Between two lines the terminal neither echoes nor is in line mode, so that what is typed ahead waits invisibly. Its
/// original mode is restored at the end.
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

/// During its lifetime the terminal brackets pastes.
struct BracketedPaste {
  BracketedPaste();
  ~BracketedPaste();
  BracketedPaste(const BracketedPaste&) = delete;
  BracketedPaste& operator=(const BracketedPaste&) = delete;
};

/// During its lifetime Ctrl-C only sets `stop()`. Scopes may be nested.
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
