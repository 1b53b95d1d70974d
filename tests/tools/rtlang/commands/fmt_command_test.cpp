// `rtlang fmt`, end to end.

#include "tests/paths.hpp"
#include "tests/support/program.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>

using namespace rt::tests;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

constexpr const char* messy = "// a ball\nsphere{radius:2,at:[ 1,2 ,3 ]} // big\n\n\n\nbox{\nsize:1,at:[0,4,0]}\n";
constexpr const char* tidy =
    "// a ball\nsphere { radius: 2, at: [1, 2, 3] } // big\n\nbox {\n  size: 1\n  at: [0, 4, 0]\n}\n";

struct Desk {
  TestFolder folder;
  RunOptions options;
  Desk() { options.folder = folder.path(); }
  Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "fmt");
    return rtlang(arguments, options);
  }
};

fs::perms permissions(const std::string& path) {
  return fs::status(path).permissions();
}

TEST_CASE("fmt: files are rewritten in place, in silence, and their permissions stay") {
  const Desk desk;
  desk.folder.write("a.rtl", messy);
  desk.folder.write("b.rtl", messy);
  fs::permissions(desk.folder / "a.rtl", fs::perms(0640));
  const Outcome run = desk.run({"a.rtl", "b.rtl"});
  CHECK(run.exit_code == 0);
  CHECK(run.output + run.errors == "");
  CHECK(desk.folder.read("a.rtl") == tidy);
  CHECK(desk.folder.read("b.rtl") == tidy);
  CHECK(permissions(desk.folder / "a.rtl") == fs::perms(0640));
  CHECK(desk.folder.names() == std::vector<std::string>{"a.rtl", "b.rtl"});
}

TEST_CASE("fmt: a file that is formatted already is not written") {
  const Desk desk;
  desk.folder.write("a.rtl", tidy);
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(desk.folder / "a.rtl", old);
  CHECK(desk.run({"a.rtl"}).exit_code == 0);
  CHECK(fs::last_write_time(desk.folder / "a.rtl") - old < std::chrono::minutes(1));
}

TEST_CASE("fmt: --check lists what would change, and changes nothing") {
  const Desk desk;
  desk.folder.write("messy.rtl", messy);
  desk.folder.write("tidy.rtl", tidy);
  const Outcome run = desk.run({"--check", "tidy.rtl", "messy.rtl"});
  CHECK(run.exit_code == 1);
  CHECK(run.output == "messy.rtl\n");
  CHECK(run.errors == "");
  CHECK(desk.folder.read("messy.rtl") == messy);
  CHECK(desk.run({"--check", "tidy.rtl"}).exit_code == 0);
}

TEST_CASE("fmt: - goes from standard input to standard output") {
  Desk desk;
  desk.options.input = messy;
  const Outcome run = desk.run({"-"});
  CHECK(run.exit_code == 0);
  CHECK(run.output == tidy);
  CHECK(desk.run({"--check", "-"}).output == "<stdin>\n");
  desk.options.input = "sphere { radius 2 }";
  const Outcome wrong = desk.run({"-"});
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.output == "");
  CHECK_THAT(wrong.errors, Contains("--> <stdin>:1:"));
}

TEST_CASE("fmt: a file with syntax errors is left as it is, and the others are formatted") {
  const Desk desk;
  const std::string wrong = "sphere{radius:1}\nbox { size 2 }\n";
  desk.folder.write("wrong.rtl", wrong);
  desk.folder.write("messy.rtl", messy);
  const Outcome run = desk.run({"wrong.rtl", "messy.rtl"});
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.errors, Contains("--> wrong.rtl:2:"));
  CHECK(desk.folder.read("wrong.rtl") == wrong);
  CHECK(desk.folder.read("messy.rtl") == tidy);
  const Outcome json = desk.run({"wrong.rtl", "messy.rtl", "--diagnostics", "json"});
  CHECK(json.exit_code == 1);
  CHECK(nlohmann::json::parse(json.errors).size() == 1);
}

TEST_CASE("fmt: a scene that is wrong in other ways can be formatted") {
  const Desk desk;
  desk.folder.write("a.rtl", "sphere{raduis:1}\n");
  CHECK(desk.run({"a.rtl"}).exit_code == 0);
  CHECK(desk.folder.read("a.rtl") == "sphere { raduis: 1 }\n");
}

TEST_CASE("fmt: what cannot be read or written is reported, and the others are formatted") {
  Desk desk;
  desk.folder.write("messy.rtl", messy);
  desk.folder.write("locked.rtl", messy);
  fs::permissions(desk.folder / "locked.rtl", fs::perms(0444));
  fs::create_directory(desk.folder / "folder");
  fs::permissions(desk.folder.path(), fs::perms(0777));
  fs::permissions(desk.folder / "messy.rtl", fs::perms(0666));
  desk.options.as_nobody = true;
  const Outcome run = desk.run({"missing.rtl", "locked.rtl", "folder", "messy.rtl"});
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.errors, Contains("cannot read `missing.rtl`") && Contains("cannot write `locked.rtl`") &&
                             Contains("cannot read `folder`"));
  CHECK(desk.folder.read("locked.rtl") == messy);
  CHECK(desk.folder.read("messy.rtl") == tidy);
  CHECK(desk.folder.names() == std::vector<std::string>{"folder", "locked.rtl", "messy.rtl"});
}

TEST_CASE("fmt: on a full disk the old file stays whole") {
  Desk desk;
  const std::string large = messy + std::string(9000, '\n') + "// " + std::string(9000, 'x') + "\n";
  desk.folder.write("a.rtl", large);
  desk.options.greatest_file = 4096;
  CHECK(desk.run({"a.rtl"}).exit_code == 3);
  CHECK(desk.folder.read("a.rtl") == large);
  CHECK(desk.folder.names() == std::vector<std::string>{"a.rtl"});
}

TEST_CASE("fmt: through a symbolic link the file itself is rewritten") {
  const Desk desk;
  desk.folder.write("a.rtl", messy);
  fs::create_symlink("a.rtl", desk.folder / "link.rtl");
  CHECK(desk.run({"link.rtl"}).exit_code == 0);
  CHECK(fs::is_symlink(desk.folder / "link.rtl"));
  CHECK(desk.folder.read("a.rtl") == tidy);
}

TEST_CASE("fmt: the examples are laid out as it would lay them out") {
  std::vector<std::string> arguments{"--check"};
  for (const auto& entry : fs::recursive_directory_iterator(std::string(RTLANG_SOURCE_DIR) + "/examples"))
    if (entry.path().extension() == ".rtl") arguments.push_back(entry.path().string());
  REQUIRE(arguments.size() > 20);
  const Outcome run = Desk().run(arguments);
  CHECK(run.output == "");
  CHECK(run.exit_code == 0);
}

TEST_CASE("fmt: without a file the command line is wrong") {
  CHECK(Desk().run({}).exit_code == 2);
}

} // namespace
