// How much of an explanation is shown, and what the program says of questions.

#include "tests/paths.hpp"
#include "tests/support/program.hpp"
#include "tests/tools/explain/why/explained.hpp"
#include "tools/terminal/exit_code.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace rt;
using namespace rt::tests;
using namespace rt::tools;

TEST_CASE("why: the path that carries most of the light is found, with what it carries") {
  // A clear slab on a white background, met at right angles: 0.9 of the light comes in and 0.9 of that out again, 0.04
  // is mirrored.
  const std::string slab = "background: #fff\nambient: 0\nbox { from: [-9, -9, -9], to: [9, 0, 9], material: ";
  const auto clear = along(slab + "material { refract: 0.9, reflect: 0.04, ior: 1.5 } }", {0, 1, 0}, {0, -1, 0});
  const explain::LightPath& through = clear->answer.path;
  REQUIRE(through.steps.size() == 3);
  CHECK(through.steps[0].onwards == explain::WayStep::How::refracted);
  CHECK(through.steps[1].onwards == explain::WayStep::How::refracted);
  CHECK(through.steps[2].surface == nullptr);
  CHECK(through.light.g == Approx(0.81));
  const auto mirror = along(slab + "material { refract: 0.5, reflect: 0.95, ior: 1.5 } }", {0, 1, 0}, {0, -1, 0});
  REQUIRE(mirror->answer.path.steps.size() == 2);
  CHECK(mirror->answer.path.steps[0].onwards == explain::WayStep::How::mirrored);
  CHECK(mirror->answer.path.light.g == Approx(0.95));
  // A pane that does not bend light is crossed by the same ray.
  const auto pane = along(slab + "material { refract: 0.9 } }", {0, 1, 0}, {0, -1, 0});
  REQUIRE(pane->answer.path.steps.size() == 3);
  CHECK(pane->answer.path.steps[0].onwards == explain::WayStep::How::crossed);
  CHECK(pane->answer.path.light.g == Approx(0.81));
}

TEST_CASE("why: where no light comes, the path is the one along which most would be seen") {
  const auto asked = along("ambient: 0\nmax_depth: 2\nplane { z: -1, material: material { reflect: 1 } }\n"
                           "plane { z: 9, material: material { reflect: 1 } }",
                           {0, 0, 5}, {0, 0, -1});
  const explain::LightPath& path = asked->answer.path;
  REQUIRE(path.steps.size() == 4); // both mirrors, the first one again, and the ray that may not go on
  CHECK(path.steps[2].surface->surface.position.z == Approx(-1));
  CHECK(path.steps[3].ray->end == explain::RayNode::End::too_deep);
  CHECK(path.light == black);
  CHECK(contains(explain::why_text(asked->answer, {}),
                 "no light arrives; this is the path along which most would be seen"));
}

TEST_CASE("why: the path alone is what a screen holds, and the terms that make 90 % of the colour") {
  // The slab's rays, at right angles: in, out, and what is mirrored at either side, to and fro inside. 0.81 comes
  // through at once, and in all 0.04 + 0.81·(1 + 0.04 + 0.04² + …) = 0.88375, of which it is 91.7 %.
  const auto asked = along(
      "background: #fff\nambient: 0, min_weight: 0\nbox { from: [-9, -9, -9], to: [9, 0, 9], material: material { "
      "refract: 0.9, reflect: 0.04, ior: 1.5 } }",
      {0, 1, 0}, {0, -1, 0});
  const std::string text = explain::why_text(asked->answer, {}), tree = explain::why_text(asked->answer, whole);
  CHECK(std::count(text.begin(), text.end(), '\n') < 40);
  CHECK(std::count(tree.begin(), tree.end(), '\n') > 150);
  CHECK(contains(text, "the path that carries most of the light, 92 % of it"));
  CHECK(contains(text, "the background, through box (line 3)\n"));
  CHECK(contains(text, "smaller terms\n"));
  CHECK_FALSE(contains(text, "mirrored ray"));
  // As JSON: what is not on the path has no surfaces.
  const json first = explain::why_json(asked->answer, {})["tree"]["surfaces"].at(0);
  CHECK_FALSE(first["mirror"]["ray"].contains("surfaces"));
  CHECK(first["passage"]["ray"].contains("surfaces"));
  CHECK(explain::why_json(asked->answer, whole)["tree"]["surfaces"].at(0)["mirror"]["ray"].contains("ends_at"));
}

