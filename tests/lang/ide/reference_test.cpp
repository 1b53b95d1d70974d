#include "lang/ide/reference.hpp"
#include "lang/load.hpp"
#include "tests/paths.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::vector<std::string> page() {
  std::ifstream file(RTLANG_SOURCE_DIR "/lang/README.md");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

struct Snippet {
  std::string code; ///< the diagnostic it must raise; empty: none
  std::string text;
  std::size_t line;
};

std::vector<Snippet> snippets() {
  std::vector<Snippet> found;
  const std::vector<std::string> lines = page();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].starts_with("```rtl")) continue;
    Snippet s{lines[i].size() > 7 ? lines[i].substr(7) : "", "", i + 1};
    for (++i; i < lines.size() && lines[i] != "```"; ++i) s.text += lines[i] + "\n";
    found.push_back(s);
  }
  return found;
}

} // namespace

TEST_CASE("reference: every snippet of the language page does what the page says") {
  const auto all = snippets();
  REQUIRE(all.size() > 10);
  for (const Snippet& s : all) {
    INFO("lang/README.md:" << s.line << "\n" << s.text);
    const auto loaded = rt::lang::load_text(s.text, "snippet", RTLANG_SOURCE_DIR "/examples", {});
    std::vector<std::string> codes;
    for (const auto& d : loaded.diagnostics)
      if (d.severity == rt::lang::Severity::error) codes.push_back(d.code);
    if (s.code.empty())
      CHECK(codes == std::vector<std::string>{});
    else
      CHECK(codes == std::vector<std::string>{s.code});
  }
}

TEST_CASE("reference: the tables of the language page are what the program prints") {
  const std::vector<std::string> lines = page();
  std::size_t sections = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string begin = "<!-- generated: ";
    if (!lines[i].starts_with(begin)) continue;
    const std::string section = lines[i].substr(begin.size(), lines[i].find(" -->") - begin.size());
    std::string text;
    for (++i; i < lines.size() && lines[i] != "<!-- end -->"; ++i) text += lines[i] + "\n";
    INFO("section " << section << ": run tools/update_reference");
    CHECK(text == rt::lang::markdown(section));
    ++sections;
  }
  CHECK(sections == rt::lang::reference_sections().size());
}

TEST_CASE("reference: a noun is described with its own and the common properties") {
  const auto sphere = rt::lang::find_entry("sphere");
  REQUIRE(sphere);
  const std::string text = rt::lang::describe(*sphere);
  CHECK(text.find("radius") != std::string::npos);
  CHECK(text.find("casts_shadow") != std::string::npos);
  CHECK(rt::lang::find_entry("no such thing") == std::nullopt);
}

TEST_CASE("reference: a property is described with the things that have it") {
  const std::string text = rt::lang::describe_properties("min_weight");
  CHECK(text.find("scene.min_weight: number (0.001953125)  in whitted mode: ") == 0);
  CHECK(rt::lang::describe_properties("radius").find("\ncylinder.radius: number") != std::string::npos);
  CHECK(rt::lang::describe_properties("no such property").empty());
}

TEST_CASE("reference: a name that is several things is described as all of them") {
  // A step of a chain and a material; a function and properties of a material.
  const std::string mirror = rt::lang::describe_name("mirror");
  CHECK(mirror.find("thing.mirror(") != std::string::npos);
  CHECK(mirror.find("material { color: #f7f9f8") != std::string::npos);
  const std::string reflect = rt::lang::describe_name("reflect");
  CHECK(reflect.find("reflect(v: point, normal: point)") != std::string::npos);
  CHECK(reflect.find("\nmaterial.reflect: ") != std::string::npos);
  CHECK(rt::lang::describe_name("sphere.radius").starts_with("sphere.radius: number (1)  distance"));
  CHECK(rt::lang::describe_name("plane.radius").empty());
  CHECK(rt::lang::describe_name("include").starts_with("include \"shapes.rtl\""));
}

TEST_CASE("reference: whatever is among the names is described") {
  const std::vector<std::string> names = rt::lang::reference_names();
  CHECK(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"sphere", "radius", "min_weight", "gold", "mirror", "clamp", "pi", "param", "expect"}) {
    INFO(name);
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
  for (const std::string& name : names) {
    INFO(name);
    CHECK_FALSE(rt::lang::describe_name(name).empty());
  }
}
