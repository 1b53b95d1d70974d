#include "tests/tools/rtlang/desk.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <regex>

using namespace rt;
using namespace rt::tests;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;
using Names = std::vector<std::string>;
using nlohmann::json;

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

TEST_CASE("program: what was assumed is reported in a line each, unless quiet") {
  const Desk desk("sphere { }\n");
  const Outcome run = desk.run({"scene.rtl", "--size", "40x30"});
  CHECK(run.exit_code == 0);
  CHECK(std::regex_search(run.errors, std::regex("^note: .*camera.*\nnote: .*light.*\nscene\\.png: ")));
  CHECK(desk.run({"scene.rtl", "--size", "40x30", "-q"}).errors.empty());
}

TEST_CASE("program: a wrong scene ends with 1, reports all mistakes and writes nothing") {
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
    CHECK_THAT(run.errors, EndsWith("--help`.\n"));
    return run.errors.substr(0, run.errors.find('\n'));
  };
  CHECK(message({"scene.rtl", "--sise", "8x6"}) == "rtlang: unknown option `--sise`: did you mean `--size`?");
  CHECK(message({"scene.rtl", "--size", "8"}) == "rtlang: --size takes width and height, as in 800x600, not `8`");
  CHECK(message({"scene.rtl", "--size", "0x6"}) == "rtlang: --size takes whole numbers from 1 to 65536, not 0");
  CHECK(message({"scene.rtl", "--size"}) == "rtlang: --size takes a value: --size WxH");
  CHECK_THAT(message({"scene.rtl", "--samples", "3"}), StartsWith("rtlang: --samples cannot be 3: "));
  CHECK(message({"scene.rtl", "--mode", "radiosity"}) ==
        "rtlang: --mode takes one of whitted, path, occlusion, not `radiosity`");
  CHECK(message({"scene.rtl", "--time", "9s"}) ==
        "rtlang: --time cannot be used in whitted mode, which has a fixed number of samples");
  CHECK(message({"scene.rtl", "--mode", "path", "--time", "soon"}) ==
        "rtlang: --time takes a time, as in 90s, 5m or 1.5h, not `soon`");
  CHECK(message({"scene.rtl", "--max-depth", "-1"}) ==
        "rtlang: --max-depth takes whole numbers from 0 to 1000, not -1");
  CHECK(message({"scene.rtl", "--bits", "12"}) == "rtlang: --bits takes one of 8, 16, not `12`");
  CHECK(message({"scene.rtl", "--threads", "0"}) == "rtlang: --threads takes a whole number from 1 to 1024, not `0`");
  CHECK(message({"scene.rtl", "--crop", "1,2,3"}) ==
        "rtlang: --crop takes X0,Y0,X1,Y1, as in 0,0,400,300, not `1,2,3`");
  CHECK_THAT(message({"scene.rtl", "--crop", "0,0,41,30"}),
             StartsWith("rtlang: --crop 0,0,41,30 is not within the picture of 40x30"));
  CHECK_THAT(message({"scene.rtl", "--crop", "5,5,5,9"}), Contains("is not within"));
  CHECK(message({"scene.rtl", "-o", "a.jpg"}) ==
        "rtlang: `a.jpg` does not end in .png, .exr, .ppm or .pfm: choose one with --format");
  CHECK(message({"scene.rtl", "-o", "-", "-o", "-"}) == "rtlang: only one picture can go to standard output");
  CHECK_THAT(message({"scene.rtl", "-o", "-", "--stats", "json"}), Contains("--stats json writes to standard output"));
  CHECK(message({"scene.rtl", "other.rtl"}) == "rtlang: unexpected argument `other.rtl`");
  CHECK(message({"scnee", "scene.rtl"}) == "rtlang: unknown command `scnee`: did you mean `scene`?");
  CHECK(message({"explain", "E9999"}).starts_with("rtlang: there is no code `E9999`"));
  // The tests' standard input is a pipe, which may hold a scene.
  const std::string advice = ": a scene from standard input is called `-`, as in `rtlang - < scene.rtl`";
  CHECK(message({"-q"}) == "rtlang: SCENE is missing" + advice);
  CHECK(message({"diff", "a.png"}) == "rtlang: B is missing");
  CHECK(message({"diff"}) == "rtlang: A and B are missing");
  CHECK(message({"fmt"}) == "rtlang: FILES are missing");
  CHECK(message({"test"}) == "rtlang: SCENES are missing");
  CHECK(message({"why"}) == "rtlang: SCENE and --pixel X,Y are missing" + advice);
  CHECK(message({"probe", "--at", "1,2"}) == "rtlang: SCENE is missing" + advice);
  CHECK_THAT(message({"probe", "scene.rtl"}), StartsWith("rtlang: specify exactly one of --pixel X,Y, --at X,Y"));
  CHECK(message({"lint", "--strict"}) == "rtlang: SCENE is missing" + advice);
  for (const char* command : {"ast", "scene", "export", "check"})
    CHECK(message({command}) == "rtlang: SCENE is missing" + advice);
  CHECK(desk.folder.names() == Names{"scene.rtl"});
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

TEST_CASE("program: what is piped in without a word is not guessed at") {
  Desk desk;
  desk.options.input = "sphere {}\n";
  const Outcome run = desk.run({});
  CHECK(run.exit_code == 2);
  CHECK(run.output.empty());
  CHECK_THAT(run.errors, StartsWith("rtlang: what is on standard input? A scene is `rtlang -`, "));
}

TEST_CASE("program: doc knows properties by their names, and can list all names") {
  const Desk desk;
  CHECK_THAT(desk.run({"doc", "tone"}).output, StartsWith("scene.tone: clip or filmic (clip)  "));
  CHECK_THAT(desk.run({"doc", "light.radius"}).output, StartsWith("light.radius: number (0)  "));
  CHECK(desk.run({"doc", "tomato"}).output == "tomato: the colour #ff6347\n");
  CHECK_THAT(desk.run({"doc", "--names"}).output, Contains("\nradius\n") && Contains("\nsphere\n"));
  CHECK_THAT(desk.run({"doc", "radios"}).errors, Contains("did you mean `radius`?"));
}
