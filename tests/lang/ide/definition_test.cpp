#include "lang/ide/definition.hpp"
#include "lang/ide/hover.hpp"
#include "tests/support/marked_text.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace rt::lang;
using rt::tests::MarkedText;

namespace {

/// A scene in memory with files beside it, and the places that are marked in it.
class Scene {
public:
  explicit Scene(std::string_view marked, const std::vector<std::pair<std::string, std::string>>& others = {})
      : main_(marked) {
    for (const auto& [name, text] : others) files_.write("/scene/" + name, text);
    files_.write("/scene/main.rtl", main_.text);
    AnalyseOptions options;
    options.files = &files_;
    options.keeps_references = true;
    analysis_ = analyse_file("/scene/main.rtl", options);
  }

  /// "main.rtl 2:3 `ball`", of the name at the first mark.
  std::string definition() const {
    const auto span = find_definition(analysis_, 0, main_.places.at(0));
    return span ? describe(*span) : "none";
  }
  std::string references() const {
    std::string text;
    for (const Span span : find_references(analysis_, 0, main_.places.at(0)))
      text += (text.empty() ? "" : ", ") + describe(span);
    return text;
  }
  std::string hover() const {
    const auto found = rt::lang::hover(analysis_, 0, main_.places.at(0));
    return found ? found->text : "none";
  }
  const Analysis& analysis() const { return analysis_; }

private:
  std::string describe(Span span) const {
    const SourceMap& sources = analysis_.program->sources;
    const Position at = sources.position(span.file, span.begin);
    return fmt::format("{} {}:{} `{}`", sources.file(span.file).name, at.line, at.column, sources.text(span));
  }

  MemoryFiles files_;
  MarkedText main_;
  Analysis analysis_;
};

std::string definition(std::string_view marked) {
  return Scene(marked).definition();
}

std::string hover_of(std::string_view marked) {
  return Scene(marked).hover();
}

} // namespace

TEST_CASE("definition: names lead to where they are declared") {
  CHECK(definition("ball = sphere {}\nb‸all") == "/scene/main.rtl 1:1 `ball`");
  CHECK(definition("fn twice(x) = 2 * x\nr = ‸twice(2)") == "/scene/main.rtl 1:4 `twice`");
  CHECK(definition("r = twice‸(2)\nfn twice(x) = 2 * x") == "/scene/main.rtl 2:4 `twice`");
  CHECK(definition("fn twice(x) = 2 * ‸x") == "/scene/main.rtl 1:10 `x`");
  CHECK(definition("fn twice(x) = 2 * x\nr = twice(‸x: 2)") == "/scene/main.rtl 1:10 `x`");
  CHECK(definition("def post(h = 1) { box { size: h } }\n‸post { h: 2 }") == "/scene/main.rtl 1:5 `post`");
  CHECK(definition("def post(h = 1) { box { size: h } }\npost { ‸h: 2 }") == "/scene/main.rtl 1:10 `h`");
  CHECK(definition("for i, x in [1, 2] { sphere { at: [‸i, x, 0] } }") == "/scene/main.rtl 1:5 `i`");
  CHECK(definition("list = [x * x for x in 0..3]\nxs = [‸x for x in list]") == "/scene/main.rtl 2:13 `x`");
  CHECK(definition("f = fn (x) => ‸x + 1") == "/scene/main.rtl 1:9 `x`");
  CHECK(definition("param n = 3\nfor i in 0..<‸n { sphere { at: i } }") == "/scene/main.rtl 1:7 `n`");
  CHECK(definition("b‸all = sphere {}") == "/scene/main.rtl 1:1 `ball`");
}

TEST_CASE("definition: the innermost name of that spelling counts") {
  CHECK(definition("r = 1\ngroup { r = 2\n sphere { radius: ‸r } }") == "/scene/main.rtl 2:9 `r`");
  CHECK(definition("r = 1\ngroup { r = 2\n sphere { radius: r } }\nsphere { radius: ‸r }") ==
        "/scene/main.rtl 1:1 `r`");
}

TEST_CASE("definition: the language's own names have no place, and nothing stands between names") {
  CHECK(definition("‸sphere {}") == "none");
  CHECK(definition("sphere { ‸radius: 2 }") == "none");
  CHECK(definition("sphere { radius: ‸2 }") == "none");
  CHECK(definition("// ‸ball\nball = sphere {}") == "none");
}

