#include "tests/support/program.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

using rt::tests::Outcome;
using rt::tests::RunOptions;
using rt::tests::TestFolder;

Outcome session(const TestFolder& folder, const std::string& input, std::vector<std::string> arguments = {}) {
  RunOptions options;
  options.folder = folder.path();
  options.input = input;
  arguments.insert(arguments.begin(), "repl");
  return rt::tests::rtlang(arguments, options);
}

TEST_CASE("session as a script: values alone are printed, without prompt, colour or banner") {
  const TestFolder folder;
  const Outcome outcome = session(folder, "r = 2\n\nbox {\n  size: r\n}\nr * 3\nred\n:list\n");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.output == "6\n#ff0000\n1     box   around [0, 0, 0]\n");
  CHECK(outcome.errors.empty());
}

TEST_CASE("session as a script: the first error ends it, unless it is to keep going") {
  const TestFolder folder;
  const std::string input = "1\nsphere { raduis: 1 }\n2\n";
  const Outcome stopped = session(folder, input);
  CHECK(stopped.exit_code == 1);
  CHECK(stopped.output == "1\n");
  CHECK(stopped.errors.find("E0204") != std::string::npos);
  const Outcome went_on = session(folder, input, {"--keep-going"});
  CHECK(went_on.exit_code == 1);
  CHECK(went_on.output == "1\n2\n");
  CHECK(session(folder, ":nonsense\n").exit_code == 1);
}

TEST_CASE("session as a script: input that ends within brackets is a mistake") {
  const TestFolder folder;
  const Outcome outcome = session(folder, "sphere {\n  radius: 1\n");
  CHECK(outcome.exit_code == 1);
  CHECK_FALSE(outcome.errors.empty());
}

TEST_CASE("session as a script: what it saves makes the same picture, byte for byte") {
  const TestFolder folder;
  const Outcome outcome =
      session(folder, "// glass on a floor\nfloor = checker { a: white, b: #333 }\nplane { y: 0, material: floor }\n"
                      "ball = sphere { at: [0, 1, 0], material: glass }\nball\n.move(x: 0.5) // a bit\nfloor = checker "
                      "{ a: navy, b: white }\n"
                      "for i in 0..3{box{size:0.3,at:[i-1.5,0.15,2]// four\n}}\n:set ball.radius 1.2\n"
                      ":render session.png --size 60x40\n:save scene.rtl\n");
  REQUIRE(outcome.errors == "");
  REQUIRE(outcome.exit_code == 0);
  const std::string saved = folder.read("scene.rtl");
  CHECK(saved.find("// glass on a floor\n") == 0);
  CHECK(saved.find("for i in 0..3 {\n  box {\n    size: 0.3\n    at: [i - 1.5, 0.15, 2] // four\n  }\n}\n") !=
        std::string::npos);
  RunOptions options;
  options.folder = folder.path();
  REQUIRE(rt::tests::rtlang({"scene.rtl", "-o", "file.png", "--size", "60x40"}, options).exit_code == 0);
  CHECK(folder.read("session.png").size() > 200);
  CHECK(folder.read("session.png") == folder.read("file.png"));
  // And once more from the file.
  REQUIRE(session(folder, ":load scene.rtl\n:render again.png --size 60x40\n:save again.rtl\n").exit_code == 0);
  CHECK(folder.read("again.png") == folder.read("file.png"));
  CHECK(folder.read("again.rtl") == folder.read("scene.rtl"));
}

TEST_CASE("session as a script: the reference, POV-Ray's format and the program's own questions are at hand") {
  const TestFolder folder;
  const Outcome outcome =
      session(folder, ":doc sphere\n:doc shininess\nsphere {}\n:export pov a.pov\n:probe 400 300\n:why 400 300\n");
  CHECK(outcome.errors == "");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.output.find("radius") != std::string::npos);
  CHECK(outcome.output.find("material.shininess: number or pattern (32)") != std::string::npos);
  CHECK(folder.read("a.pov").find("sphere") != std::string::npos);
  CHECK(session(folder, ":doc spher\n").errors.find("did you mean `sphere`?") != std::string::npos);
}

