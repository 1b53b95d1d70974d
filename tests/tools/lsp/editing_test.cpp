// What an editor shows and asks, through the program's pipes.

#include "tests/support/marked_text.hpp"
#include "tests/support/program.hpp"
#include "tests/tools/lsp/client.hpp"
#include "tools/lsp/text_positions.hpp"
#include "tools/lsp/uri.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;
using json = nlohmann::json;

namespace {

json position(int line, int character) {
  return {{"line", line}, {"character", character}};
}
json range(int line, int begin, int end) {
  return {{"start", position(line, begin)}, {"end", position(line, end)}};
}

/// A folder with scenes, and a client that has some of them open.
struct Editor {
  TestFolder folder;
  LspClient client;

  explicit Editor(const json& capabilities = json::object()) { client.initialize(capabilities); }

  std::string uri(const std::string& name) const { return tools::lsp::file_uri(folder.path() / name); }
  void save(const std::string& name, const std::string& text) { folder.write(name, text); }
  void open(const std::string& name, const std::string& text) { client.open(uri(name), text); }
  void change(const std::string& name, int version, const json& changes) {
    client.notify("textDocument/didChange",
                  {{"textDocument", {{"uri", uri(name)}, {"version", version}}}, {"contentChanges", changes}});
  }
  json at(const std::string& name, int line, int character) const {
    return {{"textDocument", {{"uri", uri(name)}}}, {"position", position(line, character)}};
  }
};

std::vector<std::string> labels(const json& completion) {
  std::vector<std::string> list;
  for (const json& item : completion.at("items")) list.push_back(item.at("label"));
  return list;
}

} // namespace

TEST_CASE("lsp: a mistake is shown where it is, in UTF-16 units, and is gone once it is mended") {
  Editor editor;
  editor.open("a.rtl", "/* 🙂● */ sphere { raduis: 1 }\n");
  json found = editor.client.diagnostics(editor.uri("a.rtl"));
  REQUIRE(found.size() == 1);
  CHECK(found[0]["range"] == range(0, 19, 25)); // the emoji counts two
  CHECK(found[0]["code"] == "E0204");
  CHECK(found[0]["severity"] == 1);
  CHECK(found[0]["source"] == "rtlang");
  CHECK_THAT(found[0]["message"].get<std::string>(), Catch::Contains("did you mean `radius`?"));
  editor.change("a.rtl", 2, {{{"range", range(0, 19, 25)}, {"text", "radius"}}});
  found = editor.client.diagnostics(editor.uri("a.rtl"), 2);
  for (const json& d : found) CHECK(d["severity"] == 4); // what was assumed: a camera, a light
  // Two changes in one message: each is about the text that the one before it left.
  editor.change("a.rtl", 3,
                {{{"range", range(0, 0, 10)}, {"text", ""}}, {{"range", range(0, 9, 15)}, {"text", "raduis"}}});
  found = editor.client.diagnostics(editor.uri("a.rtl"), 3);
  REQUIRE(found.size() == 1);
  CHECK(found[0]["range"] == range(0, 9, 15));
}

TEST_CASE("lsp: with a client that counts bytes it counts bytes") {
  Editor editor(json{{"general", {{"positionEncodings", {"utf-16", "utf-8"}}}}});
  editor.open("a.rtl", "/* 🙂● */ sphere { raduis: 1 }\n");
  CHECK(editor.client.diagnostics(editor.uri("a.rtl"))[0]["range"] == range(0, 23, 29));
}

TEST_CASE("lsp: mistakes of evaluation and the lint's remarks are shown, with the places that belong to them") {
  Editor editor;
  editor.open("a.rtl", "fn half(x) = x / 2\nball = sphere { radius: half(none) }\nball\nlost = box {}\n");
  const json found = editor.client.diagnostics(editor.uri("a.rtl"));
  const auto errors = std::count_if(found.begin(), found.end(), [](const json& d) { return d["severity"] == 1; });
  CHECK(errors == 1);
  for (const json& d : found) {
    if (d["severity"] != 1) continue;
    CHECK(d["range"]["start"]["line"] == 0);
    REQUIRE(d.contains("relatedInformation")); // who called
    CHECK(d["relatedInformation"][0]["location"]["range"]["start"]["line"] == 1);
  }
}

