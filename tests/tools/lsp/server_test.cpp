// The life of the server, and what becomes of messages that are none. The program itself is run.

#include "tests/support/program.hpp"
#include "tests/tools/lsp/client.hpp"
#include "tools/terminal/exit_code.hpp"

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

using namespace rt;
using namespace rt::tests;
using json = nlohmann::json;

namespace {

int error_code(const json& response) {
  return response.at("error").at("code").get<int>();
}

const std::string scene_uri = "untitled:Untitled-1";

} // namespace

TEST_CASE("lsp: it says what it can do, shuts down and ends with 0") {
  LspClient client;
  const json result = client.initialize();
  CHECK(result["serverInfo"]["name"] == "rtlang");
  CHECK(result["capabilities"]["positionEncoding"] == "utf-16");
  CHECK(result["capabilities"]["textDocumentSync"]["change"] == 2);
  CHECK(client.result("shutdown", nullptr) == nullptr);
  CHECK(error_code(client.request("textDocument/hover", json::object())) == -32600);
  client.notify("exit", nullptr);
  CHECK(client.exit_code() == 0);
}

TEST_CASE("lsp: without `shutdown` it ends with 1, be it by `exit` or where the input ends") {
  LspClient leaves;
  leaves.initialize();
  leaves.notify("exit", nullptr);
  CHECK(leaves.exit_code() == 1);
  LspClient vanishes;
  vanishes.initialize();
  vanishes.send_raw("Content-Length: 500\r\n\r\n{\"jsonrpc\"");
  vanishes.close_input();
  CHECK(vanishes.exit_code() == 1);
}

TEST_CASE("lsp: it ends with the process that started it, even where its input stays open") {
  const pid_t parent = ::fork();
  if (parent == 0) ::_exit(0);
  REQUIRE(::waitpid(parent, nullptr, 0) == parent); // no process has this id now
  LspClient client;
  client.result("initialize", {{"processId", parent}, {"rootUri", nullptr}, {"capabilities", json::object()}});
  CHECK(client.exit_code() == 1);
}

TEST_CASE("lsp: before `initialize` nothing is answered, and after it no second one") {
  LspClient client;
  client.open(scene_uri, "sphere { raduis: 1 }\n"); // not heard
  CHECK(error_code(client.request("textDocument/hover", json::object())) == -32002);
  client.initialize();
  CHECK(error_code(client.request("initialize", json::object())) == -32600);
  CHECK(error_code(client.request("textDocument/hover", {{"textDocument", {{"uri", scene_uri}}},
                                                         {"position", {{"line", 0}, {"character", 0}}}})) == -32602);
}

TEST_CASE("lsp: what is no JSON, no message, or no method is answered so, and the next message as if nothing was") {
  LspClient client;
  client.initialize();
  const auto frame = [](const std::string& text) {
    return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
  };
  client.send_raw(frame("{\"jsonrpc\": \"2.0\", \"id\": "));
  CHECK(error_code(client.response(nullptr)) == -32700);
  client.send_raw(frame("{\"jsonrpc\": \"2.0\", \"id\": 7, \"method\": \"\xff\"}")); // no UTF-8
  CHECK(error_code(client.response(nullptr)) == -32700);
  for (const char* text :
       {"[]", "7", "null", "{}", R"({"id": 3})", R"({"id": {}, "method": "shutdown"})", R"({"id": 3, "method": 7})"}) {
    INFO(text);
    client.send_raw(frame(text));
    CHECK(error_code(client.response(nullptr)) == -32600);
  }
  CHECK(error_code(client.request("textDocument/unheardOf", json::object())) == -32601);
  CHECK(error_code(client.request("textDocument/hover", {{"position", 3}})) == -32602);
  CHECK(error_code(client.request("textDocument/hover", nullptr)) == -32602);
  client.notify("$/unheardOf", nullptr);
  client.notify("textDocument/didChange", {{"textDocument", 5}});
  CHECK(client.wait_for([](const json& m) { return m.value("method", "") == "window/logMessage"; })["params"]["type"] ==
        1);
  client.send({{"jsonrpc", "2.0"}, {"id", "watch"}, {"result", nullptr}}); // an answer to nothing
  client.send({{"jsonrpc", "2.0"}, {"id", "words"}, {"method", "shutdown"}});
  CHECK(client.response("words").at("result") == nullptr);
}