TEST_CASE("session as a script: :set without a value says what can be set") {
  const TestFolder folder;
  const std::string scene = "ball = sphere {}\nball\nbox {}\ndef table(width = 2) { box { size: width } }\n";
  CHECK(session(folder, scene + ":set ball.radius\n").output ==
        "ball.radius: number = 1\n  distance from the centre to the surface\n");
  CHECK(session(folder, scene + ":set 1.size\n").output.find("1.size: vector or number = 1\n") == 0);
  CHECK(session(folder, scene + ":set table.width\n").output == "table.width: a parameter of table, default 2\n");
  CHECK(session(folder, scene + ":set background\n").output.find("background: colour") == 0);
  CHECK(session(folder, scene + ":set ball\n").output.find("ball takes at, ") == 0);
  CHECK(session(folder, scene + ":set ball.\n").output.find("ball takes at, ") == 0);
  CHECK(session(folder, scene + ":set nobody.x\n").errors.find("there is no thing `nobody` in the scene") == 0);
}

TEST_CASE("session as a script: :undo and :redo say what they took back and did again") {
  const TestFolder folder;
  const Outcome outcome = session(folder, "sphere {}\n:set sphere.radius 2\n:undo\n:undo\n:redo\n");
  CHECK(outcome.output == "undone: :set sphere.radius 2\nundone: sphere {}\nredone: sphere {}\n");
}

TEST_CASE("session as a script: :why shows the main path of light, or as much of the tree as is asked for") {
  const TestFolder folder;
  const std::string scene = "sphere { material: material { refract: 0.9, reflect: 0.1, ior: 1.5 } }\n";
  const std::string path = session(folder, scene + ":why 400 300\n").output;
  const std::string all = session(folder, scene + ":why 400 300 --all\n").output;
  CHECK(path.find("(--all shows all ") != std::string::npos);
  CHECK(path.find("mirrored ray, depth 1") == std::string::npos);
  CHECK(all.find("mirrored ray, depth 1") != std::string::npos);
  CHECK(session(folder, scene + ":why 400 300 --least 2\n").errors == "--least takes a number from 0 to 1, not `2`\n");
}

TEST_CASE("session as a script: what has a name is explained, also one's own") {
  const TestFolder folder;
  CHECK(session(folder, "def crate(planks = 3) { box {} }\n:doc crate\n").output ==
        "def crate(planks = 3) { box {} }\n  takes at, casts_shadow, material, name, planks, rotate, scale, visible\n");
  CHECK(session(folder, "n = 3\n:doc n\n").output == "n = 3\n");
  CHECK(session(folder, ":doc tomato\n").output == "tomato: the colour #ff6347\n");
  CHECK(session(folder, ":doc for\n").output.find("for x in 0..5") == 0);
  CHECK(session(folder, ":doc :show\n").output.find(":show") == 0);
  CHECK(session(folder, "crate = 1\n:doc crat\n").errors.find("did you mean `crate`?") != std::string::npos);
}

TEST_CASE("session as a script: what is included is found by the program's questions, and missed where it is saved") {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path() / "inner");
  folder.write("inner/colors.rtl", "rust = #b7410e\n");
  folder.write("inner/scene.rtl", "use \"colors.rtl\" as colors\nsphere { material: colors.rust }\n");
  const Outcome outcome =
      session(folder, ":load inner/scene.rtl\n:probe 400 300\n:save inner/copy.rtl\n:save copy.rtl\n1 + 1\n");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.output.find("sphere (session:2)") != std::string::npos);
  CHECK(outcome.errors.find("the files it includes are in") == 0);
  CHECK(outcome.output.find("\n2\n") != std::string::npos);
}

TEST_CASE("session as a script: pictures are characters") {
  const TestFolder folder;
  const Outcome outcome = session(folder, "sphere {}\n:show\n");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.output.find('\x1b') == std::string::npos);
  CHECK(outcome.output.size() > 500);
  // A red ball before a black background is seen.
  const Outcome red = session(folder, "background: black\nsphere { material: #f00 }\n:show\n");
  CHECK(red.output.find('=') != std::string::npos);
  CHECK(red.output.find('@') == std::string::npos);
}

TEST_CASE("session as a script: what cannot be read or written is reported") {
  const TestFolder folder;
  CHECK(session(folder, ":load nothing.rtl\n").errors.find("nothing.rtl") != std::string::npos);
  CHECK(session(folder, "sphere {}\n:save no/such/folder.rtl\n").exit_code == 1);
  CHECK(session(folder, ":save\n").errors.find("give a file name") != std::string::npos);
  CHECK(session(folder, ":render picture.bmp\n").errors.find(".png") != std::string::npos);
  CHECK(session(folder, "", {"nothing.rtl"}).exit_code == 1);
}

} // namespace
