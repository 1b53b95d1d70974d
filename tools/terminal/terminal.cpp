#include "tools/terminal/terminal.hpp"

#include "tools/terminal/interrupt.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

namespace rt::tools {
namespace {

// What a signal handler accesses is necessarily global.
std::atomic<int> interrupt_scopes{0};
std::atomic<int> pipe_write_end{-1};
int pipe_read_end = -1;
struct sigaction previous_interrupt, previous_resize;

void handle(int signal) {
  const int saved = errno;
  char event = 'W';
  if (signal == SIGINT) {
    event = 'I';
    if (interrupt_scopes > 0) {
      set_stop(true);
      errno = saved;
      return;
    }
  }
  [[maybe_unused]] const ssize_t n = ::write(pipe_write_end, &event, 1); // if the pipe is full, it has news enough
  errno = saved;
}

void send(std::string_view sequence) {
  [[maybe_unused]] const ssize_t n = ::write(STDOUT_FILENO, sequence.data(), sequence.size());
}

} // namespace

TerminalSize terminal_size() {
  TerminalSize size;
  winsize found{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &found) != 0) return size;
  if (found.ws_col > 0) size.columns = found.ws_col;
  if (found.ws_row > 0) size.rows = found.ws_row;
  size.pixel_width = found.ws_xpixel;
  size.pixel_height = found.ws_ypixel;
  return size;
}

Console console() {
  if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) return Console::none;
  const char* name = std::getenv("TERM");
  return name && std::string_view(name) == "dumb" ? Console::plain : Console::full;
}

QuietTerminal::QuietTerminal() {
  if (tcgetattr(STDIN_FILENO, &original_) != 0) return;
  termios quiet = original_;
  quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO | ICANON);
  quiet.c_cc[VMIN] = 1;
  quiet.c_cc[VTIME] = 0;
  is_set_ = tcsetattr(STDIN_FILENO, TCSADRAIN, &quiet) == 0;
}

QuietTerminal::~QuietTerminal() {
  if (is_set_) tcsetattr(STDIN_FILENO, TCSADRAIN, &original_);
}

BracketedPaste::BracketedPaste() {
  send("\x1b[?2004h");
}
BracketedPaste::~BracketedPaste() {
  send("\x1b[?2004l");
}

// If no terminal is being read, the program's own signal handling applies, and its flag stays.
InterruptScope::InterruptScope() {
  if (pipe_read_end >= 0 && interrupt_scopes == 0) set_stop(false);
  ++interrupt_scopes;
}
InterruptScope::~InterruptScope() {
  --interrupt_scopes;
  if (pipe_read_end >= 0 && interrupt_scopes == 0) set_stop(false);
}
const std::atomic<bool>& InterruptScope::stop() const {
  return stop_flag();
}

namespace detail {

int signal_pipe() {
  return pipe_read_end;
}

void listen_to_terminal_signals() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  pipe_read_end = ends[0];
  pipe_write_end = ends[1];
  struct sigaction action {};
  action.sa_handler = handle;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &previous_interrupt);
  sigaction(SIGWINCH, &action, &previous_resize);
}

void restore_terminal_signals() {
  sigaction(SIGINT, &previous_interrupt, nullptr);
  sigaction(SIGWINCH, &previous_resize, nullptr);
  close(pipe_read_end);
  close(pipe_write_end);
  pipe_read_end = pipe_write_end = -1;
}

} // namespace detail
} // namespace rt::tools
