#include "tests/tools/repl/terminal.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

// What stands on the screen while something is typed, at terminals of several kinds.
namespace {

namespace fs = std::filesystem;
using namespace rt::tests;
using std::chrono::seconds;

constexpr const char* kinds[] = {"xterm", "xterm-256color", "linux", "vt100", "tmux", "screen"};

TEST_CASE("repl at a terminal: a thing that is typed over several rows stands there once") {
  for (const char* kind : kinds) {
    INFO(kind);
    const Home home;
    Terminal terminal(home, {}, 80, 24, {{"TERM", kind}});
    terminal.type("group {", "rtl> group {");
    terminal.type("\r", "");
    terminal.type("sphere {", "  sphere {");
    terminal.type("\r", "");
    terminal.type("radius: 2", "    radius: 2");
    terminal.type("\r", "");
    terminal.type("}", "  }");
    CHECK(terminal.below_banner() == "rtl> group {\n  sphere {\n    radius: 2\n  }\n");
    terminal.type("\r", "");
    terminal.type("}", "}");
    CHECK(terminal.below_banner() == "rtl> group {\n  sphere {\n    radius: 2\n  }\n}\n");
    terminal.say("");
    CHECK(terminal.below_banner() == "rtl> group {\n  sphere {\n    radius: 2\n  }\n}\nplaced group\nrtl>\n");
    // The whole of it comes back, is edited in its middle, and stands there once again.
    terminal.send(arrow_up);
    REQUIRE(terminal.wait_for_cursor_row("}"));
    terminal.send(arrow_up);
    terminal.send(arrow_up);
    REQUIRE(terminal.wait_for_cursor_row("    radius: 2"));
    terminal.send("\x05" + std::string(1, '5')); // Ctrl-E
    CHECK(terminal.wait_for("}5"));
    CHECK(terminal.below_banner() == "rtl> group {\n  sphere {\n    radius: 2\n  }\n}\nplaced group\nrtl> group {\n  "
                                     "sphere {\n    radius: 2\n  }\n}5\n");
  }
}

TEST_CASE("repl at a terminal: rows that are longer than the screen is wide are drawn once, too") {
  const Home home;
  Terminal terminal(home, {}, 30, 24);
  const std::string banner = terminal.screen().text();
  terminal.send("box { size: [1, 2, 3], material: red, at: [1,");
  REQUIRE(terminal.wait_for_cursor_row("terial: red, at: [1,"));
  terminal.type("\r", "");
  terminal.type("2, 3]", "    2, 3]");
  terminal.type("\r", "");
  terminal.type("}", "}");
  CHECK_THAT(terminal.screen().text(),
             Catch::EndsWith("rtl> box { size: [1, 2, 3], ma\nterial: red, at: [1,\n    2, 3]\n}\n"));
}

TEST_CASE("repl at a terminal: what is typed over several rows is drawn once when the window changes its size") {
  const Home home;
  Terminal terminal(home, {}, 80, 24);
  terminal.type("box {", "rtl> box {");
  terminal.type("\r", "");
  terminal.signal(SIGWINCH);
  terminal.type("size: 2", "  size: 2");
  CHECK(terminal.below_banner() == "rtl> box {\n  size: 2\n");
}

TEST_CASE("repl at a terminal: what is pasted is shown, be it edited or too long for that") {
  const Home home;
  Terminal terminal(home, {}, 80, 12);
  terminal.send("\x1b[200~box {\r\tsize: 2\r}\r\x1b[201~");
  REQUIRE(terminal.wait_for_cursor_row("}"));
  CHECK(terminal.below_banner() == "rtl> box {\n  size: 2\n}\n");
  terminal.say("");
  CHECK(terminal.below_banner() == "rtl> box {\n  size: 2\n}\nplaced box\nrtl>\n");
  std::string lines;
  for (int i = 1; i <= 20; ++i) lines += "r" + std::to_string(i) + " = " + std::to_string(i) + "\r";
  terminal.send("\x1b[200~" + lines + "\x1b[201~");
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  CHECK(terminal.output().find("r1 = 1\r\nr2 = 2\r\n") != std::string::npos);
  CHECK(terminal.output().find("r20 = 20\r\n") != std::string::npos);
  CHECK(terminal.shows("r20 is 20"));
}

TEST_CASE("repl at a terminal: Tab lists what belongs to a block before functions, and the files to be included") {
  const Home home;
  std::ofstream(home.path / "shapes.rtl") << "crate = box {}\n";
  std::ofstream(home.path / "shapes.txt") << "no scene\n";
  fs::create_directory(home.path / "shared");
  std::ofstream(home.path / "scene.rtl") << "sphere {}\n";
  Terminal terminal(home, {home.file("scene.rtl")}, 100, 60);
  terminal.send("group { m\t");
  CHECK(terminal.shows("max")); // a function
  const std::string listed = terminal.screen().text();
  CHECK(listed.find("\nmaterial") < listed.find("max"));
  terminal.send(std::string(1, ctrl_c));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  // Files are sought where the scene is, not where the program was started.
  terminal.type("include \"sha\t", "rtl> include \"sha");
  CHECK(terminal.shows("shapes.rtl"));
  CHECK(terminal.shows("shared/"));
  CHECK(terminal.screen().text().find("shapes.txt") == std::string::npos);
  terminal.type("p\t", "rtl> include \"shapes.rtl");
  terminal.type("\"\r", prompt.data());
  terminal.say("crate");
  CHECK(terminal.shows("placed crate"));
}

TEST_CASE("repl at a terminal: all sessions that were not saved are offered, and any can be had") {
  const Home home;
  for (const char* thing : {"box {}", "sphere {}", "plane {}"}) {
    Terminal terminal(home);
    terminal.say(thing);
    terminal.signal(SIGKILL);
    terminal.wait_for_end();
  }
  Terminal terminal(home);
  CHECK(terminal.shows("3 sessions were not saved; :recover N restores one"));
  for (const char* thing : {"the last: box {}", "the last: sphere {}", "the last: plane {}"})
    CHECK(terminal.shows(thing));
  const std::string offered = terminal.screen().text();
  const char number = offered[offered.rfind('\n', offered.find("the last: box {}")) + 3];
  terminal.say(std::string(":recover ") + number);
  terminal.say(":list");
  CHECK(terminal.shows("1     box "));
  terminal.say(":recover 9");
  CHECK(terminal.shows("which one? `:recover 1` to `2`"));
}

TEST_CASE("repl at a terminal: one that cannot move its cursor has a prompt, and mistakes end nothing") {
  const Home home;
  Terminal terminal(home, {}, 80, 24, {{"TERM", "dumb"}});
  terminal.say("sphere { raduis: 2 }");
  CHECK(terminal.shows("did you mean `radius`?"));
  // What is typed before the prompt stands above it, since the terminal shows it by itself.
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  terminal.send("ball = sphere {\r");
  REQUIRE(terminal.wait_for_cursor_row("...>"));
  terminal.send("}\r");
  CHECK(terminal.shows("ball is a sphere"));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  terminal.send("box {\r");
  REQUIRE(terminal.wait_for_cursor_row("...>"));
  terminal.send(std::string(1, ctrl_c)); // takes it back
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  terminal.say("1 + 1");
  CHECK(terminal.shows("\n2\n"));
  CHECK(terminal.output().find('\x1b') == std::string::npos);
  terminal.send(std::string(1, ctrl_d));
  CHECK(terminal.wait_for_end() == 0);
}

TEST_CASE("repl at a terminal: :check shows that it waits for POV-Ray, progress that Ctrl-C ends") {
  const Home home;
  std::ofstream(home.path / "povray") << "#!/bin/sh\n[ \"$1\" = --version ] || exec sleep 60\n";
  fs::permissions(home.path / "povray", fs::perms::owner_all);
  Terminal terminal(home, {}, 80, 24, {{"PATH", home.path.string() + ":/usr/bin:/bin"}});
  terminal.say("sphere {}");
  terminal.send(":check --size 40x30\r");
  CHECK(terminal.wait_for("waiting for POV-Ray, 1 s"));
  terminal.send(std::string(1, ctrl_c));
  CHECK(terminal.shows("stopped"));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  CHECK(terminal.screen().text().find("waiting") == std::string::npos);
}

} // namespace
