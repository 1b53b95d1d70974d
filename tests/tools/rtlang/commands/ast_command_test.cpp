#include "tests/tools/rtlang/desk.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;
using Catch::Matchers::Contains;

TEST_CASE("rtlang ast: it shows the tree, also of a text that is wrong") {
  const Desk desk;
  const Outcome good = desk.run({"ast", "scene.rtl"});
  CHECK(good.exit_code == 0);
  CHECK_THAT(good.output, Contains("sphere"));
  desk.folder.write("scene.rtl", "sphere { radius 1 }\nbox { }\n");
  const Outcome bad = desk.run({"ast", "scene.rtl"});
  CHECK(bad.exit_code == 1);
  CHECK_THAT(bad.output, Contains("error") && Contains("box"));
  CHECK_THAT(bad.errors, Contains("scene.rtl:1:17"));
}
