#include "tools/repl/line_layout.hpp"

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

TEST_CASE("rows of a text: newlines and the screen's edge begin new ones, and wide characters do not fit half") {
  CHECK(rows_above("", 5, 80) == 0);
  CHECK(rows_above("sphere {\n  radius: 2\n", 5, 80) == 2);
  CHECK(rows_above("12345", 5, 10) == 1); // the cursor stands at the next row's beginning
  CHECK(rows_above("1234", 5, 10) == 0);
  CHECK(rows_above("123\u6f22", 5, 9) == 1); // 漢 is two columns wide
  CHECK(rows_above("1234\u6f22", 5, 10) == 1);
}

TEST_CASE("what is pasted is written without what a terminal would obey") {
  CHECK(printable("a\x1b[2Jb\nü") == "a[2Jb\nü");
}
