#include "lang/diagnostics/diagnostic.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <set>

using namespace rt::lang;

namespace {

const std::string lamp = "// a lamp\n\nsphere {\n  at: [0, 1, 0]\n\n\n  raduis: 2\n}\n";

Diagnostic unknown_property(Span span) {
  return {Severity::error,
          "E0204",
          "`sphere` has no property `raduis`",
          span,
          "did you mean `radius`?",
          {{std::nullopt, "a sphere takes radius, at, rotate, scale, material, name"}},
          {}};
}

Diagnostic at(Span span, std::string label = "here") {
  return {Severity::error, "E0101", "wrong", span, std::move(label), {}, {}};
}

} // namespace

TEST_CASE("diagnostic: is shown with its place, its line and its notes") {
  SourceMap sources;
  const FileId file = sources.add("lamp.rtl", "", lamp);
  const auto begin = static_cast<std::uint32_t>(lamp.find("raduis"));
  CHECK(render(unknown_property({file, begin, begin + 6}), sources, false) ==
        "error[E0204]: `sphere` has no property `raduis`\n"
        "  --> lamp.rtl:7:3\n"
        "  |\n"
        "7 |   raduis: 2\n"
        "  |   ^^^^^^ did you mean `radius`?\n"
        "  = note: a sphere takes radius, at, rotate, scale, material, name\n");
}

TEST_CASE("diagnostic: colours change nothing but colours") {
  SourceMap sources;
  const FileId file = sources.add("lamp.rtl", "", lamp);
  const Diagnostic diagnostic = unknown_property({file, 40, 46});
  std::string colored = render(diagnostic, sources, true);
  CHECK(colored.find("\x1b[1;31merror[E0204]\x1b[0m") == 0);
  for (std::size_t begin = 0; (begin = colored.find('\x1b')) != std::string::npos;) {
    colored.erase(begin, colored.find('m', begin) - begin + 1);
  }
  CHECK(colored == render(diagnostic, sources, false));
}

TEST_CASE("diagnostic: carets count what a terminal shows") {
  SourceMap sources;
  const FileId tabs = sources.add("t", "", "\tab\tc");
  CHECK(render(at({tabs, 4, 5}), sources, false) ==
        "error[E0101]: wrong\n  --> t:1:5\n  |\n1 |     ab  c\n  |         ^ here\n");
  const FileId wide = sources.add("w", "", "日本x");
  CHECK(render(at({wide, 6, 7}), sources, false).find("1 | 日本x\n  |     ^ here\n") != std::string::npos);
  CHECK(render(at({wide, 3, 6}), sources, false).find("  |   ^^ here\n") != std::string::npos);
  const FileId combining = sources.add("c", "", "e\xcc\x81x");
  CHECK(render(at({combining, 3, 4}), sources, false).find("  |  ^ here\n") != std::string::npos);
}

TEST_CASE("diagnostic: what would steer the terminal is shown as a replacement character") {
  SourceMap sources;
  const FileId file = sources.add("a\x1b[2Jb", "", "x = \"\x1b[2J\" \xff");
  const std::string text =
      render({Severity::error, "E0101", "not \x1b[2J", {file, 0, 1}, "\r", {}, {}}, sources, false);
  CHECK(text.find('\x1b') == std::string::npos);
  CHECK(text.find('\r') == std::string::npos);
  CHECK(text.find("x = \"\xef\xbf\xbd[2J\" \xef\xbf\xbd\n") != std::string::npos);
}

TEST_CASE("diagnostic: a long line is clipped around its place") {
  SourceMap sources;
  const std::string line = std::string(300, 'a') + "HERE" + std::string(300, 'b');
  const FileId file = sources.add("long.rtl", "", line);
  const std::string text = render(at({file, 300, 304}), sources, false);
  std::istringstream lines(text);
  std::string each;
  std::vector<std::string> all;
  while (std::getline(lines, each)) all.push_back(each);
  REQUIRE(all.size() == 5);
  CHECK(all[3].size() < 120);
  CHECK(all[3].find("…a") != std::string::npos);
  CHECK(all[3].find("b…") != std::string::npos);
  CHECK(all[3].find("HERE") - std::string("…").size() + 1 == all[4].find("^^^^"));
  const std::string start = render(at({file, 0, 1}), sources, false);
  CHECK(start.find("1 | aaaa") != std::string::npos);
}

TEST_CASE("diagnostic: a span of several lines is marked on its first") {
  SourceMap sources;
  const FileId file = sources.add("a.rtl", "", "group {\n  box {}\n}\n");
  CHECK(render(at({file, 0, 18}), sources, false).find("1 | group {\n  | ^^^^^^^ here\n") != std::string::npos);
}

