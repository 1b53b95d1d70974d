#include "tests/tools/rtlang/desk.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace rt;
using namespace rt::tests;
using nlohmann::json;

TEST_CASE("rtlang scene: it prints the description as JSON, with the command line's overrides") {
  const Desk desk;
  const Outcome run = desk.run({"scene", "scene.rtl", "--size", "8x6", "-D", "radius=0.1"});
  CHECK(run.exit_code == 0);
  const json j = json::parse(run.output);
  CHECK(j["size"] == json({8, 6}));
  CHECK(j["objects"].size() == 2);
  CHECK(j["objects"][0]["radius"] == 0.1);
  CHECK(j["objects"][0]["file"] == "scene.rtl");
  CHECK(j["objects"][0]["line"] == 7);
  CHECK(j["camera"]["at"] == json({0, 1, 5}));
  CHECK(desk.run({"scene", "scene.rtl", "--size", "8x6", "-D", "radius=0.1"}).output == run.output);
}
