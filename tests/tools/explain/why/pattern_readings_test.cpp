// What a pattern shows at the point that is asked about.

#include "tests/tools/explain/why/explained.hpp"

using namespace rt;
using namespace rt::tests;
using namespace rt::tools;

TEST_CASE("why: of a pattern its point, its value and its place in the stops") {
  // The plane y = 0 is met at (0.75, 0, 0), in the pattern's own space (0.375, 0, 0): twice that is 0.75 of the
  // stops, half way from 0.5 to 1.
  const auto asked = along("plane { y: 0, material: gradient { direction: [1, 0, 0], frequency: 2, scale: 2, stops: "
                           "[[0.5, 0], [1, checker { a: 1, b: 0.5 }]] } }",
                           {0.75, 2, 0}, {0, -1, 0});
  const json patterns = surface_of(*asked)["patterns"];
  REQUIRE(patterns.size() == 2);
  CHECK(patterns[0]["property"] == "color");
  CHECK(patterns[0]["pattern"] == "gradient");
  CHECK(patterns[0]["depth"] == 0);
  CHECK(patterns[0]["point"][0].get<double>() == Approx(0.375));
  CHECK(patterns[0]["value"].get<double>() == Approx(0.375));
  CHECK(patterns[0]["place"].get<double>() == Approx(0.75));
  CHECK(patterns[0]["share"].get<double>() == Approx(0.5));
  CHECK(patterns[0]["shown"][1].get<double>() == Approx(0.5));
  CHECK(patterns[1]["pattern"] == "checker");
  CHECK(patterns[1]["depth"] == 1);
  CHECK(patterns[1]["point"][0].get<double>() == Approx(0.75));
  CHECK(patterns[1]["shown"][1] == 1);
  CHECK(surface_of(*asked)["color"][1].get<double>() == Approx(0.5));
  CHECK(contains(text_of(*asked), "color: `gradient` at [0.375, 0, 0] of its own space, value 0.375, place 0.75 in its "
                                  "stops, 0.5 of the way from one to the next"));
}

TEST_CASE("why: of a surface without patterns none is told") {
  CHECK_FALSE(surface_of(*along("sphere {}", {0, 0, 5}, {0, 0, -1})).contains("patterns"));
  CHECK_FALSE(surface_of(*along("sphere { material: red }", {0, 0, 5}, {0, 0, -1})).contains("patterns"));
}
