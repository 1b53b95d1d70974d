#pragma once

#include <nlohmann/json.hpp>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

namespace rt::tools::lsp {

/// The messages of a client, read by a separate thread: so the server learns while it works that there is something
/// new, or that an answer is no longer wanted.
class Inbox {
public:
  explicit Inbox(int file);
  ~Inbox();
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  /// Waits for the next message; discarded JSON if it is malformed. Nothing after `exit`, or at the end of the input.
  std::optional<nlohmann::json> next();
  /// Whether the client has cancelled this request; the cancellation is then forgotten.
  bool take_cancelled(const nlohmann::json& id);

  /// Nothing is waiting. Until a message arrives, `has_news` is false.
  bool is_quiet();
  const std::atomic<bool>& has_news() const { return has_news_; }

  /// The input also ends when this process does.
  void end_with(int process) { process_ = process; }

private:
  void read(int file);
  void put(nlohmann::json message);
  bool is_over() const;

  std::atomic<bool> has_news_ = false, is_closing_ = false;
  std::atomic<int> process_ = 0;
  std::mutex mutex_; // guards what follows
  std::condition_variable wake_;
  std::deque<nlohmann::json> messages_;
  std::set<std::string> cancelled_; // ids, as JSON
  bool has_ended_ = false;

  std::jthread thread_; // last: it uses all of the above
};

} // namespace rt::tools::lsp
