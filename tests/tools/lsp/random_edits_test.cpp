// Edits at random leave the server with the client's text, and with the answers of a server that was just started.

#include "renderer/math/random.hpp"
#include "tools/lsp/server.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <map>

using namespace rt;
using namespace rt::tools::lsp;
using json = nlohmann::json;

namespace {

const std::string uri = "untitled:scene";

/// A server in this process, and what it sent last.
struct Local {
  std::map<std::string, json> diagnostics; // by URI
  json response;
  std::atomic<bool> stop = false;
  Server server{{},
                [this](const json& message) {
                  if (message.contains("id"))
                    response = message;
                  else if (message["method"] == "textDocument/publishDiagnostics")
                    diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"];
                },
                [](const json&) { return false; }};

  Local() {
    ask("initialize", json::object());
    notify("initialized", json::object());
  }
  void notify(const std::string& method, const json& params) {
    server.handle({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
  }
  json ask(const std::string& method, const json& params) {
    server.handle({{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", params}});
    return response;
  }
  void open(const std::string& text) {
    notify("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", text}}}});
  }
  std::vector<json> answers(int line, int character) {
    const json at{{"textDocument", {{"uri", uri}}},
                  {"position", {{"line", line}, {"character", character}}},
                  {"context", {{"includeDeclaration", true}}}};
    std::vector<json> all;
    for (const char* method : {"textDocument/hover", "textDocument/definition", "textDocument/references",
                               "textDocument/completion", "textDocument/documentSymbol", "textDocument/formatting"})
      all.push_back(ask(method, at));
    server.publish(stop);
    all.push_back(diagnostics[uri]);
    return all;
  }
};

/// The client's text, as a list of UTF-16 units: what positions count.
class ClientText {
public:
  explicit ClientText(std::u16string text) : text_(std::move(text)) {}

  json position(std::size_t at) const {
    std::size_t line = 0, begin = 0;
    for (std::size_t i = 0; i < at; ++i)
      if (text_[i] == u'\n') ++line, begin = i + 1;
    return {{"line", line}, {"character", at - begin}};
  }
  /// Not between the halves of a character.
  std::size_t place(SplitMix64& random) const {
    std::size_t at = random.bits() % (text_.size() + 1);
    if (at < text_.size() && text_[at] >= 0xdc00 && text_[at] < 0xe000) --at;
    return at;
  }
  json replace(std::size_t begin, std::size_t end, const std::u16string& by) {
    json change{{"range", {{"start", position(begin)}, {"end", position(end)}}}, {"text", utf8(by)}};
    text_.replace(begin, end - begin, by);
    return change;
  }
  std::string utf8() const { return utf8(text_); }
  std::size_t size() const { return text_.size(); }

private:
  static std::string utf8(const std::u16string& text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
      char32_t c = text[i];
      if (c >= 0xd800 && c < 0xdc00) c = 0x10000 + ((c - 0xd800) << 10) + (text[++i] - 0xdc00);
      if (c < 0x80) {
        bytes += static_cast<char>(c);
      } else {
        const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
        constexpr std::array<unsigned, 4> heads{0, 0xc0, 0xe0, 0xf0};
        bytes += static_cast<char>(heads[static_cast<std::size_t>(more)] | (c >> (6 * more)));
        for (int k = more - 1; k >= 0; --k) bytes += static_cast<char>(0x80 | ((c >> (6 * k)) & 0x3f));
      }
    }
    return bytes;
  }

  std::u16string text_;
};

const std::u16string start = u"// 🙂 a table\n"
                             u"fn twice(x) = 2 * x\n"
                             u"def table(width = 2) { box { size: [width, 0.1, 1] } }\n"
                             u"ball = sphere { radius: twice(0.5), material: glass }\n"
                             u"ball\n"
                             u"for i in 0..3 { table { at: [i, 0, 0], width: 1 + i } }\n";
const std::array<std::u16string, 16> pieces{u"{",    u"}", u"(",  u")",  u"\n",         u" ", u"ball", u"= ",
                                            u"🙂", u"é", u"\"", u"//", u"sphere { }", u"7", u"[",    u"twice(ball"};

} // namespace

TEST_CASE("lsp: after edits at random the answers are those of a fresh start") {
  SplitMix64 random(1907);
  for (int round = 0; round < 6; ++round) {
    Local edited;
    ClientText text(start);
    edited.open(text.utf8());
    for (int i = 0; i < 60; ++i) {
      json changes = json::array();
      for (std::uint64_t k = random.bits() % 3; k < 3; ++k) {
        const std::size_t a = text.place(random), b = random.bits() % 3 == 0 ? text.place(random) : a;
        const bool is_small = std::max(a, b) - std::min(a, b) < 40 || text.size() > 600;
        changes.push_back(text.replace(std::min(a, b), is_small ? std::max(a, b) : std::min(a, b),
                                       pieces[random.bits() % pieces.size()]));
      }
      edited.notify("textDocument/didChange",
                    {{"textDocument", {{"uri", uri}, {"version", i + 2}}}, {"contentChanges", changes}});
      if (i % 4 != 0) continue;
      const json at = text.position(text.place(random));
      Local fresh;
      fresh.open(text.utf8());
      INFO(text.utf8());
      REQUIRE(edited.answers(at["line"], at["character"]) == fresh.answers(at["line"], at["character"]));
    }
  }
}

TEST_CASE("lsp: edits at random in an included text give its includer the answers of a fresh start") {
  SplitMix64 random(77);
  const std::string main_uri = "file:///nowhere/main.rtl", lib_uri = "file:///nowhere/lib.rtl";
  const std::string main = "include \"lib.rtl\"\nball\ntwice(2)\n";
  const auto open = [](Local& local, const std::string& which, const std::string& text) {
    local.notify("textDocument/didOpen", {{"textDocument", {{"uri", which}, {"version", 1}, {"text", text}}}});
  };
  Local edited;
  ClientText text(start);
  open(edited, lib_uri, text.utf8());
  open(edited, main_uri, main);
  for (int i = 0; i < 50; ++i) {
    const std::size_t at = text.place(random);
    const json changes = json::array({text.replace(at, at, pieces[random.bits() % pieces.size()])});
    edited.notify("textDocument/didChange",
                  {{"textDocument", {{"uri", lib_uri}, {"version", i + 2}}}, {"contentChanges", changes}});
    edited.server.publish(edited.stop);
    Local fresh;
    open(fresh, lib_uri, text.utf8());
    open(fresh, main_uri, main);
    fresh.server.publish(fresh.stop);
    INFO(text.utf8());
    REQUIRE(edited.diagnostics == fresh.diagnostics);
    const json question{{"textDocument", {{"uri", main_uri}}}, {"position", {{"line", 1}, {"character", 1}}}};
    REQUIRE(edited.ask("textDocument/definition", question) == fresh.ask("textDocument/definition", question));
  }
}