TEST_CASE("lsp: what another open text includes is read as it stands in the editor, and its mistakes are shown there") {
  Editor editor;
  editor.save("lib.rtl", "ball = sphere {}\n");
  editor.open("main.rtl", "include \"lib.rtl\"\nball { radius: 2 }\ncube\n");
  CHECK(editor.client.diagnostics(editor.uri("main.rtl"))[0]["range"] == range(2, 0, 4));
  editor.open("lib.rtl", "ball = sphere {}\ncube = box {}\n"); // not saved
  for (const json& d : editor.client.diagnostics(editor.uri("main.rtl"))) CHECK(d["severity"] != 1);
  editor.change("lib.rtl", 2, {{{"text", "ball = sphere {}\ncube = box { sise: 1 }\n"}}});
  const json found = editor.client.diagnostics(editor.uri("lib.rtl"), 2);
  REQUIRE(found.size() == 1);
  CHECK(found[0]["range"] == range(1, 13, 17));
  // Closed, the disk's text counts again, in which there is no cube.
  editor.client.notify("textDocument/didClose", {{"textDocument", {{"uri", editor.uri("lib.rtl")}}}});
  CHECK(editor.client
            .wait_for([&](const json& m) {
              return m.value("method", "") == "textDocument/publishDiagnostics" &&
                     m["params"]["uri"] == editor.uri("lib.rtl") && !m["params"].contains("version");
            })["params"]["diagnostics"]
            .empty());
  const json again = editor.client.wait_for([&](const json& m) {
    return m.value("method", "") == "textDocument/publishDiagnostics" && m["params"]["uri"] == editor.uri("main.rtl") &&
           m["params"]["diagnostics"].size() == 1;
  });
  CHECK(again["params"]["diagnostics"][0]["range"] == range(2, 0, 4));
}

TEST_CASE("lsp: mistakes of an included file that is not open are shown in that file, and follow the disk") {
  Editor editor;
  editor.save("lib.rtl", "ball = sphere { raduis: 2 }\n");
  editor.open("main.rtl", "include \"lib.rtl\"\nball\n");
  const auto next = [&] {
    return editor.client.wait_for([&](const json& m) {
      return m.value("method", "") == "textDocument/publishDiagnostics" && m["params"]["uri"] == editor.uri("lib.rtl");
    })["params"]["diagnostics"];
  };
  const json found = next();
  REQUIRE(found.size() == 1);
  CHECK(found[0]["range"] == range(0, 16, 22));
  editor.save("lib.rtl", "ball = sphere { radius: 2 }\n");
  editor.client.notify("workspace/didChangeWatchedFiles",
                       {{"changes", {{{"uri", editor.uri("lib.rtl")}, {"type", 2}}}}});
  CHECK(next().empty());
}

TEST_CASE("lsp: a client that can is asked to tell of files that change") {
  LspClient client;
  client.initialize({{"workspace", {{"didChangeWatchedFiles", {{"dynamicRegistration", true}}}}}});
  const json asked =
      client.wait_for([](const json& m) { return m.value("method", "") == "client/registerCapability"; });
  CHECK(asked["params"]["registrations"][0]["method"] == "workspace/didChangeWatchedFiles");
  client.send({{"jsonrpc", "2.0"}, {"id", asked["id"]}, {"result", nullptr}});
  CHECK(client.request("shutdown", nullptr).contains("result"));
}

TEST_CASE("lsp: hover, definition, references and highlights, across files and beside mistakes") {
  Editor editor;
  editor.save("lib.rtl", "// A round one.\nball = sphere {}\n");
  editor.open("main.rtl", "include \"lib.rtl\"\nraduis: = 3\nball { radius: 2 }\nball\n");
  const json hover = editor.client.result("textDocument/hover", editor.at("main.rtl", 2, 2));
  CHECK(hover["contents"]["value"] == "ball = sphere {}\n  A round one.");
  CHECK(hover["range"] == range(2, 0, 4));
  CHECK(editor.client.result("textDocument/hover", editor.at("main.rtl", 2, 6)) == nullptr);
  const json definition = editor.client.result("textDocument/definition", editor.at("main.rtl", 3, 4)); // behind it
  CHECK(definition == json{{"uri", editor.uri("lib.rtl")}, {"range", range(1, 0, 4)}});
  json question = editor.at("main.rtl", 3, 0);
  question["context"] = {{"includeDeclaration", true}};
  CHECK(editor.client.result("textDocument/references", question).size() == 3);
  question["context"]["includeDeclaration"] = false;
  CHECK(editor.client.result("textDocument/references", question).size() == 2);
  CHECK(editor.client.result("textDocument/documentHighlight", question).size() == 2);
}

TEST_CASE("lsp: completion offers what fits, says what it replaces, and describes it when asked") {
  Editor editor;
  editor.save("parts.rtl", "ball = sphere {}\n");
  editor.open("main.rtl", "include \"parts.rtl\"\nball { ra }\ninclude \"pa\n");
  const json offered = editor.client.result("textDocument/completion", editor.at("main.rtl", 1, 9));
  CHECK(labels(offered) == std::vector<std::string>{"radius"});
  CHECK(offered["items"][0]["textEdit"] == json{{"range", range(1, 7, 9)}, {"newText", "radius"}});
  const json path = editor.client.result("textDocument/completion", editor.at("main.rtl", 2, 11));
  REQUIRE(path.size() == 1);
  CHECK(path[0]["label"] == "parts.rtl");
  CHECK(path[0]["textEdit"]["range"] == range(2, 9, 11));
  const json whole = editor.client.result("completionItem/resolve", {{"label", "sphere"}});
  CHECK_THAT(whole["documentation"]["value"].get<std::string>(), Catch::Contains("radius"));
  CHECK(editor.client.result("completionItem/resolve", {{"label", "nobody"}}) == json{{"label", "nobody"}});
}

