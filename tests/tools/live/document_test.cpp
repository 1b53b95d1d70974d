#include "tools/live/document.hpp"
#include "tools/live/povray.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tools;

namespace {

live::Document document_of(const std::string& text, const live::PictureSettings& settings = {}) {
  lang::LoadOptions options;
  options.lint = true;
  return {lang::load_text(text, "test.rtl", ".", options), "test.rtl", settings};
}

const char* const ball = "camera { at: [0, 0, 10], look_at: [0, 0, 0] }\nsize: [5, 5]\nsphere { radius: 2 }\n";

TEST_CASE("document: a pixel is asked about in the size that the settings say") {
  // The middle of 5 × 5 pixels sees the ball's nearest point, 8 away.
  live::Document small = document_of(ball);
  CHECK_THAT(small.probe({.pixel = std::array{2, 2}}, {}), Catch::Contains("distance 8\n"));
  CHECK_THROWS_AS(small.probe({.pixel = std::array{50, 50}}, {}), explain::QuestionError);
  live::Document large = document_of(ball, {.size = scene::Resolution{101, 101}});
  CHECK_THAT(large.probe({.pixel = std::array{50, 50}}, {}), Catch::Contains("distance 8\n"));
}

TEST_CASE("document: its picture is the scene's") {
  live::Document document = document_of(ball);
  const Film film = document.render({}).film, whole = rt::render(document.scene(), {}).film;
  REQUIRE(film.color.size() == 25);
  for (std::size_t i = 0; i < film.color.size(); ++i) CHECK(film.color[i].r == whole.color[i].r);
}

TEST_CASE("document: a text that is wrong has no scene, and says why") {
  const live::Document document = document_of("sphere { raduis: 1 }\n");
  CHECK_FALSE(document.has_scene());
  REQUIRE(document.diagnostics().size() == 1);
  CHECK(document.diagnostics().front().code == "E0204");
}

TEST_CASE("document: what POV-Ray cannot compute exactly is named with its place") {
  CHECK(live::export_povray(document_of(ball), true).problems.empty());
  const std::string spot = "spot { at: [0, 9, 0], look_at: [0, 0, 0], angle: 20, shadows: false }\n";
  const live::PovrayExport exported = live::export_povray(document_of(ball + spot), true);
  CHECK(exported.problems.starts_with("error: POV-Ray has no spotlight without shadows"));
  CHECK(exported.problems.ends_with("\n  --> test.rtl:4\n"));
}

TEST_CASE("document: the lint's warnings are at hand") {
  const live::Document document = document_of("unused = 3\n" + std::string(ball));
  const std::vector<lang::Diagnostic> warnings = document.lint({});
  REQUIRE_FALSE(warnings.empty());
  CHECK(warnings.front().message.find("unused") != std::string::npos);
}

} // namespace
