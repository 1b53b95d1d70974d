#pragma once

#include <nlohmann/json.hpp>
#include <sys/types.h>

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace rt::tests {

/// An editor's side of `rtlang lsp`: the real program, with pipes for its input and output.
class LspClient {
public:
  using json = nlohmann::json;

  explicit LspClient(const std::vector<std::string>& arguments = {});
  ~LspClient(); ///< kills it, where it still runs
  LspClient(const LspClient&) = delete;
  LspClient& operator=(const LspClient&) = delete;

  void send_raw(const std::string& bytes);
  void send(const json& message);
  void notify(const std::string& method, const json& params);
  /// Sends a request and gives its id.
  int ask(const std::string& method, const json& params);
  /// The whole response. Other messages that come before it are kept.
  json response(const json& id);
  json request(const std::string& method, const json& params) { return response(ask(method, params)); }
  json result(const std::string& method, const json& params) { return request(method, params).at("result"); }

  /// `initialize` and `initialized`; the result of the first.
  json initialize(const json& capabilities = json::object());
  void open(const std::string& uri, const std::string& text, int version = 1);
  /// The diagnostics of a text in this version.
  json diagnostics(const std::string& uri, int version = 1);
  /// The next message for which it is true. Throws std::runtime_error where none comes in 20 s.
  json wait_for(const std::function<bool(const json&)>& is_it);

  void close_input();
  void signal(int number) const { ::kill(process_, number); }
  int exit_code(); ///< once it has ended; the negative number of a signal that ended it

private:
  json read();

  pid_t process_ = 0;
  int input_ = -1, output_ = -1;
  int last_id_ = 0;
  std::string bytes_;
  std::vector<json> kept_;
};

} // namespace rt::tests
