#include "renderer/image/image.hpp"

#include <catch2/catch.hpp>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

using namespace rt;
using namespace std::string_literals;
using Catch::Matchers::Contains;

namespace {

/// 3 × 2 pixels of which no two are alike.
Film film() {
  Film f;
  f.width = 3;
  f.height = 2;
  f.color = {{0, 0.18f, 0.5f}, {1, 0.2f, 0.01f}, {2.5f, -1, 0.75f}, {0.001f, 0, 0}, {0, 1, 0}, {0.1f, 0.2f, 0.3f}};
  return f;
}

Film film_with_layers() {
  Film f = film();
  for (int i = 0; i < 6; ++i) {
    const float v = static_cast<float>(i);
    f.depth.push_back(i == 5 ? std::numeric_limits<double>::infinity() : 0.5 * i);
    f.normal.push_back({v, v + 0.25f, v + 0.5f});
    f.position.push_back({-v, 1e6f * v, 1e-6f * v});
    f.object_id.push_back(static_cast<std::uint32_t>(i) * 1'000'000'007u);
    f.albedo.push_back({v / 8, v / 16, v / 32});
  }
  return f;
}

std::string from_hex(std::string_view digits) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes.push_back(static_cast<char>(16 * value(digits[i]) + value(digits[i + 1])));
  return bytes;
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// The chunks of a png in order: their types and data.
std::vector<std::pair<std::string, std::string>> chunks(std::string_view png) {
  std::vector<std::pair<std::string, std::string>> list;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::uint32_t size = big_endian(png, at);
    list.emplace_back(png.substr(at + 4, 4), png.substr(at + 8, size));
    at += 12 + size;
  }
  return list;
}

// 2 × 1 pixels rendered by POV-Ray 3.7 with File_Gamma=1.0: (0.25, 0.5, 1.75) and (0.125, 0.75, 0).
constexpr std::string_view povray_png =
    "89504e470d0a1a0a0000000d49484452000000020000000110020000002bd0349e0000000467414d41000186a031e8965f0000000373"
    "42495410101058a3bd27000000096f464673000000000000000000da2ab6ce0000000774494d4507ea0b170f0a0fa0197e5500000024"
    "74455874536f66747761726500504f562d52617920332e372e302e31302e756e6f6666696369616c7174e4590000005674455874436f"
    "6d6d656e740052656e64657220446174653a20323032362d31312d32332031353a31303a31355a0a506c6174666f726d3a207838365f"
    "36342d70632d6c696e75782d676e750a436f6d70696c65723a20672b2b0ae918c136000000154944415408996370606860f8ff5f8161"
    "ff7f0606001db7049db953e6150000000049454e44ae426082";
constexpr std::string_view povray_exr =
    "762f3101020000006368616e6e656c730063686c69737400370000004200010000000000000001000000010000004700010000000000"
    "0000010000000100000052000100000000000000010000000100000000636f6d6d656e747300737472696e67002c000000506c617466"
    "6f726d3a207838365f36342d70632d6c696e75782d676e750a436f6d70696c65723a20672b2b0a636f6d7072657373696f6e00636f6d"
    "7072657373696f6e0001000000036372656174696f6e00737472696e670014000000323032362d31312d32332031353a31303a31345a"
    "6461746157696e646f7700626f783269001000000000000000000000000100000000000000646973706c617957696e646f7700626f78"
    "32690010000000000000000000000001000000000000006c696e654f72646572006c696e654f72646572000100000000706978656c41"
    "7370656374526174696f00666c6f617400040000000000803f73637265656e57696e646f7743656e7465720076326600080000000000"
    "00000000000073637265656e57696e646f77576964746800666c6f617400040000000000803f736f66747761726500737472696e6700"
    "1b000000504f562d52617920332e372e302e31302e756e6f6666696369616c00d801000000000000000000000c000000003f00000038"
    "003a00340030";

} // namespace

