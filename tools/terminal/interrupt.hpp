#pragma once

#include <atomic>

namespace rt::tools {

/// From now on SIGINT and SIGTERM only set the flag that `stop_flag` returns, the first time; a second signal ends the
/// program at once. A pipe whose reader is gone no longer kills, but makes writing fail.
void listen_to_signals();

/// Whether a signal has asked the program to stop. To be handed to whatever may take long.
const std::atomic<bool>& stop_flag();
/// The signal that asked, 0 if none did.
int stop_signal();

/// Says on standard error that the program ends because a signal asked for it. May be called in a signal handler.
void say_stopped() noexcept;

/// For a session, which listens by itself and outlives what it is asked to stop. May be called in a signal handler.
void set_stop(bool is_wanted) noexcept;

/// While one of these lives, the first signal ends the program at once: for work that cannot be asked to stop, and
/// would leave nothing half done behind. Throws Interrupted if a signal came before. Not for what a session listens to.
class EndsAtOnce {
public:
  EndsAtOnce();
  ~EndsAtOnce();
  EndsAtOnce(const EndsAtOnce&) = delete;
  EndsAtOnce& operator=(const EndsAtOnce&) = delete;
};

/// Throws Interrupted if a signal has asked the program to stop.
void throw_if_stopped();

} // namespace rt::tools
