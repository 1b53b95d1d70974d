#pragma once

#include "tools/lsp/answers.hpp"
#include "tools/lsp/request_error.hpp"
#include "tools/lsp/workspace.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A server of the Language Server Protocol, version 3.17 (microsoft.github.io/language-server-protocol).
namespace rt::tools::lsp {

class Server {
public:
  using Send = std::function<void(const nlohmann::json& message)>;
  /// `is_cancelled` is called once for each request, with its id.
  Server(std::vector<std::string> include_roots, Send send, std::function<bool(const nlohmann::json& id)> is_cancelled);

  /// Handles any message from the client, and sends the response.
  void handle(const nlohmann::json& message);
  /// Sends the diagnostics that have changed since the last call. Gives up if `stop` is set meanwhile: then `has_work`
  /// stays true.
  void publish(const std::atomic<bool>& stop);
  bool has_work() const { return state_ == State::running && is_outdated_; }

  /// The client's process, once known; 0 before, or if it has none.
  int client_process() const { return client_process_; }
  /// The exit code, once the client has asked the server to exit.
  std::optional<int> exit_code() const { return exit_code_; }
  /// The exit code if the client disappears without asking.
  int exit_code_at_end() const { return state_ == State::shut_down ? 0 : 1; }

private:
  enum class State : std::uint8_t { uninitialized, running, shut_down };
  using Params = const nlohmann::json&;

  nlohmann::json answer(std::string_view method, Params params);
  void notify(std::string_view method, Params params);
  void respond(Params id, nlohmann::json result);
  void fail(Params id, ErrorCode code, std::string_view message);
  void log(std::string_view text);

  nlohmann::json initialize(Params params);
  nlohmann::json shut_down(Params params);
  void initialized();
  void did_open(Params params);
  void did_change(Params params);
  void did_close(Params params);

  Workspace workspace_;
  Answers answers_;
  Send send_;
  std::function<bool(const nlohmann::json& id)> is_cancelled_;
  State state_ = State::uninitialized;
  bool watches_files_ = false; // the client can report file changes
  bool is_outdated_ = false;
  std::map<std::string, nlohmann::json> published_; // by URI
  int client_process_ = 0;
  std::optional<int> exit_code_;
};

struct ServerOptions {
  std::vector<std::string> include_roots; ///< folders besides a scene's own that it may read from
};

/// Serves the client on standard input and output until it disconnects. The result is the exit code: 0 after
/// `shutdown`, else 1.
int run_server(const ServerOptions& options);

} // namespace rt::tools::lsp
