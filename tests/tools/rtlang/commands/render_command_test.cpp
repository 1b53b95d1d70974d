#include "tests/tools/rtlang/desk.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <csignal>
#include <regex>

using namespace rt;
using namespace rt::tests;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using Names = std::vector<std::string>;
using nlohmann::json;

namespace {

bool same(const Rgb32& a, const Rgb32& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

} // namespace

TEST_CASE("rtlang render: without -o the picture is a png with the scene's name in the current folder") {
  const Desk desk;
  const Outcome run = desk.run({"scene.rtl"});
  CHECK(run.exit_code == 0);
  CHECK(run.output.empty());
  CHECK(desk.folder.names() == Names{"scene.png", "scene.rtl"});
  const Image image = desk.image("scene.png");
  CHECK(image.width == 40);
  CHECK(image.height == 30);
  CHECK(image.bits == 8);
  CHECK(std::regex_match(run.errors, std::regex("scene\\.png: 40×30, 2 primitives, [0-9.]+ k rays in [^\n]*\n")));
  CHECK(desk.run({"render", "scene.rtl", "-o", "other.png"}).exit_code == 0);
  CHECK(desk.folder.read("other.png") == desk.folder.read("scene.png"));
}

TEST_CASE("rtlang render: one run writes several pictures, each in the format that its name says") {
  const Desk desk;
  const Outcome run =
      desk.run({"scene.rtl", "-o", "a.png", "-o", "b.exr", "--output", "c.ppm", "--output=d.pfm", "--bits", "16"});
  REQUIRE(run.exit_code == 0);
  CHECK_THAT(run.errors, StartsWith("a.png, b.exr, c.ppm, d.pfm: "));
  const Image a = desk.image("a.png"), b = desk.image("b.exr"), c = desk.image("c.ppm"), d = desk.image("d.pfm");
  CHECK(a.bits == 16);
  CHECK(c.bits == 16);
  REQUIRE(b.has_layers());
  CHECK_FALSE(d.has_layers());
  for (std::size_t i = 0; i < b.color.size(); ++i) {
    CHECK(same(b.color[i], d.color[i]));
    CHECK(same(a.color[i], c.color[i]));
  }
  // In the middle the ray meets the ball (1) after √26 − 1, above it nothing.
  const std::size_t middle = b.index(20, 15);
  CHECK(b.object_id[middle] == 1);
  CHECK(b.depth[middle] == Approx(std::sqrt(26.0) - 1).epsilon(0.01));
  CHECK(b.object_id[b.index(0, 0)] == 0);
  CHECK(b.object_id[b.index(0, 29)] == 2);
}

TEST_CASE("rtlang render: a png carries the program's version and the scene's hash, and no time") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl"}).exit_code == 0);
  const std::string png = desk.folder.read("scene.png");
  const std::string hash = desk.run({"scene", "--hash", "scene.rtl"}).output;
  REQUIRE(hash.size() == 17);
  CHECK_THAT(png, Contains("tEXtSoftware") && Contains("tEXtScene-Hash" + std::string(1, '\0') + hash.substr(0, 16)) &&
                      !Contains("tIME"));
  CHECK(desk.run({"scene", "--hash", "scene.rtl", "-D", "radius=1.5"}).output != hash);
}

TEST_CASE("rtlang render: - is standard input and standard output") {
  Desk desk;
  desk.options.input = small_scene;
  const Outcome png = desk.run({"-", "-o", "-"});
  CHECK(png.exit_code == 0);
  CHECK(decode(png.output, "x").width == 40);
  CHECK_THAT(png.output, StartsWith("\x89PNG"));
  const Outcome pfm = desk.run({"-", "-o", "-", "--format", "pfm", "-q"});
  CHECK_THAT(pfm.output, StartsWith("PF\n40 30\n"));
  CHECK(pfm.errors.empty());
  CHECK(desk.folder.names() == Names{"scene.rtl"});
  const Outcome nameless = desk.run({"-"});
  CHECK(nameless.exit_code == 2);
  CHECK_THAT(nameless.errors, Contains("needs -o FILE"));
}