TEST_CASE("lsp: after a header without a length, the next one that has it is found") {
  LspClient client;
  client.initialize();
  for (const std::string header : {"Content-Length: many\r\n\r\n", "Content-Length: -3\r\n\r\n", "Length: 3\r\n\r\n",
                                   "Content-Length: 99999999999999999999\r\n\r\n", "\r\n"}) {
    INFO(header);
    client.send_raw(header + R"({"jsonrpc": "2.0", "id": 1, "method": "shutdown"})");
    CHECK(error_code(client.response(nullptr)) == -32700);
    CHECK(error_code(client.request("textDocument/unheardOf", nullptr)) == -32601);
  }
  client.send_raw(std::string(300'000, 'x'));
  CHECK(error_code(client.request("textDocument/unheardOf", nullptr)) == -32601);
  // Further fields, and names in whatever case, are fine.
  const std::string text = R"({"jsonrpc": "2.0", "id": "other", "method": "shutdown"})";
  client.send_raw("Content-Type: application/vscode-jsonrpc; charset=utf-8\r\ncontent-length:" +
                  std::to_string(text.size()) + "\r\n\r\n" + text);
  CHECK(client.response("other").contains("result"));
}

TEST_CASE("lsp: a request that is cancelled while it waits is not worked on, and answered so") {
  LspClient client;
  client.initialize();
  // They come in one piece: the request waits behind the opening of a large text.
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "sphere { at: [" + std::to_string(i) + ", 0, 0], radius: 0.4 }\n";
  const auto frame = [](const json& message) {
    const std::string dumped = message.dump();
    return "Content-Length: " + std::to_string(dumped.size()) + "\r\n\r\n" + dumped;
  };
  const json at{{"textDocument", {{"uri", scene_uri}}}, {"position", {{"line", 0}, {"character", 1}}}};
  client.send_raw(
      frame({{"jsonrpc", "2.0"},
             {"method", "textDocument/didOpen"},
             {"params",
              {{"textDocument", {{"uri", scene_uri}, {"languageId", "rtl"}, {"version", 1}, {"text", text}}}}}}) +
      frame({{"jsonrpc", "2.0"}, {"id", "first"}, {"method", "textDocument/hover"}, {"params", at}}) +
      frame({{"jsonrpc", "2.0"}, {"id", "second"}, {"method", "textDocument/hover"}, {"params", at}}) +
      frame({{"jsonrpc", "2.0"}, {"method", "$/cancelRequest"}, {"params", {{"id", "second"}}}}) +
      frame({{"jsonrpc", "2.0"}, {"method", "$/cancelRequest"}, {"params", {{"id", "nobody"}}}}));
  CHECK(client.response("first").contains("result"));
  CHECK(error_code(client.response("second")) == -32800);
}

TEST_CASE("lsp: a change is heard while the scene before it is still being computed") {
  LspClient client;
  client.initialize();
  client.open(scene_uri, "for i in 0..30000 { for j in 0..30000 { x = i * j } }\nsphere {}\n");
  client.notify("textDocument/didChange", {{"textDocument", {{"uri", scene_uri}, {"version", 2}}},
                                           {"contentChanges", {{{"text", "sphere { raduis: 1 }\n"}}}}});
  // What is said first is about the second text: the first one's computation, of minutes, was given up.
  const json said = client.wait_for(
      [](const json& m) { return m.value("method", "") == "textDocument/publishDiagnostics"; })["params"];
  CHECK(said["version"] == 2);
  REQUIRE(said["diagnostics"].size() == 1);
  CHECK(said["diagnostics"][0]["code"] == "E0204");
}

TEST_CASE("lsp: a signal ends it") {
  LspClient client;
  client.initialize();
  client.signal(SIGTERM);
  CHECK(client.exit_code() == 128 + SIGTERM);
}

TEST_CASE("lsp: an option that it has not is a mistake") {
  CHECK(rtlang({"lsp", "--stdout"}).exit_code == tools::exit_usage);
  CHECK(rtlang({"lsp", "scene.rtl"}).exit_code == tools::exit_usage);
}
