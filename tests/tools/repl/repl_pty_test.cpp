#include "tests/paths.hpp"
#include "tests/tools/repl/terminal.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

// The real program at a terminal of its own, as a person would use it.
namespace {

namespace fs = std::filesystem;
using namespace rt::tests;
using std::chrono::milliseconds;
using std::chrono::seconds;

TEST_CASE("repl at a terminal: things are typed, values answered, and Ctrl-D ends it") {
  const Home home;
  Terminal terminal(home);
  CHECK(terminal.shows("rtlang "));
  terminal.say("sphere { radius: 2 }");
  terminal.say("1 + 2");
  CHECK(terminal.shows("\n3\n"));
  terminal.say(":list");
  CHECK(terminal.shows("sphere  around [0, 0, 0]"));
  terminal.send(std::string(1, ctrl_d));
  CHECK(terminal.wait_for_end() == 0);
}

// The session that the page records: what follows `rtl> ` is typed, the rest is what is seen.
TEST_CASE("repl at a terminal: the session in the README is what happens") {
  std::ifstream file(std::string(RTLANG_SOURCE_DIR) + "/README.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::size_t begin = page.find("```\nrtl> ") + 4;
  std::string recorded = page.substr(begin, page.find("```", begin) - begin);
  REQUIRE(recorded.size() > 500);
  // It saves its scene; not here.
  const Home home;
  const std::size_t saved = recorded.find("rtl> :save still\nsaved as still.rtl\n");
  REQUIRE(saved != std::string::npos);
  recorded.replace(saved, std::string::npos,
                   "rtl> :save " + home.file("still") + "\nsaved as " + home.file("still.rtl") + "\n");
  Terminal terminal(home, {}, 120, 60);
  std::istringstream lines(recorded);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("rtl> ")) terminal.say(line.substr(5));
  CHECK_THAT(terminal.screen().text(), Catch::Contains(recorded));
}

TEST_CASE("repl at a terminal: a mistake is shown with its place, and the session goes on") {
  const Home home;
  Terminal terminal(home);
  terminal.say("sphere { raduis: 2 }");
  CHECK(terminal.shows("did you mean `radius`?"));
  terminal.say(":lsit");
  CHECK(terminal.shows("did you mean `:list`?"));
  terminal.say(":s");
  CHECK(terminal.shows("`:s` could be :show, :set, :save"));
  terminal.send(":quit\r");
  CHECK(terminal.wait_for_end() == 0);
}

TEST_CASE("repl at a terminal: an open bracket goes on in the next line, set in") {
  const Home home;
  Terminal terminal(home);
  terminal.send("box {");
  REQUIRE(terminal.wait_for_cursor_row("rtl> box {"));
  // One key after the other, as a person types: what comes at once counts as pasted, and is not set in or out.
  const auto new_row = [&](int column) {
    terminal.send(std::string(1, enter));
    INFO(terminal.screen().text());
    REQUIRE(terminal.wait_for_cursor_row("", column));
  };
  new_row(2);
  terminal.type("size: [1,", "  size: [1,");
  new_row(4);
  terminal.type("2, 3]", "    2, 3]");
  new_row(2);
  terminal.type("}", "}");
  terminal.say("");
  terminal.say(":history");
  CHECK(terminal.shows("box { size: [1, 2, 3] }"));
  // The whole of it comes back, and can be edited.
  terminal.send(arrow_up);
  terminal.send(arrow_up);
  REQUIRE(terminal.wait_for_cursor_row("}"));
  terminal.send(".move(x: 1)");
  terminal.say("");
  terminal.say(":list");
  CHECK(terminal.shows("box   around [1, 0, 0]"));
}

TEST_CASE("repl at a terminal: a closing bracket goes back to where its block began") {
  const Home home;
  Terminal terminal(home);
  terminal.send("group {\r");
  REQUIRE(terminal.wait_for_cursor_row(""));
  terminal.type("box {", "  box {");
  terminal.send("\r");
  REQUIRE(terminal.wait_for_cursor_row(""));
  terminal.type("size: 1", "    size: 1");
  terminal.send("\r");
  REQUIRE(terminal.wait_for_cursor_row(""));
  terminal.type("}", "  }");
  terminal.send("\r");
  REQUIRE(terminal.wait_for_cursor_row(""));
  terminal.type("}", "}");
  CHECK(terminal.screen().cursor_x() == 1);
  terminal.say("");
  terminal.say(":history");
  CHECK(terminal.shows("group { box { size: 1 } }"));
}

TEST_CASE("repl at a terminal: words that are commands without their colon are answered as such") {
  const Home home;
  Terminal terminal(home);
  terminal.say("help");
  CHECK(terminal.shows("a command begins with a colon: `:help`"));
  terminal.say("exit");
  CHECK(terminal.shows("a command begins with a colon: `:quit`"));
  terminal.say("list = [1, 2]");
  terminal.say("list");
  CHECK(terminal.shows("\n[1, 2"));
}

TEST_CASE("repl at a terminal: the document is shown with the numbers that answers name") {
  const Home home;
  Terminal terminal(home);
  terminal.say("sphere{radius:2}");
  terminal.say(":text");
  CHECK(terminal.shows("   1  sphere { radius: 2 }"));
  terminal.say(":probe 400,300");
  CHECK(terminal.shows("sphere (session:1)"));
}

TEST_CASE("repl at a terminal: many lines can be pasted, marked as such or not") {
  const Home home;
  Terminal terminal(home);
  terminal.send("\x1b[200~for i in 0..2 {\n\tsphere { at: [i, 0, 0] }\n}\nbox {}\n\x1b[201~");
  REQUIRE(terminal.wait_for_cursor_row("box {}"));
  terminal.say("");
  terminal.say(":list");
  CHECK(terminal.shows("(and 2 more)"));
  terminal.say(":reset");
  terminal.send("group {\rsphere {}\r}\rr = 4\rr * 2\r");
  CHECK(terminal.shows("\n8\n"));
  std::string lines;
  for (int i = 0; i < 200; ++i) lines += "sphere { at: [" + std::to_string(i) + ", 0, 0] }\n";
  terminal.say("\x1b[200~" + lines + "\x1b[201~");
  terminal.say(":list");
  CHECK(terminal.shows("around [199, 0, 0]"));
}

TEST_CASE("repl at a terminal: Tab completes nouns, properties, names, commands, colours and files") {
  const Home home;
  Terminal terminal(home);
  terminal.type("tria\t", "rtl> triangle");
  terminal.send("\x15"); // Ctrl-U
  terminal.type("sphere", "rtl> sphere");
  terminal.type(" { rad\t", "rtl> sphere { radius");
  terminal.type(": 2, mat\t", "rtl> sphere { radius: 2, material");
  terminal.type(": corn\t", "rtl> sphere { radius: 2, material: corn");
  CHECK(terminal.shows("cornflowerblue"));
  CHECK(terminal.shows("cornsilk"));
  terminal.type("s\t", "rtl> sphere { radius: 2, material: cornsilk");
  terminal.type(" }", "rtl> sphere { radius: 2, material: cornsilk }");
  terminal.say("");
  terminal.say("bigball = sphere { radius: 5 }");
  terminal.type("bigb\t", "rtl> bigball");
  terminal.type(".mov\t", "rtl> bigball.move");
  terminal.send(std::string(1, ctrl_c));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  terminal.send(":his\t");
  REQUIRE(terminal.wait_for_cursor_row("rtl> :history"));
  terminal.send(std::string(1, ctrl_c));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  terminal.type(":set bigb\t", "rtl> :set bigball");
  terminal.type(".rad\t", "rtl> :set bigball.radius");
  terminal.send(std::string(1, ctrl_c));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  std::ofstream(home.path / "unusual_name.rtl") << "sphere {}\n";
  terminal.send(":load " + home.file("unus") + "\t");
  CHECK(terminal.shows("unusual_name.rtl"));
}

TEST_CASE("repl at a terminal: history outlives the program") {
  const Home home;
  {
    Terminal first(home);
    first.say("sphere {}");
    first.say("box {\rsize: 2\r}");
    first.signal(SIGKILL);
    CHECK(first.wait_for_end() == 128 + SIGKILL);
  }
  Terminal second(home);
  second.send(arrow_up);
  REQUIRE(second.wait_for_cursor_row("}"));
  CHECK(second.shows("rtl> box {"));
  second.send(std::string(1, ctrl_c));
  REQUIRE(second.wait_for_cursor_row(prompt));
  second.send("\x10\x10"); // twice Ctrl-P
  REQUIRE(second.wait_for_cursor_row("rtl> sphere {}"));
}

TEST_CASE("repl at a terminal: Ctrl-C clears the line") {
  const Home home;
  Terminal terminal(home);
  terminal.send("sphere { radius");
  REQUIRE(terminal.wait_for_cursor_row("rtl> sphere { radius"));
  terminal.send(std::string(1, ctrl_c));
  CHECK(terminal.shows("sphere { radius^C"));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  terminal.say(":history");
  CHECK_FALSE(terminal.wait_for("  1  ", milliseconds(100)));
}

TEST_CASE("repl at a terminal: Ctrl-C stops a picture, and the session lives on") {
  const Home home;
  Terminal terminal(home);
  terminal.say("m = material { reflect: 0.9 }");
  terminal.say("for i in 0..40 { sphere { at: [i % 7, i / 7, 0], radius: 0.6, material: m } }");
  terminal.send(":render " + home.file("big.png") + " --size 8000x8000 --samples 16\r");
  REQUIRE(terminal.shows("rays/s"));
  const auto start = std::chrono::steady_clock::now();
  terminal.send(std::string(1, ctrl_c));
  CHECK(terminal.shows("stopped; nothing was written"));
  CHECK(std::chrono::steady_clock::now() - start < seconds(2));
  CHECK_FALSE(fs::exists(home.path / "big.png"));
  terminal.say("1 + 1");
  CHECK(terminal.shows("\n2\n"));
}

TEST_CASE("repl at a terminal: a killed session is offered and recovered") {
  const Home home;
  {
    Terminal first(home);
    first.say("r = 2");
    first.say("ball = sphere {\rradius: r\r}");
    first.say("ball");
    first.say(".move(x: 3)");
    first.say("r = 4");
    first.say("box {}");
    first.say(":undo");
    first.signal(SIGKILL);
    first.wait_for_end();
  }
  Terminal second(home);
  CHECK(second.shows("was not saved (7 inputs): :recover restores it"));
  second.say(":recover");
  second.say(":list");
  CHECK(second.shows("ball  sphere  around [3, 0, 0]"));
  CHECK(second.screen().text().find("box ") == std::string::npos);
  second.say("r");
  CHECK(second.shows("\n4\n"));
  // It is this session's now: saved, nothing is left to be offered.
  second.say(":save " + home.file("saved"));
  second.send(":quit\r");
  CHECK(second.wait_for_end() == 0);
  CHECK(fs::exists(home.path / "saved.rtl"));
  Terminal third(home);
  CHECK(third.screen().text().find(":recover") == std::string::npos);
}

TEST_CASE("repl at a terminal: a session whose window was closed is offered, also after a save") {
  const Home home;
  {
    Terminal first(home);
    first.say("sphere {}");
    first.say(":save " + home.file("scene.rtl"));
    first.say("box {}");
    first.hang_up();
    first.wait_for_end();
  }
  Terminal second(home);
  second.say(":recover");
  second.say(":list");
  CHECK(second.shows("sphere"));
  CHECK(second.shows("box"));
}

TEST_CASE("repl at a terminal: pictures are shown, and previews follow changes") {
  const Home home;
  Terminal terminal(home);
  terminal.say("sphere { material: red }");
  terminal.say(":show");
  CHECK(terminal.shows("▄▄▄▄"));
  CHECK(terminal.output().find("\x1b[48;5;") != std::string::npos);
  terminal.say(":auto on");
  terminal.send("\x0c"); // clears the screen
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  CHECK(terminal.screen().text().find("▄▄▄▄") == std::string::npos);
  terminal.say("sphere { at: [1, 1, 0] }");
  CHECK(terminal.shows("▄▄▄▄"));
  REQUIRE(terminal.wait_for_cursor_row(prompt));
  terminal.say("1 + 1");
  CHECK(terminal.shows("\n2\n"));
}

TEST_CASE("repl at a terminal: a key ends a preview that would take long") {
  const Home home;
  Terminal terminal(home);
  // Hundreds of panes that mirror and let by: a single pixel takes minutes.
  terminal.say("max_depth: 60");
  terminal.say("pane = material { refract: 0.5, reflect: 0.5 }");
  terminal.say(":auto on");
  terminal.say("for i in 0..200 { plane { z: -i, material: pane } }");
  const auto start = std::chrono::steady_clock::now();
  terminal.say("1 + 1");
  CHECK(terminal.shows("\n2\n"));
  CHECK(std::chrono::steady_clock::now() - start < seconds(5));
  terminal.send(":show\r");
  REQUIRE_FALSE(terminal.wait_for("stopped", milliseconds(300)));
  terminal.send(std::string(1, ctrl_c));
  CHECK(terminal.shows("stopped"));
}

TEST_CASE("repl at a terminal: the window's size may change") {
  const Home home;
  Terminal terminal(home);
  terminal.send("sphere { radius: 1 }");
  REQUIRE(terminal.wait_for_cursor_row("rtl> sphere { radius: 1 }"));
  terminal.resize(50, 20);
  terminal.signal(SIGWINCH);
  REQUIRE(terminal.wait_for_cursor_row("rtl> sphere { radius: 1 }"));
  terminal.say("");
  terminal.say(":show");
  for (int y = 0; y < 20; ++y) CHECK(terminal.screen().row(y).size() < 50 * 4);
}

TEST_CASE("repl at a terminal: a scene on the command line is loaded") {
  const Home home;
  std::ofstream(home.path / "scene.rtl") << "// mine\nball = sphere {}\nball\n";
  Terminal terminal(home, {home.file("scene.rtl")});
  terminal.say("ball { at: [0, 2, 0] }");
  terminal.say(":save");
  std::ifstream saved(home.path / "scene.rtl");
  CHECK(std::string(std::istreambuf_iterator<char>(saved), {}) ==
        "// mine\nball = sphere {}\nball\nball { at: [0, 2, 0] }\n");
}

} // namespace
