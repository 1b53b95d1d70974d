#include "tools/lsp/server.hpp"

#include "tools/lsp/inbox.hpp"
#include "tools/lsp/messages.hpp"
#include "tools/lsp/request_error.hpp"
#include "tools/lsp/uri.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/interrupt.hpp"
#include "tools/terminal/version.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace rt::tools::lsp {
namespace {

using nlohmann::json;

// A member of nested objects; null if one of them is missing.
json member(const json& object, std::initializer_list<const char*> path) {
  const json* at = &object;
  for (const char* name : path) {
    if (!at->is_object() || !at->contains(name)) return nullptr;
    at = &(*at)[name];
  }
  return *at;
}

PositionEncoding chosen_encoding(const json& params) {
  const json offered = member(params, {"capabilities", "general", "positionEncodings"});
  const bool takes_utf8 = offered.is_array() && std::ranges::find(offered, json("utf-8")) != offered.end();
  return takes_utf8 ? PositionEncoding::utf8 : PositionEncoding::utf16;
}

json capabilities(PositionEncoding encoding) {
  return {{"positionEncoding", encoding == PositionEncoding::utf8 ? "utf-8" : "utf-16"},
          {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}}}, // 2: parts
          {"hoverProvider", true},
          {"definitionProvider", true},
          {"referencesProvider", true},
          {"documentHighlightProvider", true},
          {"documentFormattingProvider", true},
          {"documentSymbolProvider", true},
          {"renameProvider", {{"prepareProvider", true}}},
          {"completionProvider", {{"resolveProvider", true}, {"triggerCharacters", {".", "/", "\""}}}}};
}

} // namespace

Server::Server(std::vector<std::string> include_roots, Send send, std::function<bool(const json& id)> is_cancelled)
    : workspace_(std::move(include_roots)), answers_(workspace_), send_(std::move(send)),
      is_cancelled_(std::move(is_cancelled)) {}

