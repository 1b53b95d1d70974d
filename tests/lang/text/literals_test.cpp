#include "lang/text/literals.hpp"
#include "lang/text/utf8.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

using namespace rt::lang;

TEST_CASE("literals: numbers are the nearest doubles, as the C library reads them") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200'000; ++i) {
    const int digits = 1 + static_cast<int>(random() % 20), point = static_cast<int>(random() % 20);
    std::string text;
    for (int d = 0; d < digits; ++d) {
      if (d == point && d > 0) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    if (random() % 3 == 0) text += "e" + std::to_string(static_cast<int>(random() % 80) - 40);
    const NumberLiteral literal = read_number(text);
    INFO(text);
    REQUIRE(literal.value == std::strtod(text.c_str(), nullptr));
    REQUIRE(literal.length == text.size());
  }
}

TEST_CASE("literals: numbers at the ends of the range") {
  CHECK(read_number("1.7976931348623157e308").value == std::numeric_limits<double>::max());
  CHECK(read_number("1e309").value == std::numeric_limits<double>::infinity());
  CHECK(read_number("1e99999999999999").value == std::numeric_limits<double>::infinity());
  CHECK(read_number("1e-400").value == 0);
  CHECK(read_number("5e-324").value == std::numeric_limits<double>::denorm_min());
  CHECK(read_number("0." + std::string(400, '0') + "1").value == 0);
  CHECK(read_number("1" + std::string(400, '0')).value == std::numeric_limits<double>::infinity());
}

TEST_CASE("literals: a number ends where its suffix begins") {
  CHECK(read_number("30deg").length == 2);
  CHECK(read_number("1e").length == 1);
  CHECK(read_number("1..2").length == 1);
  CHECK(read_number("1.5e+3x").length == 6);
  CHECK(read_number("5.").length == 2);
  CHECK(read_number("5., 6").value == 5);
  CHECK(read_number("5.x").length == 1);
  CHECK(read_number("5.e").length == 1);
  CHECK(read_number("5.e2").value == 500);
  CHECK(read_number("5.e2").length == 4);
  CHECK(read_number(".5").value == 0.5);
  CHECK(read_number(".5.x").length == 2);
  CHECK(degrees_per("deg") == 1);
  CHECK(degrees_per("turn") == 360);
  CHECK(degrees_per("cm") == 0);
}

TEST_CASE("literals: colours") {
  CHECK(read_color("fff") == 0xffffff);
  CHECK(read_color("1a9") == 0x11aa99);
  CHECK(read_color("8Fd3A0") == 0x8fd3a0);
}

TEST_CASE("utf8: characters are decoded, and what is none is refused") {
  CHECK(decode("a").code_point == U'a');
  CHECK(decode("é").code_point == U'é');
  CHECK(decode("日").bytes == 3);
  CHECK(decode("🎈").code_point == 0x1f388);
  for (const char* wrong :
       {"\x80", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe6\x97", "\xff"}) {
    CHECK_FALSE(decode(wrong).is_valid);
  }
  for (const char32_t c : {U'a', U'é', U'日', char32_t{0x10ffff}}) {
    std::string text;
    append_utf8(text, c);
    CHECK(decode(text).code_point == c);
  }
}

TEST_CASE("utf8: the first wrong byte is found wherever it stands") {
  for (std::size_t at = 0; at < 40; ++at) {
    std::string text = std::string(at, 'a') + "\xff" + std::string(20, 'b');
    CHECK(find_invalid_utf8(text) == at);
  }
  CHECK_FALSE(find_invalid_utf8("größe 日本語 and more than eight bytes of it"));
  CHECK(find_invalid_utf8("12345678é\xc3") == 10);
}

TEST_CASE("literals: a sign belongs to the number behind it") {
  CHECK(read_signed_number("-12.5,").length == 5);
  CHECK(read_signed_number("-12.5,").value == -12.5);
  CHECK(read_signed_number("7").value == 7);
  CHECK(read_signed_number("+60]").value == 60);
  CHECK(read_signed_number("+60]").length == 3);
  CHECK(read_signed_number("-.5").value == -0.5);
  CHECK(std::isinf(read_signed_number("-1e400 ").value));
  CHECK(read_signed_number("-0]").length == 2);
  CHECK(std::signbit(read_signed_number("-0]").value));
  for (const char* none : {"", "-", "--1", "+", "-.", ".", ".x", "x", " 1"})
    CHECK(read_signed_number(none).length == 0);
}