TEST_CASE("image: a file name's extension says which kind of picture it is") {
  CHECK(format_of("a.png") == ImageFormat::png);
  CHECK(format_of("dir.d/A.PNG") == ImageFormat::png);
  CHECK(format_of("x.y.exr") == ImageFormat::exr);
  CHECK(format_of("x.ppm") == ImageFormat::ppm);
  CHECK(format_of("x.pfm") == ImageFormat::pfm);
  CHECK_FALSE(format_of("x.jpg"));
  CHECK_FALSE(format_of("png"));
  CHECK_FALSE(format_of("dir.png/x"));
  CHECK_FALSE(format_of(""));
}

TEST_CASE("image: a png has the signature, header and chunks it should, and no time") {
  const std::string png =
      encode(film(), ImageFormat::png, {.bits = 8, .text = {{"Software", "rtlang 1"}, {"Scene", "abc"}}});
  REQUIRE(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  const auto list = chunks(png);
  REQUIRE(list.front().first == "IHDR");
  CHECK(list.front().second == "\0\0\0\3\0\0\0\2\x08\x02\0\0\0"s); // 3 × 2, 8 bits, RGB
  CHECK(list.back().first == "IEND");
  std::vector<std::string> types, texts;
  for (const auto& [type, data] : list) {
    types.push_back(type);
    if (type == "tEXt") texts.push_back(data);
    if (type == "gAMA") CHECK(big_endian(data, 0) == 45455);
  }
  CHECK_THAT(types,
             Catch::VectorContains("sRGB"s) && Catch::VectorContains("gAMA"s) && !Catch::VectorContains("tIME"s));
  CHECK(texts == std::vector<std::string>{"Software\0rtlang 1"s, "Scene\0abc"s});
}

TEST_CASE("image: libpng itself finds the sRGB numbers in a png of eight bits") {
  const std::string png = encode(film(), ImageFormat::png, {});
  png_image reader{};
  reader.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&reader, png.data(), png.size()));
  reader.format = PNG_FORMAT_RGB;
  std::vector<int> samples(18);
  std::vector<png_byte> buffer(18);
  REQUIRE(png_image_finish_read(&reader, nullptr, buffer.data(), 0, nullptr));
  samples.assign(buffer.begin(), buffer.end());
  CHECK(samples == std::vector<int>{0, 118, 188, 255, 124, 25, 255, 0, 225, 3, 0, 0, 0, 255, 0, 89, 124, 149});
}

TEST_CASE("image: a ppm of eight and of sixteen bits holds exactly these bytes") {
  CHECK(encode(film(), ImageFormat::ppm, {}) ==
        "P6\n3 2\n255\n\x00\x76\xbc\xff\x7c\x19\xff\x00\xe1\x03\x00\x00\x00\xff\x00\x59\x7c\x95"s);
  Film one = film();
  one.width = one.height = 1;
  one.color = {{0.001f, 0.18f, 0.5f}}; // 847, 30235, 48192
  CHECK(encode(one, ImageFormat::ppm, {.bits = 16, .text = {}}) == "P6\n1 1\n65535\n\x03\x4f\x76\x1b\xbc\x40"s);
}

TEST_CASE("image: a pfm holds linear floats, low byte first, from the bottom row up") {
  Film f;
  f.width = 1;
  f.height = 2;
  f.color = {{1, 2, -0.5f}, {0, 0.25f, 4}};
  CHECK(encode(f, ImageFormat::pfm, {}) == "PF\n1 2\n-1.0\n"
                                           "\0\0\0\0\0\0\x80\x3e\0\0\x80\x40"
                                           "\0\0\x80\x3f\0\0\0\x40\0\0\0\xbf"s);
}

TEST_CASE("image: floats come back from exr and pfm as they were") {
  const Film f = film();
  for (const ImageFormat format : {ImageFormat::exr, ImageFormat::pfm}) {
    const Image image = decode(encode(f, format, {}), "x");
    CHECK(image.bits == 32);
    REQUIRE(image.width == 3);
    REQUIRE(image.height == 2);
    for (std::size_t i = 0; i < f.color.size(); ++i) {
      CHECK(image.color[i].r == f.color[i].r);
      CHECK(image.color[i].g == f.color[i].g);
      CHECK(image.color[i].b == f.color[i].b);
    }
  }
}

