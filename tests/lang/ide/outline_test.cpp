#include "lang/ide/outline.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace rt::lang;

namespace {

// "size table(top) table": the names, with those declared in them.
std::string names(const std::vector<OutlineEntry>& entries) {
  std::string text;
  for (const OutlineEntry& entry : entries) {
    text += (text.empty() ? "" : " ") + entry.name;
    if (!entry.children.empty()) text += "(" + names(entry.children) + ")";
  }
  return text;
}

std::vector<OutlineEntry> outline_of(const std::string& text) {
  AnalyseOptions options;
  options.keeps_references = true;
  return outline(analyse_text(text, "scene.rtl", ".", options), 0);
}

} // namespace

TEST_CASE("outline: what is declared and placed, in order, with what is declared in it") {
  CHECK(names(outline_of(
            "size: [8, 6]\nparam n = 3\nball = sphere {}\ndef table(width = 2) {\n  top = box {}\n  top\n}\n"
            "fn twice(x) = 2 * x\ntable {}\nball.move(x: n)\n")) == "size n ball table(top) twice table ball");
}

TEST_CASE("outline: an entry has its place, its first line and its kind") {
  const std::string text = "def table() {\n  box {}\n}\nplane {}\n";
  const auto entries = outline_of(text);
  REQUIRE(entries.size() == 2);
  CHECK(entries[0].what == OutlineEntry::What::noun);
  CHECK(entries[0].detail == "def table() {");
  CHECK(entries[0].whole == Span{0, 0, static_cast<std::uint32_t>(text.find("\nplane"))});
  CHECK(entries[0].name_span == Span{0, 4, 9});
  CHECK(entries[1].what == OutlineEntry::What::thing);
}

TEST_CASE("outline: a text with errors in it has what can be read of it") {
  CHECK(names(outline_of("ball = sphere { raduis: }\n= 3\nfn twice(x) = x +\nbox {}\n")) != "");
  CHECK(outline_of("").empty());
}
