#include "tools/povray/export/sdl.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>

using namespace rt;
using namespace rt::tools::povray;

TEST_CASE("exported numbers read back as the same double, in as few digits as that takes") {
  for (const double v : {0.1, 1.0 / 3, 1e-300, 6.02214076e23, 0.1 + 0.2, 5e-324, -123456789.123456789, 1e7})
    CHECK(std::strtod(number(v).c_str(), nullptr) == v);
  CHECK(number(0.1) == "0.1");
  CHECK(number(-0.0) == "0");
  CHECK(number(0.1 + 0.2) == "0.30000000000000004");
}

TEST_CASE("exported transforms are POV-Ray's own words where it has them, a matrix where it has none") {
  CHECK(transforms({{2, 2, 2}, {0, 30, 0}, {1, 2, 3}, {}}) == " scale 2 rotate <0, 30, 0> translate <1, 2, 3>");
  CHECK(transforms({{1, 1, 1}, {}, {}, {}}) == "");
  CHECK(transform(scene::ScaleStep{{1, 2, 1}, {0, 1, 0}}) ==
        " translate <0, -1, 0> scale <1, 2, 1> translate <0, 1, 0>");
  CHECK(transform(scene::ShearStep{0.5, 0, 0, 0, 0, 0, {}}) == " matrix <1, 0, 0, 0.5, 1, 0, 0, 0, 1, 0, 0, 0>");
  // Rows are the images of x, y and z, then the translation.
  CHECK(transform(scene::MatrixStep{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}, {11, 12, 13}}}) ==
        " matrix <1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13>");
}