TEST_CASE("image: the layers of an exr come back, as named channels") {
  const Film f = film_with_layers();
  const std::string exr = encode(f, ImageFormat::exr, {.bits = 8, .text = {{"scene", "0123"}}});
  for (const char* channel : {"R", "depth.Z", "normal.X", "position.Y", "object.id", "albedo.B"})
    CHECK(exr.find(channel + "\0"s) != std::string::npos);
  const Image image = decode(exr, "x");
  REQUIRE(image.has_layers());
  CHECK(image.depth == f.depth);
  CHECK(image.object_id == f.object_id);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(image.normal[i].y == f.normal[i].y);
    CHECK(image.position[i].x == f.position[i].x);
    CHECK(image.position[i].y == f.position[i].y);
    CHECK(image.position[i].z == f.position[i].z);
    CHECK(image.albedo[i].b == f.albedo[i].b);
  }
}

TEST_CASE("image: whole numbers come back as the light they stand for") {
  for (const ImageFormat format : {ImageFormat::png, ImageFormat::ppm}) {
    for (const int bits : {8, 16}) {
      const Film f = film();
      const Image image = decode(encode(f, format, {.bits = bits, .text = {}}), "x");
      REQUIRE(image.bits == bits);
      REQUIRE(image.color.size() == 6);
      const double half_step = 0.5 / ((1 << bits) - 1) * 2.4; // the curve is nowhere steeper towards light
      for (std::size_t i = 0; i < 6; ++i) {
        CHECK(image.color[i].r == Approx(std::clamp(f.color[i].r, 0.0f, 1.0f)).margin(half_step));
        CHECK(image.color[i].g == Approx(std::clamp(f.color[i].g, 0.0f, 1.0f)).margin(half_step));
        CHECK(image.color[i].b == Approx(std::clamp(f.color[i].b, 0.0f, 1.0f)).margin(half_step));
      }
    }
  }
}

TEST_CASE("image: pictures of POV-Ray are read as the light that its scene emits") {
  const Image png = decode(from_hex(povray_png), "x"), exr = decode(from_hex(povray_exr), "x");
  CHECK(png.bits == 16);
  REQUIRE(png.width == 2);
  REQUIRE(exr.width == 2);
  REQUIRE(exr.height == 1);
  CHECK(png.color[0].r == Approx(16384 / 65535.0)); // floor(0.25·65535 + 1/2), and its gAMA is 1
  CHECK(png.color[0].g == Approx(32768 / 65535.0));
  CHECK(png.color[0].b == 1);
  CHECK(png.color[1].r == Approx(8192 / 65535.0));
  CHECK(exr.color[0].r == 0.25f); // half floats hold these exactly
  CHECK(exr.color[0].g == 0.5f);
  CHECK(exr.color[0].b == 1.75f);
  CHECK(exr.color[1].r == 0.125f);
  CHECK(exr.color[1].g == 0.75f);
  CHECK(exr.color[1].b == 0);
}

// Made with another program's zlib; the lights are the standard's formula of code / 255.
TEST_CASE("image: pngs of all kinds are read") {
  SECTION("grey of 16 bits, linear by its gAMA") {
    const Image image =
        decode(from_hex("89504e470d0a1a0a0000000d494844520000000200000001100000000081d9fc150000000467414d41"
                        "000186a031e8965f0000000d49444154789c636860f8ff1f000502027f165ec4650000000049454e"
                        "44ae426082"),
               "x");
    CHECK(image.color[0].g == Approx(0x8000 / 65535.0));
    CHECK(image.color[1].b == 1);
  }
  SECTION("a palette of two bits, sRGB by its chunk even where linear is assumed") {
    const Image image =
        decode(from_hex("89504e470d0a1a0a0000000d49484452000000040000000102030000008452e75e0000000173524742"
                        "00aece1ce90000000c504c5445ff000000bc00000076ffffffcc435c490000000a49444154789c63"
                        "900600001d001c8ef4f5210000000049454e44ae426082"),
               "x", Transfer::linear);
    REQUIRE(image.width == 4);
    CHECK(image.color[0].r == 1);
    CHECK(image.color[1].g == Approx(0.5028864580325687));
    CHECK(image.color[2].b == Approx(0.18116424424986022));
    CHECK(image.color[3].g == 1);
  }
  SECTION("RGBA of eight bits that does not say what it means") {
    const std::string bytes =
        from_hex("89504e470d0a1a0a0000000d49484452000000010000000108060000001f15c4890000000d49444154"
                 "789c63d853c6d5000004eb01bdc6d6588d0000000049454e44ae426082");
    CHECK(decode(bytes, "x").color[0].r == Approx(0.5028864580325687));
    CHECK(decode(bytes, "x").color[0].b == Approx(0.003035269835488375));
    CHECK(decode(bytes, "x", Transfer::linear).color[0].r == Approx(188 / 255.0));
  }
  SECTION("grey of eight bits with a gamma of 1 / 2.2") {
    const Image image =
        decode(from_hex("89504e470d0a1a0a0000000d49484452000000010000000108000000003a7e9b550000000467414d41"
                        "0000b18f0bfc61050000000a49444154789c636800000082008177cd72b60000000049454e44ae42"
                        "6082"),
               "x");
    CHECK(image.color[0].r == Approx(0.21952304667332076));
  }
}