TEST_CASE("diagnostic: a place without extent gets one caret, also at the end of a line") {
  SourceMap sources;
  const FileId file = sources.add("a.rtl", "", "x =\n");
  CHECK(render(at({file, 3, 3}), sources, false).find("1 | x =\n  |    ^ here\n") != std::string::npos);
}

TEST_CASE("diagnostic: includes and calls show the chain that led there") {
  SourceMap sources;
  const FileId scene = sources.add("scene.rtl", "", "x = 1\ninclude \"parts.rtl\"\n");
  const FileId parts = sources.add("parts.rtl", "", "include \"lamp.rtl\"\n", {scene, 6, 25});
  const FileId file = sources.add("lamp.rtl", "", lamp, {parts, 0, 18});
  Diagnostic diagnostic = at({file, 40, 46});
  diagnostic.call_stack = {{Span{parts, 0, 7}, "in `shade`"}, {Span{scene, 0, 1}, "in `lamp`"}};
  const std::string text = render(diagnostic, sources, false);
  CHECK(text.find("lamp.rtl:7:3\n      included from parts.rtl:1:1\n      included from scene.rtl:2:1\n") !=
        std::string::npos);
  CHECK(text.find("  = in `shade` at parts.rtl:1:1\n  = in `lamp` at scene.rtl:1:1\n") != std::string::npos);
}

TEST_CASE("diagnostic: a deep call stack is shortened in the middle") {
  SourceMap sources;
  const FileId file = sources.add("a.rtl", "", "x");
  Diagnostic diagnostic = at({file, 0, 1});
  for (int i = 0; i < 1000; ++i) diagnostic.call_stack.push_back({Span{file, 0, 1}, "call " + std::to_string(i)});
  const std::string text = render(diagnostic, sources, false);
  CHECK(text.find("= call 4 at") != std::string::npos);
  CHECK(text.find("= call 5 at") == std::string::npos);
  CHECK(text.find("= ... 993 more calls\n") != std::string::npos);
  CHECK(text.find("= call 998 at") != std::string::npos);
  CHECK(text.find("= call 999 at") != std::string::npos);
}

TEST_CASE("diagnostic: as JSON with lines, columns and bytes") {
  SourceMap sources;
  const FileId file = sources.add("é.rtl", "", "é = 1\nx = 2cm\n");
  Diagnostic diagnostic{Severity::warning, "W0001", "odd", {file, 12, 14}, "label", {{Span{file, 0, 2}, "note"}}, {}};
  const auto json = nlohmann::json::parse(render_json({diagnostic}, sources));
  REQUIRE(json.size() == 1);
  CHECK(json[0]["severity"] == "warning");
  CHECK(json[0]["code"] == "W0001");
  CHECK(json[0]["message"] == "odd");
  CHECK(json[0]["label"] == "label");
  CHECK(json[0]["file"] == "é.rtl");
  CHECK(json[0]["line"] == 2);
  CHECK(json[0]["column"] == 6);
  CHECK(json[0]["end_column"] == 8);
  CHECK(json[0]["begin"] == 12);
  CHECK(json[0]["end"] == 14);
  CHECK(json[0]["notes"][0]["line"] == 1);
  CHECK(json[0]["notes"][0]["end_column"] == 2);
  CHECK(nlohmann::json::parse(render_json({}, sources)).empty());
  const FileId broken = sources.add("\xff", "", "\xff");
  CHECK_NOTHROW(render_json({at({broken, 0, 1})}, sources));
}

TEST_CASE("codes: every code is unique, well formed, and explains itself") {
  std::set<std::string_view> seen;
  for (const Code& code : all_codes()) {
    INFO(code.code);
    CHECK(seen.insert(code.code).second);
    CHECK(code.code.size() == 5);
    CHECK_FALSE(code.title.empty());
    CHECK_FALSE(code.title.ends_with('.'));
    CHECK_FALSE(code.meaning.empty());
    CHECK(code.example.empty() == code.mended.empty());
  }
  CHECK(find_code("E0103"));
  CHECK_FALSE(find_code("E9999"));
  const std::string text = explain(*find_code("E0102"));
  CHECK(text.find("E0102: A separator is missing\n\n") == 0);
  CHECK(text.find("\n    sphere { radius 2 }\n") != std::string::npos);
  CHECK(text.find("\n    sphere { radius: 2 }\n") != std::string::npos);
}
