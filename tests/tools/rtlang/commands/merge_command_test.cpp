// Pictures of path mode whose samples are made in several goes, on several machines.

#include "tests/tools/rtlang/desk.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;
using Catch::Matchers::Contains;

namespace {

constexpr const char* lit_scene = R"(
mode: path
size: [24, 20]
samples: 32
exposure: 0.5
camera { at: [0, 1, 6], look_at: [0, 1, 0] }
ball = sphere { at: [0, 1, 0], material: material { color: tomato, reflect: 0.3, roughness: 0.4 } }
ball
plane { material: matte }
disc { at: [1, 4, 1], radius: 1, material: material { emission: 3 } }
)";

} // namespace

TEST_CASE("rtlang merge: four parts are the whole, byte for byte, in whatever order") {
  const Desk desk(lit_scene);
  REQUIRE(desk.run({"scene.rtl", "-o", "whole.exr", "-o", "whole.png"}).exit_code == 0);
  for (const std::string k : {"1", "2", "3", "4"})
    REQUIRE(desk.run({"scene.rtl", "--part", k + "/4", "-o", k + ".exr", "--threads", k}).exit_code == 0);
  CHECK(desk.image("2.exr").samples[0] == 8);
  CHECK(desk.run({"merge", "3.exr", "1.exr", "4.exr", "2.exr", "-o", "sum.exr", "-o", "sum.png"}).exit_code == 0);
  CHECK(desk.folder.read("sum.exr") == desk.folder.read("whole.exr"));
  CHECK(desk.folder.read("sum.png") == desk.folder.read("whole.png"));
  const Outcome half = desk.run({"merge", "1.exr", "2.exr", "-o", "a.exr"});
  CHECK(half.exit_code == 0);
  CHECK_THAT(half.errors, Contains("2 of 4 parts"));
  CHECK(desk.run({"merge", "a.exr", "4.exr", "3.exr", "-o", "b.exr"}).exit_code == 0);
  CHECK(desk.folder.read("b.exr") == desk.folder.read("whole.exr"));
}

TEST_CASE("rtlang merge: what is no whole is refused, with the reason") {
  const Desk desk(lit_scene);
  const auto render = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"scene.rtl", "-q", "--samples", "8"});
    REQUIRE(desk.run(arguments).exit_code == 0);
  };
  const auto message = [&](std::vector<std::string> arguments) {
    const Outcome run = desk.run(arguments);
    CHECK(run.exit_code == 2);
    return run.errors;
  };
  render({"-o", "plain.exr"});
  render({"-o", "whole.exr", "--sums"});
  render({"-o", "1.exr", "--part", "1/2"});
  render({"-o", "other.exr", "--part", "2/2", "--seed", "7"});
  render({"-o", "third.exr", "--part", "2/3"});
  render({"-o", "piece.exr", "--part", "2/2", "--crop", "0,0,9,9"});
  CHECK_THAT(message({"merge", "1.exr", "plain.exr", "-o", "x.png"}), Contains("`plain.exr` has no sums"));
  CHECK_THAT(message({"merge", "1.exr", "whole.exr", "-o", "x.png"}), Contains("already contains all samples"));
  CHECK_THAT(message({"merge", "1.exr", "1.exr", "-o", "x.png"}), Contains("part 1/2 is given twice"));
  CHECK_THAT(message({"merge", "1.exr", "other.exr", "-o", "x.png"}), Contains("different scenes, sizes or seeds"));
  CHECK_THAT(message({"merge", "1.exr", "third.exr", "-o", "x.png"}), Contains("one of 2 parts"));
  CHECK_THAT(message({"merge", "1.exr", "piece.exr", "-o", "x.png"}), Contains("different parts of the picture"));
  CHECK_THAT(message({"scene.rtl", "--part", "5/4", "-o", "x.exr"}), Contains("k-th of n"));
  CHECK_THAT(message({"scene.rtl", "--part", "1/4", "-o", "x.png"}), Contains("only an .exr can store"));
  CHECK_THAT(message({"scene.rtl", "--mode", "whitted", "--part", "1/4", "-o", "x.exr"}),
             Contains("cannot be used in whitted mode"));
  CHECK_THAT(message({"scene.rtl", "--continue", "plain.exr", "-o", "x.exr"}), Contains("has no sums"));
  CHECK_THAT(message({"scene.rtl", "--continue", "1.exr", "-o", "x.exr"}), Contains("a different --part"));
  desk.folder.write("scene.rtl", std::string(lit_scene) + "noise: 0.01\n");
  CHECK_THAT(message({"scene.rtl", "--part", "1/4", "-o", "x.exr"}), Contains("does not go with the scene's `noise`"));
}

TEST_CASE("rtlang render: 16 samples and 48 more are 64") {
  const Desk desk(lit_scene);
  REQUIRE(desk.run({"scene.rtl", "--samples", "64", "--sums", "-o", "64.exr"}).exit_code == 0);
  REQUIRE(desk.run({"scene.rtl", "--samples", "16", "--sums", "-o", "16.exr"}).exit_code == 0);
  CHECK(desk.run({"scene.rtl", "--samples", "64", "--continue", "16.exr", "-o", "on.exr"}).exit_code == 0);
  CHECK(desk.folder.read("on.exr") == desk.folder.read("64.exr"));
  // There is nothing to be done any more, and the picture is there all the same.
  CHECK(desk.run({"scene.rtl", "--samples", "64", "--continue", "on.exr", "-o", "again.exr"}).exit_code == 0);
  CHECK(desk.folder.read("again.exr") == desk.folder.read("64.exr"));
}

TEST_CASE("rtlang render: an exr of path mode says how it was made") {
  const Desk desk(lit_scene);
  REQUIRE(desk.run({"scene.rtl", "--seed", "3", "-o", "a.exr"}).exit_code == 0);
  const Image image = desk.image("a.exr");
  CHECK(image.text.at("mode") == "path");
  CHECK(image.text.at("seed") == "3");
  CHECK(image.text.at("samples") == "32");
  CHECK(image.text.size() == 6); // with depthMetric, sceneHash and software
  CHECK(image.object_names.at(1) == "ball");
}

TEST_CASE("rtlang render: samples without finite light are counted, and their object is named") {
  const Desk desk("mode: path\nsize: [4, 4]\nsamples: 4\ncamera { at: [0, 0, 4] }\nbig = plane { y: -1 }\nbig\n"
                  "for x in [-1, 1] { light { at: [x, 3, 0], intensity: 1.7e308 } }\n");
  const Outcome run = desk.run({"scene.rtl", "-o", "a.png"});
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.errors, Contains("no finite light") && Contains("big (scene.rtl:5)"));
}