TEST_CASE("rtlang render: size, samples, depth and crop") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl", "--size", "80x60", "-o", "large.pfm"}).exit_code == 0);
  REQUIRE(desk.run({"scene.rtl", "--samples", "4", "-o", "fine.pfm"}).exit_code == 0);
  REQUIRE(desk.run({"scene.rtl", "--size", "80x60", "--crop", "10,20,30,50", "-o", "part.pfm"}).exit_code == 0);
  REQUIRE(desk.run({"scene.rtl", "--max-depth", "0", "-o", "flat.pfm"}).exit_code == 0);
  const Image large = desk.image("large.pfm"), fine = desk.image("fine.pfm"), part = desk.image("part.pfm");
  CHECK(large.width == 80);
  CHECK(part.width == 20);
  CHECK(part.height == 30);
  bool is_that_part = true;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 20; ++x)
      is_that_part &= same(part.color[part.index(x, y)], large.color[large.index(x + 10, y + 20)]);
  CHECK(is_that_part);
  // Four rays for each pixel are the rays of a picture twice as large, averaged.
  double greatest = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      float sum = 0;
      for (const int i : {0, 1, 2, 3}) sum += large.color[large.index(2 * x + i % 2, 2 * y + i / 2)].g;
      greatest = std::max(greatest, std::abs(static_cast<double>(sum / 4 - fine.color[fine.index(x, y)].g)));
    }
  }
  CHECK(greatest < 1e-6);
  CHECK(desk.folder.read("flat.pfm") != desk.folder.read("fine.pfm"));
}

TEST_CASE("rtlang render: the picture is the same bytes for any number of threads") {
  const Desk desk;
  for (const char* threads : {"1", "2", "7"})
    REQUIRE(desk.run({"scene.rtl", "--size", "160x120", "--threads", threads, "-o", std::string(threads) + ".exr"})
                .exit_code == 0);
  CHECK(desk.folder.read("1.exr") == desk.folder.read("2.exr"));
  CHECK(desk.folder.read("1.exr") == desk.folder.read("7.exr"));
}

TEST_CASE("rtlang render: --format serves names that say nothing") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl", "-o", "picture", "--format", "ppm"}).exit_code == 0);
  CHECK_THAT(desk.folder.read("picture"), StartsWith("P6\n"));
}

TEST_CASE("rtlang render: a full disk leaves the old picture and nothing else") {
  Desk desk;
  desk.folder.write("a.pfm", "old");
  desk.options.greatest_file = 1000; // the picture takes 40·30·12 bytes
  const Outcome run = desk.run({"scene.rtl", "-q", "-o", "a.pfm"});
  CHECK(run.exit_code == 3);
  CHECK(run.errors == "rtlang: cannot write `a.pfm`: File too large\n");
  CHECK(desk.folder.read("a.pfm") == "old");
  CHECK(desk.folder.names() == Names{"a.pfm", "scene.rtl"});
}

TEST_CASE("rtlang render: a folder or a picture that may not be written is reported before rendering") {
  Desk desk;
  desk.folder.write("a.png", "old");
  std::filesystem::permissions(desk.folder.path(), std::filesystem::perms(0755));
  std::filesystem::permissions(desk.folder / "a.png", std::filesystem::perms(0444));
  desk.options.as_nobody = true;
  desk.options.input = small_scene;
  const bool is_root = std::filesystem::status("/root").permissions() != std::filesystem::perms::none;
  if (!is_root) std::filesystem::permissions(desk.folder.path(), std::filesystem::perms(0555));
  const Outcome folder = desk.run({"-", "-o", "b.png"}), picture = desk.run({"-", "-o", "a.png"});
  CHECK(folder.exit_code == 3);
  CHECK(folder.errors == "rtlang: cannot write `b.png`: Permission denied\n");
  CHECK(picture.exit_code == 3);
  CHECK(picture.errors == "rtlang: cannot write `a.png`: Permission denied\n");
  std::filesystem::permissions(desk.folder.path(), std::filesystem::perms(0755));
  CHECK(desk.folder.read("a.png") == "old");
}

