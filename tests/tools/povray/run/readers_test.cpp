#include "tools/povray/run/povray.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

using namespace rt::tools::povray;

namespace {

std::string u32(std::uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8), static_cast<char>(v)};
}
std::string attribute(const std::string& key, const std::string& type, const std::string& payload) {
  return key + type + u32(static_cast<std::uint32_t>(payload.size())) + payload;
}
std::string floats(std::initializer_list<float> values) {
  std::string bytes;
  for (const float v : values) bytes += u32(std::bit_cast<std::uint32_t>(v));
  return bytes;
}
std::string message(std::uint32_t count, const std::string& attributes) {
  const std::string object = "RAWSOBJE" + u32(count) + attributes;
  return "POVRAYMS" + u32(0) + u32(static_cast<std::uint32_t>(16 + object.size() - 20)) + object;
}
std::string block(std::uint32_t left, std::uint32_t top, std::uint32_t right, std::uint32_t bottom,
                  const std::string& pixels) {
  const std::string counted = "PBloVFL4" + u32(static_cast<std::uint32_t>(pixels.size() / 4)) + pixels;
  return message(6, attribute("CLAS", "TYPE", "PixD") + counted + attribute("Left", "INT4", u32(left)) +
                        attribute("Top ", "INT4", u32(top)) + attribute("Righ", "INT4", u32(right)) +
                        attribute("Bott", "INT4", u32(bottom)));
}
std::string header() {
  std::string text = "POV-Ray Render State File\n";
  text.resize(512);
  return text;
}

} // namespace

TEST_CASE("render-state file: blocks in any order make up the picture") {
  const std::string file = header() + block(1, 0, 1, 1, floats({4, 5, 6, 0, 0, -7, 8e9f, 9, 0, 0})) +
                           message(1, attribute("Foo ", "CSTR", "something else")) +
                           block(0, 0, 0, 1, floats({1, 2, 3, 0, 0, 10, 11, 12, 0, 0}));
  const auto image = read_render_state(file, 2, 2);
  REQUIRE(image);
  CHECK((*image)[0].g == 2);
  CHECK((*image)[1].r == 4);
  CHECK((*image)[2].b == 12);
  CHECK((*image)[3].r == -7);
  CHECK((*image)[3].g == 8e9f);
}

TEST_CASE("render-state file: what is incomplete or something else is refused") {
  const std::string pixels = floats({1, 2, 3, 0, 0});
  CHECK_FALSE(read_render_state("", 1, 1));
  CHECK_FALSE(read_render_state(header(), 1, 1));
  CHECK_FALSE(read_render_state(header() + block(0, 0, 0, 0, pixels), 2, 1));
  CHECK_FALSE(read_render_state(header() + block(1, 0, 1, 0, pixels), 1, 1));
  CHECK_FALSE(read_render_state(header() + block(0, 0, 0, 0, pixels + pixels), 1, 1));
  const std::string whole = header() + block(0, 0, 0, 0, pixels);
  CHECK(read_render_state(whole, 1, 1));
  for (std::size_t size = 0; size < whole.size(); ++size) read_render_state(whole.substr(0, size), 1, 1);
}

TEST_CASE("packed ids: three channels of one byte each") {
  CHECK(decode_id({0, 0, 0}) == 0);
  CHECK(decode_id({257 * 5, 257 * 1, 0}) == 261);
  CHECK(decode_id({257 * 255, 257 * 255, 257 * 1}) == 131071);
}

TEST_CASE("packed distances: mantissa and exponent are found again within 2^-42") {
  // 10 = (1 + u)/2 · 2⁴ with u = ¼, in 41 bits: the middle of the last step is added.
  CHECK(decode_depth({16384, 0, (4 + 32) * 512}) == Approx(10).epsilon(0x1p-42));
  CHECK(decode_depth({65535, 65535, (0 + 32) * 512 + 511}) == Approx(1).epsilon(0x1p-42));
  CHECK(decode_depth({0, 0, (-3 + 32) * 512}) == Approx(0.0625).epsilon(0x1p-42));
  CHECK(std::isinf(decode_depth({0, 0, 0})));
}
