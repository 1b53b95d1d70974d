// What a film says of itself beyond its colours: its place in the picture, how it is shown, what its objects are
// called.

#include "renderer/image/image.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cstdint>
#include <cstring>

using namespace rt;

TEST_CASE("film: a crop keeps its place in an exr") {
  Film f;
  f.width = 2, f.height = 3;
  f.color.resize(6, {0.25f, 0.5f, 1});
  f.left = 5, f.top = 7, f.picture_width = 40, f.picture_height = 30;
  const std::string exr = encode(f, ImageFormat::exr, {});
  const auto box = [&](const std::string& name) { // four whole numbers behind the name, the type and the size
    const std::size_t at = exr.find(name + '\0' + "box2i" + '\0') + name.size() + 11;
    std::array<std::int32_t, 4> numbers{};
    std::memcpy(numbers.data(), exr.data() + at, sizeof numbers);
    return numbers;
  };
  CHECK(box("dataWindow") == std::array<std::int32_t, 4>{5, 7, 6, 9});
  CHECK(box("displayWindow") == std::array<std::int32_t, 4>{0, 0, 39, 29});
  const Image back = decode(exr, "x");
  CHECK(back.width == 2);
  CHECK(back.height == 3);
  CHECK(back.color[5].g == 0.5f);
  CHECK(back.left == 5);
  CHECK(back.top == 7);
  CHECK(back.picture_width == 40);
  CHECK(back.picture_height == 30);
}

TEST_CASE("film: exposure and tone change what is shown, and no exr") {
  Film f;
  f.width = f.height = 1;
  f.color = {{0.5f, 0.18f, 2}};
  const auto ppm = [&](ToneMapping mapping) {
    f.tone_mapping = mapping;
    return encode(f, ImageFormat::ppm, {}).substr(11);
  };
  // By hand, 255 times the sRGB value of 0.5, 0.18, 1; of 1, 0.36, 1; and of 0.4921, 0.18, 0.9583.
  CHECK(ppm({}) == "\xbc\x76\xff");
  CHECK(ppm({1, Tone::clip}) == "\xff\xa2\xff");
  CHECK(ppm({0, Tone::filmic}) == "\xba\x76\xfa");
  f.tone_mapping = {};
  const std::string plain = encode(f, ImageFormat::exr, {});
  f.tone_mapping = {3, Tone::filmic};
  CHECK(encode(f, ImageFormat::exr, {}) == plain);
}

TEST_CASE("film: an exr with layers names its objects as a Cryptomatte does") {
  Film f;
  f.width = 3, f.height = 1;
  f.color.resize(3);
  f.depth.resize(3), f.normal.resize(3), f.position.resize(3), f.albedo.resize(3);
  f.object_id = {0, 7, 8};
  EncodeOptions options;
  options.object_name = [](std::uint32_t id) { return std::string(id == 7 ? "test" : "hello"); };
  const std::string exr = encode(f, ImageFormat::exr, options);
  CHECK(exr.find("{\"hello\":\"248bfa47\",\"test\":\"ba6bd213\"}") != std::string::npos); // MurmurHash3 of both
  CHECK(exr.find("MurmurHash3_32") != std::string::npos);
  CHECK(exr.find("CryptoObject00.A") != std::string::npos);
  const Image back = decode(exr, "x");
  CHECK(back.object_id == f.object_id);
  CHECK(encode(f, ImageFormat::exr, {}).find("Crypto") == std::string::npos);
}
