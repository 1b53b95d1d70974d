#include "tools/terminal/wrap.hpp"

#include <catch2/catch.hpp>

TEST_CASE("wrapping: what is too long goes on below the second column") {
  using rt::tools::wrapped;
  CHECK(wrapped("  radius  how far it is\nshort\n", 16) == "  radius  how\n          far it\n          is\nshort\n");
  CHECK(wrapped("one two three four\n", 10) == "one two\n  three\n  four\n");
  CHECK(wrapped("unbreakable_word\n", 6) == "unbreakable_word\n");
}
