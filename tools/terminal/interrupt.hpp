#pragma once

#include <atomic>

namespace rt::tools {

/// From now on SIGINT and SIGTERM only set the flag that `stop_flag` returns, the first time; a second signal ends the
/// program at once. A pipe whose reader is gone no longer kills the program, but makes writing fail.
void listen_to_signals();

/// Whether a signal has asked the program to stop. To be passed to whatever may take long.
const std::atomic<bool>& stop_flag();
/// The signal that asked to stop, 0 if none did.
int stop_signal();

/// Reports on standard error that the program ends because of a signal. May be called in a signal handler.
void say_stopped() noexcept;

/// For a session, which handles signals itself and outlives the work it stops. May be called in a signal handler.
void set_stop(bool is_wanted) noexcept;

/// During its lifetime the first signal ends the program at once: for work that cannot be asked to stop, and would
/// leave nothing half done behind. Throws Interrupted if a signal came before. Not for what a session handles.
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
