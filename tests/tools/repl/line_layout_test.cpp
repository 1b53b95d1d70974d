#include "tools/repl/line_editor.hpp"

#include <catch2/catch.hpp>

using namespace rt::tools;

TEST_CASE("completion list: words stand in columns, read downwards") {
  CHECK(in_columns({"aa", "b", "c", "d"}, 12) == "aa  c\nb   d\n");
}

TEST_CASE("indentation: two spaces for each open bracket, those in strings and comments aside") {
  CHECK(indentation_after("sphere {") == "  ");
  CHECK(indentation_after("for x in [1, 2] {\n  box { size: [x") == "      ");
  CHECK(indentation_after("a = \"{\" // {") == "");
}
