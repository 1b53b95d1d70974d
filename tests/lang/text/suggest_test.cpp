#include "lang/text/suggest.hpp"

#include <catch2/catch.hpp>

using namespace rt::lang;

namespace {

const std::vector<std::string_view> properties{"radius", "at",      "rotate",       "scale", "material",
                                               "name",   "visible", "casts_shadow", "from",  "to"};

std::optional<std::string_view> nearest_property(std::string_view word) {
  return nearest(word, properties);
}

} // namespace

TEST_CASE("suggest: distances count insertions, deletions, replacements and swaps") {
  CHECK(edit_distance("", "", 3) == 0);
  CHECK(edit_distance("abc", "abc", 3) == 0);
  CHECK(edit_distance("abc", "abd", 3) == 1);
  CHECK(edit_distance("abc", "ab", 3) == 1);
  CHECK(edit_distance("abc", "xabc", 3) == 1);
  CHECK(edit_distance("abc", "acb", 3) == 1);
  CHECK(edit_distance("kitten", "sitting", 9) == 3); // Levenshtein's classic example
  CHECK(edit_distance("ca", "abc", 9) == 3);         // 2 if letters between swapped ones could change
  CHECK(edit_distance("abcdef", "uvwxyz", 2) == 3);
  CHECK(edit_distance("a", "abcdef", 2) == 3);
}

TEST_CASE("suggest: a slip is recognised") {
  CHECK(nearest_property("raduis") == "radius");
  CHECK(nearest_property("radious") == "radius");
  CHECK(nearest_property("Radius") == "radius");
  CHECK(nearest_property("castsShadow") == "casts_shadow");
  CHECK(nearest_property("matrial") == "material");
  CHECK(nearest_property("rad") == "radius");
  CHECK(nearest_property("form") == "from");
  CHECK(nearest_property("ot") == "to");
  CHECK(nearest_property("ta") == "at");
}

TEST_CASE("suggest: what is far from everything gets no suggestion") {
  CHECK_FALSE(nearest_property("thickness"));
  CHECK_FALSE(nearest_property("x"));
  CHECK_FALSE(nearest_property("in"));
  CHECK_FALSE(nearest_property("color"));
  CHECK_FALSE(nearest("word", {}));
}

TEST_CASE("suggest: the nearest wins, and of equals the one that starts alike") {
  const std::vector<std::string_view> words{"cone", "bone", "zone"};
  CHECK(nearest("bonne", words) == "bone");
  CHECK(nearest("zome", words) == "zone");
}
