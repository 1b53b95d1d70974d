#include "tests/tools/rtlang/desk.hpp"

#include <catch2/catch.hpp>

#include <regex>
#include <sstream>

using namespace rt;
using namespace rt::tests;
using Catch::Matchers::Contains;

TEST_CASE("rtlang explain: it knows every code") {
  const Outcome list = rtlang({"explain"});
  CHECK(list.exit_code == 0);
  std::istringstream lines(list.output);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    INFO(line);
    REQUIRE(std::regex_match(line, std::regex("[A-Z][0-9]{4}  .+")));
    if (count % 10 == 0) CHECK_THAT(rtlang({"explain", line.substr(0, 5)}).output, Contains(line.substr(0, 5)));
  }
  CHECK(count > 20);
  CHECK(rtlang({"explain", "e0204"}).exit_code == 0);
}