TEST_CASE("why: --least sums up rays of little weight, wherever they are") {
  const auto asked = along(
      "background: #fff\nambient: 0, min_weight: 0\nbox { from: [-9, -9, -9], to: [9, 0, 9], material: material { "
      "refract: 0.9, reflect: 0.04, ior: 1.5 } }",
      {0, 1, 0}, {0, -1, 0});
  const explain::Detail strong{.least = 0.5};
  const json first = explain::why_json(asked->answer, strong)["tree"]["surfaces"].at(0);
  CHECK_FALSE(first["mirror"]["ray"].contains("surfaces")); // 0.04
  const json second = first["passage"]["ray"]["surfaces"].at(0);
  CHECK_FALSE(second["mirror"]["ray"].contains("surfaces")); // 0.9·0.04
  CHECK(second["passage"]["ray"].contains("surfaces"));      // 0.9·0.9
}

TEST_CASE("why: --depth sums up deeper rays in a line, and the sum stays whole") {
  const auto asked =
      along("background: #fff\nsphere { material: material { refract: 0.9, ior: 1.5 } }", {0, 0.3, 5}, {0, 0, -1});
  const json shallow = explain::why_json(asked->answer, {.depth = 0})["tree"];
  CHECK_FALSE(shallow["surfaces"].at(0)["passage"]["ray"].contains("surfaces"));
  CHECK(shallow["surfaces"].at(0)["passage"]["ray"].contains("radiance"));
  CHECK(explain::why_json(asked->answer, {.depth = 0})["sum_of_terms"] ==
        explain::why_json(asked->answer, {.depth = 9})["sum_of_terms"]);
}

TEST_CASE("why: no line of an explanation is wider than 100 columns") {
  const auto asked = along("background: #fff\nsphere { material: material { refract: 0.9, ior: 1.5, reflect: 0.5 } "
                           "}\nplane { y: -2, material: checker { a: red, b: blue } }",
                           {0.1, 0.3, 5}, {0, 0, -1});
  const std::string text = explain::why_text(asked->answer, whole);
  int column = 0, widest = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) continue; // the rest of a character
    column = c == '\n' ? 0 : column + 1;
    widest = std::max(widest, column);
  }
  CHECK(widest <= 100);
}

TEST_CASE("why: what the README shows is what it says") {
  std::ostringstream page;
  page << std::ifstream(RTLANG_SOURCE_DIR "/README.md").rdbuf();
  const std::string text = page.str(), command = "$ rtlang why examples/still_life.rtl --pixel 250,400\n";
  const std::size_t begin = text.find(command);
  REQUIRE(begin != std::string::npos);
  std::istringstream block(text.substr(begin + command.size(), text.find("```", begin) - begin - command.size()));
  RunOptions options;
  options.folder = RTLANG_SOURCE_DIR;
  const std::string output = rtlang({"why", "examples/still_life.rtl", "--pixel", "250,400"}, options).output;
  for (std::string line; std::getline(block, line);)
    if (line != "…") CHECK(contains(output, line + "\n"));
}

TEST_CASE(
    "why: a miss is an answer; a scene that is wrong, a question that is none and a file that is not there are not") {
  const TestFolder folder;
  folder.write("empty.rtl", "background: #123456\n");
  folder.write("wrong.rtl", "sphere { raduis: 2 }\n");
  const Outcome miss = rtlang({"why", folder / "empty.rtl", "--pixel", "1,1", "--quiet"});
  CHECK(miss.exit_code == 0);
  CHECK(contains(flowing(miss.output), "shown as #123456"));
  CHECK(contains(flowing(miss.output), "this is the background"));
  CHECK(rtlang({"why", folder / "wrong.rtl", "--pixel", "1,1"}).exit_code == exit_scene_is_wrong);
  CHECK(rtlang({"why", folder / "empty.rtl"}).exit_code == exit_usage);
  CHECK(rtlang({"why", folder / "empty.rtl", "--pixel", "9999,1"}).exit_code == exit_usage);
  CHECK(rtlang({"why", folder / "none.rtl", "--pixel", "1,1"}).exit_code == exit_environment);
  const Outcome machine = rtlang({"why", folder / "empty.rtl", "--at", "3.5,2.25", "--json", "--quiet"});
  CHECK(json::parse(machine.output)["tree"]["ends_at"] == "background");
}