TEST_CASE("rtlang render: statistics as a table or as JSON") {
  const Desk desk;
  const Outcome table = desk.run({"--stats", "scene.rtl"});
  CHECK_THAT(table.errors,
             Contains("\npicture     40×30, 1 sample per pixel: scene.png\n") && Contains("\nmemory      "));
  CHECK(table.output.empty());
  for (const auto& arguments : {Names{"scene.rtl", "--stats", "json"}, Names{"--stats=json", "scene.rtl", "-q"}}) {
    const json j = json::parse(desk.run(arguments).output);
    CHECK(j["width"] == 40);
    CHECK(j["outputs"] == json({"scene.png"}));
    CHECK(j["primitives"] == 2);
    CHECK(j["rays"]["camera"] == 1200);
    CHECK(j["rays"]["total"] == j["rays"]["camera"].get<int>() + j["rays"]["shadow"].get<int>() +
                                    j["rays"]["reflected"].get<int>() + j["rays"]["refracted"].get<int>());
    CHECK(j["is_complete"] == true);
    CHECK(j["seconds"]["total"].get<double>() > 0);
    CHECK(j["peak_memory_bytes"].get<double>() > 1e6);
  }
}

TEST_CASE("rtlang render: Ctrl-C stops within a second and leaves nothing") {
  Desk desk;
  desk.options.signal = SIGINT;
  SECTION("while rendering") {
    desk.options.signal_delay = std::chrono::milliseconds(300);
    const Outcome run = desk.run({"scene.rtl", "--size", "4000x4000", "--samples", "400"});
    CHECK(run.exit_code == 130);
    CHECK(run.since_signal < std::chrono::seconds(1));
    CHECK(desk.folder.names() == Names{"scene.rtl"});
  }
  SECTION("while rendering, and what there is is wanted") {
    desk.options.signal_delay = std::chrono::milliseconds(300);
    const Outcome run =
        desk.run({"scene.rtl", "--size", "800x600", "--samples", "62500", "--keep-partial", "-o", "a.png"});
    CHECK(run.exit_code == 130);
    CHECK(run.since_signal < std::chrono::seconds(1));
    CHECK(desk.image("a.png").width == 800);
    CHECK_THAT(run.errors, StartsWith("a.png: 800×600, incomplete, ") && EndsWith("\nrtlang: stopped\n"));
  }
  SECTION("while the tree of a large scene is built") {
    desk.folder.write(
        "scene.rtl",
        "for i in 0..<1e6 { sphere { at: [random(i), random(i, 1), random(i, 2)] * 100, radius: 0.1 } }\n");
    desk.options.signal_after = "no light given"; // said when it is loaded
    const Outcome run = desk.run({"scene.rtl", "-o", "a.png"});
    CHECK(run.exit_code == 130);
    CHECK(run.since_signal < std::chrono::seconds(1));
    CHECK(desk.folder.names() == Names{"scene.rtl"});
  }
  SECTION("while loading") {
    desk.folder.write("scene.rtl",
                      "x = sum([i * j for i in 0..100000 for j in 0..100000])\nsphere { at: [x, 0, 0] }\n");
    desk.options.signal_delay = std::chrono::milliseconds(300);
    const Outcome run = desk.run({"scene.rtl", "--keep-partial", "--max-steps", "1T"});
    CHECK(run.exit_code == 130);
    CHECK(run.since_signal < std::chrono::seconds(1));
    CHECK(run.errors == "rtlang: stopped\n");
    CHECK(desk.folder.names() == Names{"scene.rtl"});
  }
  SECTION("or SIGTERM does, with its own number") {
    desk.options.signal = SIGTERM;
    CHECK(desk.run({"scene.rtl", "--size", "4000x4000", "--samples", "400"}).exit_code == 143);
  }
}

TEST_CASE("rtlang render: a progress bar is shown on a terminal and taken away at the end") {
  Desk desk;
  desk.options.error_is_terminal = true;
  desk.options.signal = SIGINT;
  desk.options.signal_after = "left";
  const Outcome run = desk.run({"scene.rtl", "--size", "4000x4000", "--samples", "100"});
  CHECK(run.exit_code == 130);
  CHECK(std::regex_search(
      run.errors, std::regex("^\r\\[[#.]{30}\\] +[0-9]+ %  [0-9.]+ [kM] rays/s  [0-9:]+ (s|min|h) left\x1b\\[K")));
  CHECK_THAT(run.errors, EndsWith("\r\x1b[Krtlang: stopped\r\n"));
}

TEST_CASE("rtlang render: without a terminal there is no progress bar") {
  const Desk desk;
  CHECK_THAT(desk.run({"scene.rtl", "--size", "400x300", "--samples", "9"}).errors,
             !Contains("\r") && StartsWith("scene.png: "));
}