void Server::respond(const json& id, json result) {
  send_({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void Server::fail(const json& id, ErrorCode code, std::string_view message) {
  send_({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", message}}}});
}

void Server::handle(const json& message) {
  if (message.is_discarded()) return fail(nullptr, ErrorCode::parse_error, "this is no JSON, or has no length");
  const json id = member(message, {"id"}), method = member(message, {"method"}), params = member(message, {"params"});
  const bool is_response = message.is_object() && (message.contains("result") || message.contains("error"));
  if (!method.is_string() || !(id.is_null() || id.is_number_integer() || id.is_string())) {
    if (!is_response) fail(nullptr, ErrorCode::invalid_request, "this is no message of JSON-RPC 2.0");
    return;
  }
  if (id.is_null()) return notify(method.get_ref<const std::string&>(), params);
  if (is_cancelled_(id)) return fail(id, ErrorCode::request_cancelled, "cancelled");
  try {
    respond(id, answer(method.get_ref<const std::string&>(), params));
  } catch (const RequestError& error) {
    fail(id, error.code, error.what());
  } catch (const json::exception& error) {
    fail(id, ErrorCode::invalid_params, error.what());
  } catch (const std::exception& error) {
    fail(id, ErrorCode::internal_error, error.what());
  }
}

json Server::answer(std::string_view method, const json& params) {
  if (method == "initialize") return initialize(params);
  if (state_ == State::uninitialized)
    throw RequestError(ErrorCode::server_not_initialized, "the first request is `initialize`");
  if (state_ == State::shut_down) throw RequestError(ErrorCode::invalid_request, "the server is shut down");
  if (method == "shutdown") return shut_down(params);

  static constexpr std::pair<std::string_view, json (Answers::*)(const json&)> table[] = {
      {"textDocument/hover", &Answers::hover},
      {"textDocument/definition", &Answers::definition},
      {"textDocument/references", &Answers::references},
      {"textDocument/documentHighlight", &Answers::highlight},
      {"textDocument/completion", &Answers::completion},
      {"completionItem/resolve", &Answers::resolve_completion},
      {"textDocument/formatting", &Answers::formatting},
      {"textDocument/documentSymbol", &Answers::symbols},
      {"textDocument/prepareRename", &Answers::prepare_rename},
      {"textDocument/rename", &Answers::rename},
  };
  for (const auto& [name, function] : table)
    if (name == method) return (answers_.*function)(params);
  throw RequestError(ErrorCode::method_not_found, fmt::format("there is no method `{}`", method));
}

json Server::initialize(const json& params) {
  if (state_ != State::uninitialized) throw RequestError(ErrorCode::invalid_request, "it is initialized already");
  answers_.set_encoding(chosen_encoding(params));
  if (const json process = member(params, {"processId"}); process.is_number_integer()) client_process_ = process;
  if (const json root = member(params, {"rootUri"}); root.is_string())
    if (const auto folder = file_path(root.get_ref<const std::string&>())) workspace_.set_folder(folder->string());
  watches_files_ =
      member(params, {"capabilities", "workspace", "didChangeWatchedFiles", "dynamicRegistration"}) == json(true);
  state_ = State::running;
  return {{"capabilities", capabilities(answers_.encoding())},
          {"serverInfo", {{"name", "rtlang"}, {"version", version_number()}}}};
}

json Server::shut_down(const json&) {
  state_ = State::shut_down;
  return nullptr;
}

void Server::notify(std::string_view method, const json& params) {
  if (method == "exit") {
    exit_code_ = exit_code_at_end();
    return;
  }
  if (state_ != State::running) return;
  try {
    if (method == "initialized") return initialized();
    if (method == "textDocument/didOpen") return did_open(params);
    if (method == "textDocument/didChange") return did_change(params);
    if (method == "textDocument/didClose") return did_close(params);
    if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") {
      workspace_.forget();
      is_outdated_ = true;
    }
  } catch (const std::exception& error) { // there is no response in which to report it
    log(fmt::format("{}: {}", method, error.what()));
  }
}

// LSP 3.17, "MessageType": 1 is an error.
void Server::log(std::string_view text) {
  send_({{"jsonrpc", "2.0"},
         {"method", "window/logMessage"},
         {"params", {{"type", 1}, {"message", fmt::format("rtlang: {}", text)}}}});
}

// Included files may change on disk, too.
void Server::initialized() {
  if (!watches_files_) return;
  send_({{"jsonrpc", "2.0"},
         {"id", "watch"},
         {"method", "client/registerCapability"},
         {"params",
          {{"registrations",
            {{{"id", "watch"},
              {"method", "workspace/didChangeWatchedFiles"},
              {"registerOptions", {{"watchers", {{{"globPattern", "**/*.rtl"}}}}}}}}}}}});
}

void Server::did_open(const json& params) {
  const json& text = params.at("textDocument");
  workspace_.open(text.at("uri").get<std::string>(), text.at("version").get<std::int64_t>(),
                  text.at("text").get<std::string>());
  is_outdated_ = true;
}

void Server::did_change(const json& params) {
  const json& text = params.at("textDocument");
  Document* document = workspace_.find(text.at("uri").get_ref<const std::string&>());
  if (!document) return;
  const auto version = text.at("version").get<std::int64_t>();
  for (const json& change : params.at("contentChanges"))
    workspace_.change(*document, version, change, answers_.encoding());
  is_outdated_ = true;
}

void Server::did_close(const json& params) {
  workspace_.close(params.at("textDocument").at("uri").get_ref<const std::string&>());
  is_outdated_ = true;
}

void Server::publish(const std::atomic<bool>& stop) {
  std::optional<std::map<std::string, json>> found;
  try {
    found = all_diagnostics(workspace_, answers_.encoding(), stop);
  } catch (const std::exception& error) { // memory, or the disk: the editor's texts are still served
    is_outdated_ = false;
    return log(error.what());
  }
  if (!found) return;
  is_outdated_ = false;
  for (const auto& [uri, list] : published_) found->try_emplace(uri, json::array());
  for (const auto& [uri, list] : *found) {
    const Document* document = workspace_.find(uri);
    json params{{"uri", uri}, {"diagnostics", list}};
    if (document) params["version"] = document->version;
    const auto known = published_.find(uri);
    if (known != published_.end() && known->second == params) continue;
    send_({{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", params}});
    if (document || !list.empty())
      published_[uri] = std::move(params);
    else
      published_.erase(uri);
  }
}

int run_server(const ServerOptions& options) {
  const EndsAtOnce ends_at_once;
  Inbox inbox(STDIN_FILENO);
  Server server(
      options.include_roots, [](const json& message) { print(framed(message)); },
      [&](const json& id) { return inbox.take_cancelled(id); });
  while (true) {
    if (server.has_work() && inbox.is_quiet()) server.publish(inbox.has_news());
    const auto message = inbox.next();
    if (!message) return server.exit_code_at_end();
    server.handle(*message);
    inbox.end_with(server.client_process());
    if (const auto code = server.exit_code()) return *code;
  }
}

} // namespace rt::tools::lsp
