// The real program, end to end: what it prints, what it writes, and what it ends with.

#include "renderer/image/image.hpp"
#include "tests/support/program.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <csignal>
#include <regex>
#include <sstream>

using namespace rt;
using namespace rt::tests;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using Names = std::vector<std::string>;
using nlohmann::json;

namespace {

/// Small, and written in full, so that nothing is assumed.
constexpr const char* small_scene = R"(
param radius = 1
size: [40, 30]
background: #9cc4e8
camera { at: [0, 1, 5], look_at: [0, 0, 0] }
sun { direction: [-1, -2, -1] }
sphere { radius: radius, material: material { color: tomato, reflect: 0.3 } }
plane { y: -1, material: checker { a: white, b: #333 } }
)";

/// A folder with a scene in it, in which rtlang runs.
struct Desk {
  TestFolder folder;
  RunOptions options;
  explicit Desk(const std::string& scene = small_scene) {
    folder.write("scene.rtl", scene);
    options.folder = folder.path();
  }
  Outcome run(const std::vector<std::string>& arguments) const { return rtlang(arguments, options); }
  Image image(const std::string& name) const { return read_image(folder / name); }
};

bool same(const Rgb32& a, const Rgb32& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

} // namespace

TEST_CASE("program: without -o the picture is a png with the scene's name in the current folder") {
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

TEST_CASE("program: one run writes several pictures, each in the format that its name says") {
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

TEST_CASE("program: a png carries the program's version and the scene's hash, and no time") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl"}).exit_code == 0);
  const std::string png = desk.folder.read("scene.png");
  const std::string hash = desk.run({"scene", "--hash", "scene.rtl"}).output;
  REQUIRE(hash.size() == 17);
  CHECK_THAT(png, Contains("tEXtSoftware") && Contains("tEXtScene-Hash" + std::string(1, '\0') + hash.substr(0, 16)) &&
                      !Contains("tIME"));
  CHECK(desk.run({"scene", "--hash", "scene.rtl", "-D", "radius=1.5"}).output != hash);
}

TEST_CASE("program: - is standard input and standard output") {
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
  CHECK_THAT(nameless.errors, Contains("say -o FILE"));
}

TEST_CASE("program: size, samples, depth and crop") {
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

TEST_CASE("program: the picture is the same bytes for any number of threads") {
  const Desk desk;
  for (const char* threads : {"1", "2", "7"})
    REQUIRE(desk.run({"scene.rtl", "--size", "160x120", "--threads", threads, "-o", std::string(threads) + ".exr"})
                .exit_code == 0);
  CHECK(desk.folder.read("1.exr") == desk.folder.read("2.exr"));
  CHECK(desk.folder.read("1.exr") == desk.folder.read("7.exr"));
}

TEST_CASE("program: -D sets a param, and what it sets is checked") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl", "-D", "radius=2", "-o", "two.exr"}).exit_code == 0);
  REQUIRE(desk.run({"scene.rtl", "-Dradius=1 + 1", "-o", "sum.exr"}).exit_code == 0);
  CHECK(desk.folder.read("two.exr") != "");
  CHECK(desk.image("two.exr").depth == desk.image("sum.exr").depth);
  CHECK(desk.run({"scene.rtl", "-D", "radios=2"}).exit_code == 1);
  CHECK(desk.run({"scene.rtl", "-D", "radius=-2"}).exit_code == 1);
  const Outcome no_value = desk.run({"scene.rtl", "-D", "radius"});
  CHECK(no_value.exit_code == 2);
  CHECK_THAT(no_value.errors, Contains("-D takes NAME=VALUE, as in -D width=3, not `radius`"));
}

TEST_CASE("program: what was assumed is told in a line each, unless quiet") {
  const Desk desk("sphere { }\n");
  const Outcome told = desk.run({"scene.rtl", "--size", "40x30"});
  CHECK(told.exit_code == 0);
  CHECK(std::regex_search(told.errors, std::regex("^note: .*camera.*\nnote: .*light.*\nscene\\.png: ")));
  CHECK(desk.run({"scene.rtl", "--size", "40x30", "-q"}).errors.empty());
}

TEST_CASE("program: a wrong scene ends with 1, tells all mistakes and writes nothing") {
  const Desk desk("sphere { raduis: 2 }\nbox { size: \"x\" }\n");
  const Outcome run = desk.run({"scene.rtl"});
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.errors, Contains("scene.rtl:1:10") && Contains("did you mean `radius`") && Contains("scene.rtl:2:"));
  CHECK_THAT(run.errors, !Contains("\x1b"));
  CHECK(desk.folder.names() == Names{"scene.rtl"});
  const json list = json::parse(desk.run({"scene.rtl", "--diagnostics", "json"}).errors);
  CHECK(list.size() == 2);
}

TEST_CASE("program: diagnostics as JSON are one array, also when all is fine") {
  const Desk desk;
  const Outcome run = desk.run({"scene.rtl", "--diagnostics", "json"});
  CHECK(run.exit_code == 0);
  CHECK(json::parse(run.errors) == json::array());
}

TEST_CASE("program: mistakes have colours on a terminal, unless NO_COLOR is set") {
  Desk desk("sphere { raduis: 2 }\n");
  desk.options.error_is_terminal = true;
  CHECK_THAT(desk.run({"scene.rtl"}).errors, Contains("\x1b["));
  desk.options.environment = {"NO_COLOR=1"};
  CHECK_THAT(desk.run({"scene.rtl"}).errors, !Contains("\x1b["));
  desk.options.environment = {"TERM=dumb"};
  CHECK_THAT(desk.run({"scene.rtl"}).errors, !Contains("\x1b["));
}

TEST_CASE("program: limits are diagnostics") {
  const Desk steps("x = sum([i for i in 0..100000])\nsphere { at: [x, 0, 0] }\n");
  CHECK(steps.run({"scene.rtl", "--size", "8x6"}).exit_code == 0);
  CHECK(steps.run({"scene.rtl", "--size", "8x6", "--max-steps", "1k"}).exit_code == 1);
  const Desk recursion("fn f(n) = if n == 0 { 0 } else { f(n - 1) }\nsphere { at: [f(200), 0, 0] }\n");
  CHECK(recursion.run({"scene.rtl", "--size", "8x6"}).exit_code == 0);
  CHECK(recursion.run({"scene.rtl", "--size", "8x6", "--max-recursion", "100"}).exit_code == 1);
  const Desk objects("for i in 1..1000 { sphere { at: [i, 0, 0] } }\n");
  CHECK(objects.run({"scene.rtl", "--size", "8x6"}).exit_code == 0);
  CHECK(objects.run({"scene.rtl", "--size", "8x6", "--max-objects", "999"}).exit_code == 1);
  const Desk memory("for i in 1..100000 { sphere { at: [i, 0, 0] } }\n");
  CHECK(memory.run({"scene.rtl", "--size", "8x6"}).exit_code == 0);
  CHECK(memory.run({"scene.rtl", "--size", "8x6", "--max-memory", "1M"}).exit_code == 1);
  CHECK(memory.run({"scene.rtl", "--max-memory", "much"}).exit_code == 2);
}

TEST_CASE("program: includes stay in the scene's folder unless a root is given") {
  const TestFolder elsewhere;
  elsewhere.write("part.rtl", "sphere { }\n");
  const Desk desk("include \"" + (elsewhere / "part.rtl") + "\"\n");
  CHECK(desk.run({"scene.rtl", "--size", "8x6"}).exit_code == 1);
  CHECK(desk.run({"scene.rtl", "--size", "8x6", "--include-root", elsewhere.path().string()}).exit_code == 0);
}

TEST_CASE("program: the command line's mistakes end with 2 and say what would do") {
  const Desk desk;
  const auto message = [&](const std::vector<std::string>& arguments) {
    const Outcome run = desk.run(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.output.empty());
    CHECK_THAT(run.errors, EndsWith("--help` tells what can be said.\n"));
    return run.errors.substr(0, run.errors.find('\n'));
  };
  CHECK(message({"scene.rtl", "--sise", "8x6"}) == "rtlang: there is no option `--sise`: did you mean `--size`?");
  CHECK(message({"scene.rtl", "--size", "8"}) == "rtlang: --size takes width and height, as in 800x600, not `8`");
  CHECK(message({"scene.rtl", "--size", "0x6"}) == "rtlang: --size takes whole numbers from 1 to 65536, not 0");
  CHECK(message({"scene.rtl", "--size"}) == "rtlang: --size takes a value: --size WxH");
  CHECK_THAT(message({"scene.rtl", "--samples", "3"}), StartsWith("rtlang: --samples cannot be 3: "));
  CHECK(message({"scene.rtl", "--max-depth", "-1"}) ==
        "rtlang: --max-depth takes whole numbers from 0 to 1000, not -1");
  CHECK(message({"scene.rtl", "--bits", "12"}) == "rtlang: --bits takes one of 8, 16, not `12`");
  CHECK(message({"scene.rtl", "--threads", "0"}) == "rtlang: --threads takes a whole number from 1 to 1024, not `0`");
  CHECK(message({"scene.rtl", "--crop", "1,2,3"}) ==
        "rtlang: --crop takes X0,Y0,X1,Y1, as in 0,0,400,300, not `1,2,3`");
  CHECK_THAT(message({"scene.rtl", "--crop", "0,0,41,30"}),
             StartsWith("rtlang: --crop 0,0,41,30 is no part of a picture of 40x30"));
  CHECK_THAT(message({"scene.rtl", "--crop", "5,5,5,9"}), Contains("is no part"));
  CHECK(message({"scene.rtl", "-o", "a.jpg"}) ==
        "rtlang: `a.jpg` does not end in .png, .exr, .ppm or .pfm: say which with --format");
  CHECK(message({"scene.rtl", "-o", "-", "-o", "-"}) == "rtlang: standard output takes one picture only");
  CHECK_THAT(message({"scene.rtl", "-o", "-", "--stats", "json"}), Contains("--stats json goes to standard output"));
  CHECK(message({"scene.rtl", "other.rtl"}) == "rtlang: `other.rtl` is one argument too many");
  CHECK(message({"scnee", "scene.rtl"}) == "rtlang: there is no command `scnee`: did you mean `scene`?");
  CHECK(message({"explain", "E9999"}).starts_with("rtlang: there is no code `E9999`"));
  CHECK(message({"-q"}) == "rtlang: SCENE is required");
  CHECK(desk.folder.names() == Names{"scene.rtl"});
}

TEST_CASE("program: --format serves names that say nothing") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl", "-o", "picture", "--format", "ppm"}).exit_code == 0);
  CHECK_THAT(desk.folder.read("picture"), StartsWith("P6\n"));
}

TEST_CASE("program: what cannot be read or written ends with 3 and is named") {
  const Desk desk;
  const auto message = [&](const std::vector<std::string>& arguments) {
    const Outcome run = desk.run(arguments);
    CHECK(run.exit_code == 3);
    return run.errors;
  };
  CHECK(message({"no.rtl"}) == "rtlang: cannot read `no.rtl`: No such file or directory\n");
  CHECK(message({"."}) == "rtlang: cannot read `.`: Is a directory\n");
  CHECK(message({"scene.rtl", "-o", "no/a.png"}) == "rtlang: cannot write `no/a.png`: No such file or directory\n");
  CHECK_THAT(message({"scene.rtl", "-q", "-o", "/dev/full"}),
             Contains("cannot write `/dev/full`: No space left on device"));
  CHECK(desk.folder.names() == Names{"scene.rtl"});
}

TEST_CASE("program: a full disk leaves the old picture and nothing else") {
  Desk desk;
  desk.folder.write("a.pfm", "old");
  desk.options.greatest_file = 1000; // the picture takes 40·30·12 bytes
  const Outcome run = desk.run({"scene.rtl", "-q", "-o", "a.pfm"});
  CHECK(run.exit_code == 3);
  CHECK(run.errors == "rtlang: cannot write `a.pfm`: File too large\n");
  CHECK(desk.folder.read("a.pfm") == "old");
  CHECK(desk.folder.names() == Names{"a.pfm", "scene.rtl"});
}

TEST_CASE("program: a folder or a picture that may not be written is told before rendering") {
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

TEST_CASE("program: a reader that has enough is no error to talk about") {
  Desk desk;
  desk.options.closes_output = true;
  for (const char* command : {"render", "scene", "ast"}) {
    std::vector<std::string> arguments{command, "scene.rtl"};
    if (arguments[0] == "render") arguments.insert(arguments.end(), {"-o", "-"});
    const Outcome run = desk.run(arguments);
    CHECK(run.exit_code == 141);
    CHECK(run.errors.empty());
  }
}

TEST_CASE("program: statistics as a table or as JSON") {
  const Desk desk;
  const Outcome table = desk.run({"--stats", "scene.rtl"});
  CHECK_THAT(table.errors,
             Contains("\npicture     40×30, 1 sample a pixel: scene.png\n") && Contains("\nmemory      "));
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

TEST_CASE("program: Ctrl-C stops within a second and leaves nothing") {
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
    CHECK_THAT(run.errors, StartsWith("a.png: 800×600, stopped before it was whole, "));
  }
  SECTION("while the tree of a large scene is built") {
    desk.folder.write(
        "scene.rtl",
        "for i in 0..<1e6 { sphere { at: [random(i), random(i, 1), random(i, 2)] * 100, radius: 0.1 } }\n");
    desk.options.signal_after = "there is no light"; // said when it is loaded
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
    CHECK(run.errors.empty());
    CHECK(desk.folder.names() == Names{"scene.rtl"});
  }
  SECTION("or SIGTERM does, with its own number") {
    desk.options.signal = SIGTERM;
    CHECK(desk.run({"scene.rtl", "--size", "4000x4000", "--samples", "400"}).exit_code == 143);
  }
}

TEST_CASE("program: a progress bar is shown on a terminal and taken away at the end") {
  Desk desk;
  desk.options.error_is_terminal = true;
  desk.options.signal = SIGINT;
  desk.options.signal_after = "left";
  const Outcome run = desk.run({"scene.rtl", "--size", "4000x4000", "--samples", "100"});
  CHECK(run.exit_code == 130);
  CHECK(std::regex_search(
      run.errors, std::regex("^\r\\[[#.]{30}\\] +[0-9]+ %  [0-9.]+ [kM] rays/s  [0-9:]+ (s|min|h) left\x1b\\[K")));
  CHECK_THAT(run.errors, EndsWith("\r\x1b[K"));
}

TEST_CASE("program: without a terminal there is no progress bar") {
  const Desk desk;
  CHECK_THAT(desk.run({"scene.rtl", "--size", "400x300", "--samples", "9"}).errors,
             !Contains("\r") && StartsWith("scene.png: "));
}

TEST_CASE("program: ast shows the tree, also of a text that is wrong") {
  const Desk desk;
  const Outcome good = desk.run({"ast", "scene.rtl"});
  CHECK(good.exit_code == 0);
  CHECK_THAT(good.output, Contains("sphere"));
  desk.folder.write("scene.rtl", "sphere { radius 1 }\nbox { }\n");
  const Outcome bad = desk.run({"ast", "scene.rtl"});
  CHECK(bad.exit_code == 1);
  CHECK_THAT(bad.output, Contains("error") && Contains("box"));
  CHECK_THAT(bad.errors, Contains("scene.rtl:1:17"));
}

TEST_CASE("program: scene prints the description as JSON, with the command line's overrides") {
  const Desk desk;
  const Outcome run = desk.run({"scene", "scene.rtl", "--size", "8x6", "-D", "radius=0.1"});
  CHECK(run.exit_code == 0);
  const json j = json::parse(run.output);
  CHECK(j["size"] == json({8, 6}));
  CHECK(j["objects"].size() == 2);
  CHECK(j["objects"][0]["radius"] == 0.1);
  CHECK(j["objects"][0]["file"] == "scene.rtl");
  CHECK(j["objects"][0]["line"] == 7);
  CHECK(j["camera"]["at"] == json({0, 1, 5}));
  CHECK(desk.run({"scene", "scene.rtl", "--size", "8x6", "-D", "radius=0.1"}).output == run.output);
}

TEST_CASE("program: explain knows every code") {
  const Outcome list = rtlang({"explain"});
  CHECK(list.exit_code == 0);
  std::istringstream lines(list.output);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    INFO(line);
    REQUIRE(std::regex_match(line, std::regex("[A-Z][0-9]{4}  .+")));
    if (count % 10 == 0) CHECK_THAT(rtlang({"explain", line.substr(0, 5)}).output, Contains(line.substr(0, 5)));
  }
  CHECK(count > 20);
  CHECK(rtlang({"explain", "e0204"}).exit_code == 0);
}