TEST_CASE("definition: a text with errors in it answers all the same") {
  CHECK(definition("ball = sphere { radius: }\nb‸all") == "/scene/main.rtl 1:1 `ball`");
  CHECK(definition("r = 2\nsphere { radius: ‸r, at: [1, 2 }\nbox {") == "/scene/main.rtl 1:1 `r`");
  CHECK(definition("r = 2\nx = unknown + ‸r\nsphere { raduis: r }") == "/scene/main.rtl 1:1 `r`");
  CHECK(definition("use \"missing.rtl\" as m\n‸m.post {}") == "/scene/main.rtl 1:22 `m`");
  const Scene scene("r = 2\nsphere { radius: ‸r + }");
  CHECK(scene.analysis().report.has_errors());
  CHECK(scene.definition() == "/scene/main.rtl 1:1 `r`");
}

TEST_CASE("definition: across files") {
  const std::vector<std::pair<std::string, std::string>> others{
      {"parts.rtl", "height = 3\ndef post(h = height) { box { size: h } }\n"}, {"walls.rtl", "brick = material {}\n"}};
  const auto at = [&](std::string_view marked) { return Scene(marked, others).definition(); };
  CHECK(at("use \"parts.rtl\" as p\np.‸post {}") == "parts.rtl 2:5 `post`");
  CHECK(at("use \"parts.rtl\" as p\np.post { ‸h: 2 }") == "parts.rtl 2:10 `h`");
  CHECK(at("use \"parts.rtl\" as p\nbox { size: p.height‸ }") == "parts.rtl 1:1 `height`");
  CHECK(at("use \"parts.rtl\" as p\n‸p.post {}") == "/scene/main.rtl 1:20 `p`");
  CHECK(at("include \"walls.rtl\"\nbox { material: ‸brick }") == "walls.rtl 1:1 `brick`");
  CHECK(at("include \"wal‸ls.rtl\"") == "walls.rtl 1:1 ``");
  CHECK(at("use \"par‸ts.rtl\" as p") == "parts.rtl 1:1 ``");
}

TEST_CASE("references: all places of a name, its declaration first") {
  CHECK(Scene("r = 1\nsphere { radius: ‸r }\nbox { size: [r, r, 1] }").references() ==
        "/scene/main.rtl 1:1 `r`, /scene/main.rtl 2:18 `r`, /scene/main.rtl 3:14 `r`, /scene/main.rtl 3:17 `r`");
  CHECK(Scene("def post(‸h = 1) { box { size: h } }\npost { h: 2 }").references() ==
        "/scene/main.rtl 1:10 `h`, /scene/main.rtl 1:31 `h`, /scene/main.rtl 2:8 `h`");
  CHECK(Scene("‸sphere {}\nball = sphere {}").references() ==
        "/scene/main.rtl 1:1 `sphere`, /scene/main.rtl 2:8 `sphere`");
}

TEST_CASE("references: items that are alike have each its own places") {
  std::string text = "r‸ = 1\n";
  for (int i = 0; i < 40; ++i) text += fmt::format("sphere {{ at: [{}, 0, 0], radius: r }}\n", i);
  const Scene scene(text);
  CHECK(find_references(scene.analysis(), 0, 0).size() == 41);
}

TEST_CASE("hover: what stands for what") {
  CHECK(hover_of("// The one\n// in the middle\nball = sphere {\n}\n‸ball") ==
        "ball = sphere { …\n  The one\n  in the middle");
  CHECK(hover_of("fn twice(x) = 2 * x\nr = ‸twice(2)") == "fn twice(x) = 2 * x");
  CHECK(hover_of("fn twice(x) = 2 * ‸x") == "x: a parameter of\n  fn twice(x) = 2 * x");
  CHECK(hover_of("for i in 0..3 { sphere { at: ‸i } }") == "i: known in\n  for i in 0..3 { sphere { at: i } }");
  CHECK(hover_of("a = ‸red") == "red = #ff0000");
  CHECK(hover_of("sphere { ‸radius: 2 }") == "radius: number = 1\n  distance from the centre to the surface");
  CHECK(hover_of("x = ‸sin(3)").starts_with("sin("));
  CHECK(hover_of("x = 2 * ‸pi").starts_with("pi = "));
  CHECK(hover_of("‸sphere {}").starts_with("sphere { … }"));
  CHECK(hover_of("sphere {}.‸move(x: 1)").starts_with("thing.move("));
  CHECK(hover_of("ball = sphere {}\nx = ball.‸radius").starts_with("radius: number"));
  CHECK(hover_of("x = ‸nonsense") == "none");
}