TEST_CASE("lsp: in an included file the names of all that is included are offered") {
  Editor editor;
  editor.save("main.rtl", "");
  editor.open("main.rtl", "base = box {}\ninclude \"lib.rtl\"\n");
  editor.open("lib.rtl", "ball = sphere {}\nba\n");
  const auto words = labels(editor.client.result("textDocument/completion", editor.at("lib.rtl", 1, 2)));
  CHECK(std::count(words.begin(), words.end(), "ball") == 1);
  CHECK(std::count(words.begin(), words.end(), "base") == 1);
}

TEST_CASE("lsp: formatting touches the lines that change, and no text with syntax errors") {
  Editor editor;
  editor.open("a.rtl", "sphere {}\nbox{ size:2 }\nplane {}\n");
  const json question{{"textDocument", {{"uri", editor.uri("a.rtl")}}},
                      {"options", {{"tabSize", 4}, {"insertSpaces", true}}}};
  const json edits = editor.client.result("textDocument/formatting", question);
  REQUIRE(edits.size() == 1);
  CHECK(edits[0]["range"] == json{{"start", position(1, 0)}, {"end", position(2, 0)}});
  CHECK(edits[0]["newText"] == "box { size: 2 }\n");
  editor.change("a.rtl", 2, {{{"text", "sphere {\n"}}});
  CHECK(editor.client.result("textDocument/formatting", question) == nullptr);
}

TEST_CASE("lsp: the outline lists what is declared and placed, in order") {
  Editor editor;
  editor.open("a.rtl",
              "size: [8, 6]\nparam n = 3\nfn twice(x) = 2 * x\ndef table(width = 2) {\n  top = box {}\n  top\n}\n"
              "table { width: twice(n) }\n");
  const json symbols =
      editor.client.result("textDocument/documentSymbol", {{"textDocument", {{"uri", editor.uri("a.rtl")}}}});
  std::vector<std::string> names;
  for (const json& symbol : symbols) names.push_back(symbol["name"]);
  CHECK(names == std::vector<std::string>{"size", "n", "twice", "table", "table"});
  CHECK(symbols[3]["children"][0]["name"] == "top");
  CHECK(symbols[3]["selectionRange"] == range(3, 4, 9));
  CHECK(symbols[3]["range"]["end"] == position(6, 1));
}

TEST_CASE("lsp: a name is renamed in all files, unless it would mean something else") {
  Editor editor;
  editor.save("lib.rtl", "ball = sphere {}\nfn grown(what, size) = what { radius: size }\n");
  const std::string main = "include \"lib.rtl\"\nround = ball\nround\ngrown(what: ball, size: 2)\n";
  editor.open("main.rtl", main);
  json question = editor.at("main.rtl", 1, 9);
  CHECK(editor.client.result("textDocument/prepareRename", question) ==
        json{{"range", range(1, 8, 12)}, {"placeholder", "ball"}});
  question["newName"] = "marble";
  const json changes = editor.client.result("textDocument/rename", question)["changes"];
  CHECK(changes[editor.uri("lib.rtl")] == json{{{"range", range(0, 0, 4)}, {"newText", "marble"}}});
  CHECK(changes[editor.uri("main.rtl")] == json{{{"range", range(1, 8, 12)}, {"newText", "marble"}},
                                                {{"range", range(3, 12, 16)}, {"newText", "marble"}}});
  // A parameter, by the name of an argument.
  question = editor.at("main.rtl", 3, 18);
  question["newName"] = "radius";
  CHECK(editor.client.result("textDocument/rename", question)["changes"][editor.uri("lib.rtl")].size() == 2);
  const auto error = [&](json asked, const std::string& name) {
    asked["newName"] = name;
    return editor.client.request("textDocument/rename", asked).at("error").at("code").get<int>();
  };
  CHECK(error(editor.at("main.rtl", 1, 9), "round") == -32803); // taken
  CHECK(error(editor.at("main.rtl", 1, 9), "two words") == -32602);
  CHECK(error(editor.at("main.rtl", 1, 9), "for") == -32602);
  CHECK(error(editor.at("main.rtl", 0, 2), "marble") == -32803); // no name
}

TEST_CASE("lsp: a text that is included twice is renamed as one") {
  Editor editor;
  editor.save("unit.rtl", "unit = 2\n");
  editor.save("a.rtl", "include \"unit.rtl\"\na = unit\n");
  editor.open("main.rtl", "use \"a.rtl\" as a\nuse \"unit.rtl\" as u\nsphere { radius: a.a + u.unit }\n");
  json question = editor.at("main.rtl", 2, 26);
  question["newName"] = "metre";
  const json changes = editor.client.result("textDocument/rename", question)["changes"];
  CHECK(changes[editor.uri("unit.rtl")].size() == 1);
  CHECK(changes[editor.uri("a.rtl")].size() == 1);
  CHECK(changes[editor.uri("main.rtl")].size() == 1);
}
