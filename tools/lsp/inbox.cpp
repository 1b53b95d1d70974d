#include "tools/lsp/inbox.hpp"

#include "tools/lsp/messages.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>

namespace rt::tools::lsp {
namespace {

using nlohmann::json;

std::string method_of(const json& message) {
  const auto method = message.is_object() ? message.find("method") : message.end();
  return method != message.end() && method->is_string() ? method->get<std::string>() : "";
}

} // namespace

Inbox::Inbox(int file) : thread_([this, file] { read(file); }) {}

Inbox::~Inbox() {
  is_closing_ = true;
}

void Inbox::read(int file) {
  MessageReader reader(file, [this] { return is_over(); });
  while (const auto text = reader.next()) {
    json message = json::parse(*text, nullptr, false);
    const bool is_last = method_of(message) == "exit";
    put(std::move(message));
    if (is_last) break;
  }
  const std::lock_guard lock(mutex_);
  has_ended_ = has_news_ = true;
  wake_.notify_all();
}

void Inbox::put(json message) {
  const std::lock_guard lock(mutex_);
  if (method_of(message) == "$/cancelRequest") {
    const auto params = message.find("params");
    if (params == message.end() || !params->is_object() || !params->contains("id")) return;
    const json& id = params->at("id");
    const bool is_waiting = std::ranges::any_of(messages_, [&](const json& waiting) {
      return waiting.is_object() && waiting.contains("id") && waiting["id"] == id && waiting.contains("method");
    });
    if (is_waiting) cancelled_.insert(id.dump(-1, ' ', true, json::error_handler_t::replace));
    return;
  }
  messages_.push_back(std::move(message));
  has_news_ = true;
  wake_.notify_all();
}

std::optional<json> Inbox::next() {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [&] { return has_ended_ || !messages_.empty(); });
  if (messages_.empty()) return std::nullopt;
  json message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

bool Inbox::take_cancelled(const json& id) {
  const std::lock_guard lock(mutex_);
  return cancelled_.erase(id.dump(-1, ' ', true, json::error_handler_t::replace)) > 0;
}

bool Inbox::is_quiet() {
  const std::lock_guard lock(mutex_);
  if (!messages_.empty() || has_ended_) return false;
  has_news_ = false;
  return true;
}

bool Inbox::is_over() const {
  return is_closing_ || (process_ > 0 && ::kill(process_, 0) != 0 && errno == ESRCH);
}

} // namespace rt::tools::lsp
