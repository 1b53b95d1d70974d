#include "tools/terminal/picture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>

namespace {

using namespace rt::tools;

rt::Film film(int width, int height, rt::Rgb32 color) {
  rt::Film made;
  made.width = width;
  made.height = height;
  made.color.assign(static_cast<std::size_t>(width * height), color);
  return made;
}

struct Variable {
  std::string name;
  std::optional<std::string> before;
  Variable(const char* n, const char* value) : name(n) {
    if (const char* was = getenv(n)) before = was;
    setenv(n, value, 1);
  }
  ~Variable() { before ? setenv(name.c_str(), before->c_str(), 1) : unsetenv(name.c_str()); }
};

TEST_CASE("terminal attributes: 4 stands for sixels, 64 and 14 do not") {
  CHECK(has_sixels("\x1b[?62;4;22c"));
  CHECK(has_sixels("\x1b[?4c"));
  CHECK_FALSE(has_sixels("\x1b[?64;14;22c"));
  CHECK_FALSE(has_sixels(""));
}

TEST_CASE("picture: it fits the terminal and keeps its shape") {
  const Variable blocks("RTLANG_GRAPHICS", "blocks");
  const PicturePrinter printer(true);
  const PictureExtent wide = printer.fit({800, 400}, {80, 24, 0, 0}, 2);
  CHECK(wide.columns == 79);
  // 79 cells of 1 × 2 are 79 wide; half of that high is 39.5, which is 19.75 rows of height 2.
  CHECK(std::abs(wide.rows - 19.75) < 1);
  const PictureExtent tall = printer.fit({100, 400}, {80, 24, 0, 0}, 2);
  CHECK(tall.rows == 22);
  CHECK(tall.columns == 11);
}

TEST_CASE("picture: half blocks carry the film's colours, encoded as sRGB") {
  const Variable blocks("RTLANG_GRAPHICS", "blocks"), direct("COLORTERM", "truecolor");
  const PicturePrinter printer(true);
  // Linear 0.5 is sRGB 188 (IEC 61966-2-1: 1.055 · 0.5^(1/2.4) − 0.055 = 0.7354).
  const std::string text = printer.print(film(8, 8, {1, 0.5F, 0}), {4, 2, 8, 8});
  CHECK(text.find("255;188;0") != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') == 2);
}

TEST_CASE("picture: a terminal that has no colours is sent characters and no sequences") {
  const Variable form("RTLANG_GRAPHICS", ""), wish("NO_COLOR", "");
  const auto shown = [](const char* kind) {
    const Variable name("TERM", kind);
    return PicturePrinter(true).print(film(8, 8, {1, 0, 0}), {4, 2, 8, 8});
  };
  for (const char* kind : {"vt100", "vt102", "vt220", "dumb"}) {
    INFO(kind);
    CHECK(shown(kind).find('\x1b') == std::string::npos);
  }
  CHECK(shown("xterm").find('\x1b') != std::string::npos);
}

TEST_CASE("picture: without colours the lighter a pixel, the fuller its character") {
  const Variable text("RTLANG_GRAPHICS", "text");
  const PicturePrinter printer(true);
  const auto character = [&](rt::Rgb32 color) { return printer.print(film(2, 4, color), {1, 1, 2, 4}); };
  // L* of linear luminance Y is 116·Y^(1/3) − 16 (CIE 1976): of red (0.2126) 53, green (0.7152) 88, blue (0.0722) 32,
  // of 0.5 76; nine steps between 0 and 100.
  CHECK(character({0, 0, 0}) == " \n");
  CHECK(character({0, 0, 1}) == "-\n");
  CHECK(character({1, 0, 0}) == "+\n");
  CHECK(character({0.5F, 0.5F, 0.5F}) == "#\n");
  CHECK(character({0, 1, 0}) == "%\n");
  CHECK(character({9, 9, 9}) == "@\n");
  // Cells in order, from the top left.
  rt::Film halves = film(8, 8, {0, 0, 0});
  for (int y = 0; y < 4; ++y)
    for (int x = 4; x < 8; ++x) halves.color[halves.index(x, y)] = {1, 1, 1};
  CHECK(printer.print(halves, {4, 2, 8, 8}) == "  @@\n    \n");
}

TEST_CASE("picture: every pixel is where it belongs, also where rows are of odd lengths") {
  const Variable blocks("RTLANG_GRAPHICS", "blocks"), direct("COLORTERM", "truecolor");
  const PicturePrinter printer(true);
  // Seven columns, the last one red: each row must end in red, and nowhere else be it.
  rt::Film made = film(14, 12, {0, 0, 1});
  for (int y = 0; y < 12; ++y) made.color[made.index(12, y)] = made.color[made.index(13, y)] = {1, 0, 0};
  const std::string text = printer.print(made, {7, 3, 14, 12});
  std::size_t begin = 0;
  for (int row = 0; row < 3; ++row) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    const std::size_t blue = line.find("0;0;255"), red = line.find("255;0;0");
    REQUIRE(blue != std::string::npos);
    REQUIRE(red != std::string::npos);
    CHECK(blue < red);
    CHECK(line.find("0;0;255", red) == std::string::npos);
    begin = end + 1;
  }
}

TEST_CASE("picture: sixels, kitty's and iTerm2's protocols have their frames") {
  const auto printed = [](const char* graphics) {
    const Variable choice("RTLANG_GRAPHICS", graphics);
    return PicturePrinter(true).print(film(32, 32, {0, 0, 1}), {4, 2, 32, 32});
  };
  CHECK(printed("sixel").find("\x1bP") != std::string::npos);
  CHECK(printed("kitty").find("\x1b_G") != std::string::npos);
  CHECK(printed("iterm2").find("\x1b]1337;File=") != std::string::npos);
}

TEST_CASE("picture: without a terminal it is characters alone") {
  const PicturePrinter printer(false);
  CHECK(printer.graphics() == Graphics::text);
  CHECK(printer.print(film(8, 8, {1, 1, 1}), {4, 2, 8, 8}).find('\x1b') == std::string::npos);
}

} // namespace