TEST_CASE("image: ppm and pgm are read in text and in bytes, with comments and any greatest value") {
  CHECK(decode("P3 # a comment\n2 1 # another\n15\n15 0 3  0 7 15\n", "x", Transfer::linear).color[1].g ==
        Approx(7 / 15.0));
  CHECK(decode("P2\n1 1\n4\n1", "x", Transfer::linear).color[0].b == Approx(0.25));
  CHECK(decode("P5\n1 1\n255\n\x80"s, "x", Transfer::linear).color[0].g == Approx(128 / 255.0));
  CHECK(decode("P5\n1 1\n1000\n\x01\xf4"s, "x", Transfer::linear).color[0].g == Approx(0.5));
  CHECK(decode("P6\n1 1\n255\n\xbc\x76\x0a"s, "x").color[0].r == Approx(0.5028864580325687));
  CHECK(decode("Pf\n1 1\n1.0\n\x3f\0\0\0"s, "x").color[0].g == 0.5f); // high byte first
}

TEST_CASE("image: a damaged file is told from a picture, and is named") {
  const auto message = [](std::string_view bytes) -> std::string {
    try {
      decode(bytes, "bad.img");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(message(""), Contains("`bad.img` is not a supported picture file"));
  CHECK_THAT(message("GIF89a"), Contains("`bad.img` is not a supported picture file"));
  CHECK_THAT(message("P6\n2 2\n255\nabc"), Contains("`bad.img` cannot be read: the file is truncated"));
  CHECK_THAT(message("P6\n99999999 99999999\n255\nabc"), Contains("the file is truncated"));
  CHECK_THAT(message("P6\n-2 2\n255\nabc"), Contains("expected an integer"));
  CHECK_THAT(message("P5\n1 1\n70000\nabc"), Contains("70000"));
  CHECK_THAT(message("P3\n1 1\n9\n10 0 0"), Contains("greater"));
  CHECK_THAT(message("P3\n1 1\n9\n1 0        "), Contains("the file is truncated"));
  CHECK_THAT(message("PF\n2 2\n-1.0\nabc"), Contains("the file is truncated"));
  CHECK_THAT(message("PF\n0 2\n-1.0\n"), Contains("0 × 2"));
  for (const ImageFormat format : {ImageFormat::png, ImageFormat::exr}) {
    const std::string whole = encode(film(), format, {});
    for (std::size_t size = 8; size + 1 < whole.size(); size += 7)
      CHECK_THAT(message(whole.substr(0, size)), Contains("`bad.img` cannot be read: "));
  }
  std::string wrong = encode(film(), ImageFormat::png, {});
  wrong[wrong.size() - 30] = static_cast<char>(wrong[wrong.size() - 30] ^ 1);
  CHECK_THAT(message(wrong), Contains("`bad.img` cannot be read: "));
}

TEST_CASE("image: the same film gives the same bytes") {
  const Film f = film_with_layers();
  for (const ImageFormat format : {ImageFormat::png, ImageFormat::exr, ImageFormat::ppm, ImageFormat::pfm})
    CHECK(encode(f, format, {}) == encode(f, format, {}));
}
