#include "tools/oracle/runs.hpp"

#include <catch2/catch.hpp>

using namespace rt::tools;

// The seeds are fixed, so that a failure is one of the change that was made; longer runs are recorded in README.md.
TEST_CASE("500 random scenes in colour are what POV-Ray makes of them") {
  oracle::RunSettings settings;
  settings.seed = 20'000;
  settings.scenes = 500;
  const oracle::RunResult result = oracle::run_colors(settings);
  INFO(report(result, oracle::Mode::color, false));
  CHECK(holds(result, oracle::Mode::color));
}

TEST_CASE("10,000 random scenes are where POV-Ray finds them") {
  oracle::RunSettings settings;
  settings.seed = 30'000;
  settings.scenes = 10'000;
  settings.at_once = 4;
  const oracle::RunResult result = oracle::run_geometry(settings);
  INFO(report(result, oracle::Mode::geometry, false));
  CHECK(holds(result, oracle::Mode::geometry));
}
