#include "tests/paths.hpp"
#include "tests/support/program.hpp"

#include <catch2/catch.hpp>

using namespace rt::tests;

namespace {

std::string picture(const std::string& scene, const std::string& embree) {
  RunOptions options;
  if (!embree.empty()) options.environment = {"RTLANG_EMBREE=" + embree};
  const Outcome outcome = rtlang({"render", scene, "-o", "-", "--size", "60x45", "--quiet", "--threads", "1"}, options);
  CHECK(outcome.errors == "");
  REQUIRE(outcome.exit_code == 0);
  return outcome.output;
}

} // namespace

// Embree's trees are as wide as the processor's registers, and only the widest trace packets: what is hit must not
// depend on it.
TEST_CASE("instruction sets: the same picture, byte for byte, with every one that Embree is told to use") {
  for (const char* name : {"still_life", "nested_glass", "forest", "dice", "sphereflake"}) {
    INFO(name);
    const std::string scene = std::string(RTLANG_SOURCE_DIR "/examples/") + name + ".rtl";
    const std::string own = picture(scene, "");
    CHECK(own.size() > 1000);
    for (const char* set : {"sse2", "sse4.2", "avx", "avx2"}) {
      INFO(set);
      CHECK(picture(scene, std::string("isa=") + set) == own);
    }
  }
}

TEST_CASE("instruction sets: the setting reaches Embree, which works with nothing newer then") {
  RunOptions options;
  options.environment = {"RTLANG_EMBREE=isa=sse2,verbose=2"};
  TestFolder folder;
  folder.write("scene.rtl", "sphere {}\n");
  const Outcome outcome = rtlang({folder / "scene.rtl", "-o", folder / "out.png", "--size", "8x6"}, options);
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.output, Catch::Contains("Targets : SSE SSE2  (supported)"));
}
