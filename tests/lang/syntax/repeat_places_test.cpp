#include "lang/diagnostics/report.hpp"
#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <functional>
#include <ostream>

using namespace rt::lang;
using namespace rt::tests;

namespace {

struct Told {
  std::string code;
  std::uint32_t line;
  std::string text;
  friend bool operator==(const Told&, const Told&) = default;
};

std::ostream& operator<<(std::ostream& out, const Told& told) {
  return out << told.code << " in line " << told.line << " at " << told.text;
}

std::vector<Told> told(const std::string& scene) {
  const Loaded loaded = load(scene);
  std::vector<Told> all;
  for (const Diagnostic& d : loaded.diagnostics) {
    if (d.severity != Severity::error) continue;
    all.push_back(
        {d.code, loaded.sources.position(d.span.file, d.span.begin).line, std::string(loaded.sources.text(d.span))});
  }
  return all;
}

// Long enough that lines of one wording become repeats of the first.
std::string lines(int count, const std::function<std::string(int)>& line) {
  std::string scene;
  for (int i = 1; i <= count; ++i) scene += line(i) + '\n';
  return scene;
}

} // namespace

TEST_CASE("repeats: a wrong value in the midst of a long list is reported in its own line") {
  const auto sphere = [](int i) {
    return "sphere { at: [" + std::to_string(i) +
           ", -1, 0], radius: " + (i == 40 || i == 45 || i == 60 ? "-2.5" : "1") + " }";
  };
  CHECK(told(lines(60, sphere)) ==
        std::vector<Told>{{"E0302", 40, "-2.5"}, {"E0302", 45, "-2.5"}, {"E0302", 60, "-2.5"}});
}

TEST_CASE("repeats: a mistake in the wording is reported for every line") {
  const std::vector<Told> all = told(lines(50, [](int i) { return "sphere { raduis: " + std::to_string(i) + " }"; }));
  REQUIRE(all.size() == 50);
  for (std::uint32_t i = 0; i < 50; ++i) CHECK(all[i] == Told{"E0204", i + 1, "raduis"});
}

TEST_CASE("repeats: the same words in another layout have their own places too") {
  const auto scene = lines(40, [](int i) -> std::string {
    if (i == 30) return "box { // a comment\n  at: [1, 2, 3]\n  material: rgb(0.5, -1, 0.25)\n}";
    return "box { at: [1, -2, 3], material: rgb(0.5, 1, 0.25) }";
  });
  CHECK(told(scene) == std::vector<Told>{{"E0310", 32, "-1"}});
}

TEST_CASE("repeats: what calls itself without end is reported where it was called") {
  const Loaded loaded =
      load("fn f(x) = f(x)\n" + lines(40, [](int i) { return "sphere { radius: f(" + std::to_string(i) + ") }"; }));
  const Diagnostic* d = find(loaded, "E0502");
  REQUIRE(d);
  CHECK(loaded.sources.position(0, d->call_stack.back().span->begin).line == 2);
}

TEST_CASE("repeats: where there is no end of mistakes, the last that is reported says so") {
  const Loaded loaded = load(lines(2'000, [](int i) { return "sphere { raduis: " + std::to_string(i) + " }"; }));
  CHECK(loaded.diagnostics.size() == Report::most);
  REQUIRE_FALSE(loaded.diagnostics.back().notes.empty());
  CHECK(loaded.diagnostics.back().notes.back().message ==
        "there are more mistakes: only 1000 mistakes are reported at once");
}

TEST_CASE("diagnostics: of a line that is a file long, what is about the carets is shown") {
  const Loaded loaded = load("x = [" + std::string(3'000'000, ' ') + "1]; sphere { raduis: 2 }; y = [" +
                             std::string(3'000'000, ' ') + "2]");
  REQUIRE(loaded.diagnostics.size() == 1);
  const std::string shown = render(loaded.diagnostics[0], loaded.sources, false);
  CHECK(shown.size() < 1'000);
  CHECK(shown.find("1]; sphere { raduis: 2 }; y = [  ") != std::string::npos);
  CHECK(shown.find("\n  | " + std::string(34, ' ') + "^^^^^^ did you mean") != std::string::npos);
}
