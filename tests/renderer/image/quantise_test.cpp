#include "renderer/image/quantise.hpp"
#include "renderer/math/color.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using rt::SrgbQuantiser;

// The expected numbers were computed apart from the program, from the formula of IEC 61966-2-1.
TEST_CASE("sRGB: eight bits follow the standard's formula") {
  const SrgbQuantiser quantise(8);
  CHECK(quantise(0.0f) == 0);
  CHECK(quantise(0.001f) == 3);  // 3.29
  CHECK(quantise(0.01f) == 25);  // 25.46
  CHECK(quantise(0.18f) == 118); // 117.65
  CHECK(quantise(0.2f) == 124);  // 123.55
  CHECK(quantise(0.5f) == 188);  // 187.52
  CHECK(quantise(0.75f) == 225); // 224.61
  CHECK(quantise(1.0f) == 255);
}

TEST_CASE("sRGB: sixteen bits follow the standard's formula") {
  const SrgbQuantiser quantise(16);
  CHECK(quantise(0.0f) == 0);
  CHECK(quantise(0.001f) == 847);  // 846.71
  CHECK(quantise(0.01f) == 6544);  // 6543.85
  CHECK(quantise(0.18f) == 30235); // 30234.97
  CHECK(quantise(0.5f) == 48192);  // 48191.62
  CHECK(quantise(1.0f) == 65535);
}

TEST_CASE("sRGB: what lies beyond 0 to 1 is clipped, and what is no number is black") {
  for (const int bits : {8, 16}) {
    const SrgbQuantiser quantise(bits);
    CHECK(quantise(-0.5f) == 0);
    CHECK(quantise(-std::numeric_limits<float>::infinity()) == 0);
    CHECK(quantise(std::numeric_limits<float>::quiet_NaN()) == 0);
    CHECK(quantise(7.5f) == (1 << bits) - 1);
    CHECK(quantise(std::numeric_limits<float>::infinity()) == (1 << bits) - 1);
  }
}

TEST_CASE("sRGB: the table gives what the formula gives, on both sides of every step") {
  const SrgbQuantiser quantise(8);
  const auto formula = [](float v) {
    const double x = static_cast<double>(v);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<int>(std::floor(255 * encoded + 0.5));
  };
  int different = 0;
  for (int code = 0; code < 255; ++code) {
    float v = static_cast<float>(rt::srgb_to_linear((code + 0.5) / 255));
    for (int i = 0; i < 20; ++i) v = std::nextafter(v, 0.0f);
    for (int i = 0; i < 40; ++i, v = std::nextafter(v, 1.0f)) different += quantise(v) != formula(v);
  }
  for (int i = 0; i <= 100'000; ++i) {
    const float v = static_cast<float>(i) / 100'000;
    different += quantise(v) != formula(v);
  }
  CHECK(different == 0);
}
