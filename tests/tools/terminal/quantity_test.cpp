#include "tools/terminal/quantity.hpp"

#include <catch2/catch.hpp>

using namespace rt::tools;

TEST_CASE("quantity: whole numbers are read with digits, an exponent or a letter") {
  CHECK(parse_quantity("0", 1000) == 0u);
  CHECK(parse_quantity("20000000", 1000) == 20'000'000u);
  CHECK(parse_quantity("2e7", 1000) == 20'000'000u);
  CHECK(parse_quantity("20M", 1000) == 20'000'000u);
  CHECK(parse_quantity("1.5k", 1000) == 1500u);
  CHECK(parse_quantity("1.5K", 1024) == 1536u);
  CHECK(parse_quantity("4g", 1024) == 4'294'967'296u);
  CHECK(parse_quantity("1T", 1024) == 1'099'511'627'776u);
}

TEST_CASE("quantity: what is no whole number is not read") {
  for (const char* text : {"", "M", "x", "-1", "1.5", "20MM", "20 M", "1e99", "nan", "inf", "0x10", "1e"})
    CHECK_FALSE(parse_quantity(text, 1000));
}

TEST_CASE("quantity: people read three digits") {
  CHECK(human(0) == "0");
  CHECK(human(318) == "318");
  CHECK(human(0.25) == "0.25");
  CHECK(human(999.4) == "999");
  CHECK(human(999.5) == "1.00 k");
  CHECK(human(1204) == "1.20 k");
  CHECK(human(99'960) == "100 k");
  CHECK(human(2.5e7) == "25.0 M");
  CHECK(human(8.59e9) == "8.59 G");
}
