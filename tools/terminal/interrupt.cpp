#include "tools/terminal/interrupt.hpp"

#include "tools/terminal/exit_code.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>

namespace rt::tools {
namespace {

// A signal handler can only access globals.
std::atomic<bool> stop{false};
std::atomic<int> signal_number{0};
std::atomic<bool> ends_at_once{false};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
  if (ends_at_once) {
    say_stopped();
    std::_Exit(exit_signal_base + number);
  }
  signal_number = number;
  stop = true;
}

} // namespace

void say_stopped() noexcept {
  constexpr std::string_view message = "rtlang: stopped\n";
  if (::write(STDERR_FILENO, message.data(), message.size()) < 0) return; // there is nowhere to report it
}

void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  // Without SA_RESTART a read that waits for input returns, so that it can be abandoned.
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction old {};
    // What the caller chose to ignore (nohup, a background job of a script) stays ignored.
    if (sigaction(number, nullptr, &old) == 0 && old.sa_handler != SIG_IGN) sigaction(number, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

const std::atomic<bool>& stop_flag() {
  return stop;
}

void set_stop(bool is_wanted) noexcept {
  stop = is_wanted;
}

int stop_signal() {
  return signal_number;
}

EndsAtOnce::EndsAtOnce() {
  ends_at_once = true;
  if (!stop) return;
  ends_at_once = false;
  throw Interrupted{};
}

EndsAtOnce::~EndsAtOnce() {
  ends_at_once = false;
}

void throw_if_stopped() {
  if (stop) throw Interrupted{};
}

} // namespace rt::tools
