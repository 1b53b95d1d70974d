// What the program says of itself, and whether the manual page and the shells' completion say the same.

#include "tests/paths.hpp"
#include "tests/support/program.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

using namespace rt::tests;
using Catch::Matchers::Contains;

namespace {

const std::filesystem::path installed_files = std::filesystem::path(RTLANG_SOURCE_DIR) / "tools/install";

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

/// The commands that `rtlang --help` lists.
std::vector<std::string> commands() {
  std::vector<std::string> list;
  const std::string help = rtlang({"--help"}).output;
  static const std::regex row("^  ([a-z]+) ");
  std::smatch match;
  bool is_in_list = false;
  for (const std::string& line : lines_of(help)) {
    if (line.starts_with("Commands")) is_in_list = true;
    if (is_in_list && std::regex_search(line, match, row)) list.push_back(match[1]);
  }
  return list;
}

/// The options, "-o" and "--output", that a help text lists.
std::set<std::string> options(const std::string& help) {
  std::set<std::string> list;
  static const std::regex row("^ +(-[A-Za-z])?(?:, )?(--[a-z-]+)?");
  std::smatch match;
  for (const std::string& line : lines_of(help)) {
    if (!std::regex_search(line, match, row)) continue;
    for (const std::size_t i : {1u, 2u})
      if (match[i].matched) list.insert(match[i]);
  }
  return list;
}

std::string without_backslashes(std::string text) {
  std::erase(text, '\\');
  return text;
}

RunOptions with_program_in_path() {
  RunOptions options;
  options.environment = {"PATH=" + std::filesystem::path(RTLANG_BINARY).parent_path().string() + ":/usr/bin:/bin"};
  return options;
}

} // namespace

TEST_CASE("help: --help fits a screen") {
  for (const char* word : {"--help", "-h", "help"}) {
    const Outcome run = rtlang({word});
    CHECK(run.exit_code == 0);
    CHECK(run.errors.empty());
    const std::vector<std::string> lines = lines_of(run.output);
    CHECK(lines.size() >= 24);
    CHECK(lines.size() <= 40);
    for (const std::string& line : lines) {
      INFO(line);
      CHECK(line.size() <= 80);
    }
  }
}

TEST_CASE("help: every command has its own, in lines that fit a terminal") {
  REQUIRE(commands().size() >= 4);
  for (const std::string& command : commands()) {
    INFO(command);
    const Outcome run = rtlang({command, "--help"});
    CHECK(run.exit_code == 0);
    CHECK_THAT(run.output, Catch::StartsWith("rtlang " + command + ": ") && Contains("\nUsage: rtlang " + command));
    CHECK(options(run.output).contains("--help"));
    for (const std::string& line : lines_of(run.output)) {
      INFO(line);
      CHECK(line.size() <= (line.starts_with("Usage") ? 100 : 80));
    }
  }
}

TEST_CASE("help: --version is one line") {
  const Outcome run = rtlang({"--version"});
  CHECK(run.exit_code == 0);
  CHECK(std::regex_match(run.output, std::regex("rtlang [0-9]+\\.[0-9]+\\.[0-9]+\n")));
}

TEST_CASE("help: the manual page speaks of every command and every option") {
  const std::string page = without_backslashes(read(installed_files / "rtlang.1"));
  std::set<std::string> all{"--version"};
  for (const std::string& command : commands()) {
    INFO("command " << command);
    CHECK_THAT(page, Contains("\n.B " + command + "\n"));
    all.merge(options(rtlang({command, "--help"}).output));
  }
  for (const std::string& option : all) {
    INFO("option " << option);
    CHECK(std::regex_search(page, std::regex("\n\\.[BIR]+ [^\n]*" + option + "\\b")));
  }
}

TEST_CASE("help: the manual page speaks of no option that is not there") {
  std::set<std::string> all{"--version"};
  for (const std::string& command : commands()) all.merge(options(rtlang({command, "--help"}).output));
  const std::string page = without_backslashes(read(installed_files / "rtlang.1"));
  const std::regex word("--[a-z][a-z-]+");
  for (auto match = std::sregex_iterator(page.begin(), page.end(), word); match != std::sregex_iterator(); ++match) {
    INFO(match->str());
    CHECK(all.contains(match->str()));
  }
}

TEST_CASE("help: groff reads the manual page without a warning") {
  const Outcome run =
      run_program("/usr/bin/groff", {"-man", "-Tutf8", "-ww", "-z", (installed_files / "rtlang.1").string()});
  CHECK(run.exit_code == 0);
  CHECK(run.errors.empty());
}

TEST_CASE("completion: bash offers commands, options, values and files") {
  const auto offered = [](const std::string& words) {
    const TestFolder folder;
    folder.write("lamp.rtl", "");
    folder.write("notes.txt", "");
    RunOptions options = with_program_in_path();
    options.folder = folder.path();
    const Outcome run = run_program(
        "/bin/bash",
        {"--norc", "-c",
         "shopt -s extglob; source '" + (installed_files / "rtlang.bash").string() + "' || exit 9; COMP_WORDS=(" +
             words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rtlang; printf '%s\\n' \"${COMPREPLY[@]}\""},
        options);
    CHECK(run.exit_code == 0);
    CHECK(run.errors.empty());
    return lines_of(run.output);
  };
  using Catch::VectorContains;
  const auto first = offered("rtlang ''");
  for (const std::string& command : commands()) CHECK_THAT(first, VectorContains(command));
  CHECK_THAT(first, VectorContains(std::string("lamp.rtl")) && !VectorContains(std::string("notes.txt")));
  CHECK(offered("rtlang lamp.rtl --si") == std::vector<std::string>{"--size"});
  CHECK(offered("rtlang lamp.rtl --format p") == std::vector<std::string>{"png", "ppm", "pfm"});
  for (const std::string& command : commands()) {
    auto words = offered("rtlang " + command + " -");
    const std::set<std::string> expected = options(rtlang({command, "--help"}).output);
    CHECK(std::set<std::string>(words.begin(), words.end()) == expected);
  }
  CHECK_THAT(offered("rtlang explain E0"), VectorContains(std::string("E0204")));
}

TEST_CASE("completion: zsh offers commands, options and values") {
  const std::string file = (installed_files / "_rtlang").string();
  CHECK(run_program("/usr/bin/zsh", {"-f", "-n", file}).exit_code == 0);
  const auto offered = [&](const std::string& typed) {
    // The completion system's own functions stand in for themselves by printing what they are given.
    const Outcome run = run_program(
        "/usr/bin/zsh",
        {"-f", "-c",
         "_describe() { local -a list=(\"${(@P)2}\"); print -rl -- ${list%%:*} } ; _files() { print files } ; "
         "compadd() { print -rl -- $@ } ; words=(" +
             typed + "); CURRENT=$#words; PREFIX=$words[-1]; source '" + file + "'"},
        with_program_in_path());
    CHECK(run.exit_code == 0);
    CHECK(run.errors.empty());
    return lines_of(run.output);
  };
  std::vector<std::string> first = commands();
  first.emplace_back("files");
  CHECK(offered("rtlang ''") == first);
  CHECK(offered("rtlang a.rtl --format p") == std::vector<std::string>{"png", "exr", "ppm", "pfm"});
  for (const std::string& command : commands()) {
    const auto words = offered("rtlang " + command + " -");
    CHECK(std::set<std::string>(words.begin(), words.end()) == options(rtlang({command, "--help"}).output));
  }
}
