#include "renderer/image/cryptomatte.hpp"

#include <catch2/catch.hpp>

using namespace rt::image;

TEST_CASE("cryptomatte: names are hashed as MurmurHash3 does") {
  // Published test vectors of MurmurHash3_x86_32 with seed 0.
  CHECK(murmur_hash("") == 0);
  CHECK(murmur_hash("test") == 0xba6bd213);
  CHECK(murmur_hash("hello") == 0x248bfa47);
  CHECK(murmur_hash("Hello, world!") == 0xc0363e43);
  CHECK(murmur_hash("The quick brown fox jumps over the lazy dog") == 0x2e4ff723);
}

TEST_CASE("cryptomatte: an id is a float that is finite and normal") {
  CHECK(matte_id("test") == 0xba6bd213); // exponent 0x74
  CHECK(matte_id("") == 0x00800000);     // exponent 0 becomes 1
}

TEST_CASE("cryptomatte: metadata has the layer's key and a manifest in JSON") {
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  CHECK(matte_metadata("test", {{"a \"b\"", 0x12}, {"c", 0xff00}}) ==
        Pairs{{"cryptomatte/ba6bd21/name", "test"},
              {"cryptomatte/ba6bd21/hash", "MurmurHash3_32"},
              {"cryptomatte/ba6bd21/conversion", "uint32_to_float32"},
              {"cryptomatte/ba6bd21/manifest", "{\"a \\\"b\\\"\":\"00000012\",\"c\":\"0000ff00\"}"}});
}
