// Where a picture goes: files, pipes, devices and terminals; and what is said when there is no picture.

#include "renderer/image/image.hpp"
#include "tests/paths.hpp"
#include "tests/support/program.hpp"
#include "tests/support/pty.hpp"

#include <catch2/catch.hpp>

#include <csignal>

using namespace rt;
using namespace rt::tests;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// A folder with a scene and a shell in it.
struct Desk {
  TestFolder folder;
  RunOptions options;
  Desk() {
    folder.write("scene.rtl", "size: [8, 6]\nball = sphere {}\nball\n");
    options.folder = folder.path();
  }
  Outcome run(const std::vector<std::string>& arguments) const { return rtlang(arguments, options); }
  Outcome shell(const std::string& command) const {
    return run_program("/bin/bash", {"--norc", "-c", "rtlang() { " RTLANG_BINARY " \"$@\"; }; " + command}, options);
  }
};

} // namespace

TEST_CASE("outputs: devices, descriptors, pipes and fifos are written straight") {
  const Desk desk;
  const std::string png = desk.run({"scene.rtl", "-q", "-o", "-"}).output;
  REQUIRE_THAT(png, StartsWith("\x89PNG"));
  CHECK(desk.shell("rtlang scene.rtl -q -o /dev/stdout").output == png);
  CHECK(desk.shell("rtlang scene.rtl -q -o /dev/stdout | cat").output == png);
  CHECK(desk.shell("rtlang scene.rtl -q -o /dev/fd/3 3>&1").output == png);
  CHECK(desk.shell("rtlang scene.rtl -q -o >(cat); wait; sleep 0.2").output == png);
  CHECK(desk.shell("mkfifo pipe; cat pipe & rtlang scene.rtl -q -o pipe; wait").output == png);
  CHECK(desk.shell("rtlang scene.rtl -q -o /dev/null").exit_code == 0);
  CHECK(desk.shell("rtlang scene.rtl -q -o /dev/stdout > out.png; cat out.png").output == png);
  CHECK(desk.shell("{ echo first; rtlang scene.rtl -q -o /dev/stdout; } > both; cat both").output == "first\n" + png);
}

TEST_CASE("outputs: no picture is poured on a terminal") {
  const Desk desk;
  for (const char* output : {"-", "/dev/stdout", "/dev/tty"}) {
    INFO(output);
    Pty terminal({RTLANG_BINARY, desk.folder / "scene.rtl", "-o", output}, {});
    CHECK(terminal.wait_for_end() == 2);
    CHECK_THAT(terminal.screen().text(), Contains("a terminal cannot show a picture file: say -o FILE"));
  }
}

TEST_CASE("outputs: a scene that is piped in has to be named, and the error says how") {
  const Desk desk;
  const Outcome run = desk.shell("rtlang -o out.png < scene.rtl");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.errors, StartsWith("rtlang: SCENE is missing: a scene from standard input is called `-`, as in "
                                    "`rtlang - < scene.rtl`\n"));
  CHECK(desk.shell("rtlang - -q -o out.png < scene.rtl").exit_code == 0);
}

TEST_CASE("outputs: a scene in which nothing is placed makes no picture") {
  const Desk desk;
  for (const char* text :
       {"", "// only words\n", "background: red\n", "ball = sphere {}\n", "sphere { visible: false }"}) {
    INFO(text);
    desk.folder.write("empty.rtl", text);
    const Outcome run = desk.run({"empty.rtl", "-q", "-o", "empty.png"});
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.errors, StartsWith("error[E0411]: there is nothing to see in this scene\n"));
    CHECK(desk.folder.read("empty.png").empty());
  }
}

TEST_CASE("outputs: -D of a param that is not there points at its name and lists those that are") {
  const Desk desk;
  desk.folder.write("tall.rtl", "param height = 2\nparam steps = 3\nbox { size: [1, height, steps] }\n");
  const Outcome run = desk.run({"tall.rtl", "-D", "hight=4"});
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.errors,
             Contains("1 | -D hight=4\n  |    ^^^^^ did you mean `height`?\n  = note: it has height, steps\n"));
}

TEST_CASE("outputs: a crop in an exr knows its place") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl", "-q", "--crop", "2,1,5,4", "-o", "crop.exr", "-o", "crop.png"}).exit_code == 0);
  const Image crop = read_image(desk.folder / "crop.exr");
  CHECK(crop.width == 3);
  CHECK(crop.left == 2);
  CHECK(crop.top == 1);
  CHECK(crop.picture_width == 8);
  CHECK(crop.picture_height == 6);
}

TEST_CASE("outputs: an exr says what its objects are called") {
  const Desk desk;
  REQUIRE(desk.run({"scene.rtl", "-q", "-o", "out.exr"}).exit_code == 0);
  CHECK_THAT(desk.folder.read("out.exr"), Contains("{\"ball\":\""));
}

TEST_CASE("outputs: a picture that memory cannot hold is told with its size") {
  const Desk desk;
  const Outcome run = desk.shell("ulimit -v 3000000; rtlang scene.rtl --size 60000x60000 -q -o out.png");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.errors, StartsWith("rtlang: there is not enough memory: a picture of 60000×60000 pixels takes 43"));
}

TEST_CASE("outputs: what a scene prints goes to standard error, with its place") {
  const Desk desk;
  desk.folder.write("loud.rtl", "size: [8, 6]\nfor i in 0..1 { print(\"turn\", i) }\nsphere {}\n");
  const Outcome run = desk.run({"loud.rtl", "-q", "-o", "-"});
  CHECK(run.errors == "loud.rtl:2:17: turn 0\nloud.rtl:2:17: turn 1\n");
  CHECK_THAT(run.output, StartsWith("\x89PNG"));
}

TEST_CASE("outputs: a large picture can be given up at once") {
  Desk desk;
  desk.options.signal = SIGINT;
  desk.options.signal_delay = std::chrono::milliseconds(300);
  const Outcome run = desk.run({"scene.rtl", "--size", "12000x12000", "-q", "-o", "out.png"});
  CHECK(run.exit_code == 130);
  CHECK(run.since_signal < std::chrono::milliseconds(1500));
  CHECK(desk.folder.read("out.png").empty());
}
