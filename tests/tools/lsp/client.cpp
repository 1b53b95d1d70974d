#include "tests/tools/lsp/client.hpp"

#include "tests/paths.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>

namespace rt::tests {

LspClient::LspClient(const std::vector<std::string>& arguments) {
  std::array<int, 2> in{}, out{};
  if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe");
  std::vector<std::string> words{RTLANG_BINARY, "lsp"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("fork");
  if (process_ == 0) {
    ::dup2(in[0], STDIN_FILENO), ::dup2(out[1], STDOUT_FILENO);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  ::close(in[0]), ::close(out[1]);
  input_ = in[1], output_ = out[0];
  std::signal(SIGPIPE, SIG_IGN);
}

LspClient::~LspClient() {
  close_input();
  ::close(output_);
  if (process_ == 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void LspClient::send_raw(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::write(input_, bytes.data() + sent, bytes.size() - sent);
    if (count < 0) throw std::runtime_error("the server does not read");
    sent += static_cast<std::size_t>(count);
  }
}

void LspClient::send(const json& message) {
  const std::string text = message.dump();
  send_raw("Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text);
}

void LspClient::notify(const std::string& method, const json& params) {
  send({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
}

int LspClient::ask(const std::string& method, const json& params) {
  send({{"jsonrpc", "2.0"}, {"id", ++last_id_}, {"method", method}, {"params", params}});
  return last_id_;
}

LspClient::json LspClient::read() {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (true) {
    const std::size_t header_end = bytes_.find("\r\n\r\n");
    const std::string name = "Content-Length: ";
    if (header_end != std::string::npos) {
      if (!bytes_.starts_with(name)) throw std::runtime_error("no header: " + bytes_.substr(0, 80));
      const std::size_t length = std::stoul(bytes_.substr(name.size())), begin = header_end + 4;
      if (bytes_.size() >= begin + length) {
        json message = json::parse(bytes_.substr(begin, length));
        bytes_.erase(0, begin + length);
        return message;
      }
    }
    pollfd wanted{output_, POLLIN, 0};
    std::array<char, 65536> bytes;
    ssize_t count = 0;
    if (::poll(&wanted, 1, 1000) > 0) {
      count = ::read(output_, bytes.data(), bytes.size());
      if (count <= 0) throw std::runtime_error("the server is gone");
    } else if (std::chrono::steady_clock::now() > deadline) {
      throw std::runtime_error("the server says nothing");
    }
    bytes_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

LspClient::json LspClient::wait_for(const std::function<bool(const json&)>& is_it) {
  if (const auto found = std::find_if(kept_.begin(), kept_.end(), is_it); found != kept_.end()) {
    json message = std::move(*found);
    kept_.erase(found);
    return message;
  }
  while (true) {
    json message = read();
    if (is_it(message)) return message;
    kept_.push_back(std::move(message));
  }
}

LspClient::json LspClient::response(const json& id) {
  return wait_for([&](const json& m) {
    return m.contains("id") && m["id"] == id && (m.contains("result") || m.contains("error"));
  });
}

LspClient::json LspClient::initialize(const json& capabilities) {
  json result =
      this->result("initialize", {{"processId", nullptr}, {"rootUri", nullptr}, {"capabilities", capabilities}});
  notify("initialized", json::object());
  return result;
}

void LspClient::open(const std::string& uri, const std::string& text, int version) {
  notify("textDocument/didOpen",
         {{"textDocument", {{"uri", uri}, {"languageId", "rtl"}, {"version", version}, {"text", text}}}});
}

LspClient::json LspClient::diagnostics(const std::string& uri, int version) {
  const json message = wait_for([&](const json& m) {
    return m.value("method", "") == "textDocument/publishDiagnostics" && m["params"]["uri"] == uri &&
           m["params"].value("version", 0) >= version;
  });
  return message["params"]["diagnostics"];
}

void LspClient::close_input() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
}

int LspClient::exit_code() {
  int status = 0;
  for (int i = 0; i < 400; ++i) {
    if (::waitpid(process_, &status, WNOHANG) == process_) {
      process_ = 0;
      return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    ::usleep(50'000);
  }
  throw std::runtime_error("the server does not end");
}

} // namespace rt::tests
