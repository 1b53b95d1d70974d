// What the set-up installs: tools/packages names all that CMake looks for.

#include "tests/paths.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

std::string read_text(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

/// What CMake looks for, as "find_package(fmt)".
std::vector<std::string> searches(const std::string& cmake) {
  static const std::regex call(R"((find_package|pkg_check_modules|find_program)\((\w+))");
  std::vector<std::string> list;
  for (auto match = std::sregex_iterator(cmake.begin(), cmake.end(), call); match != std::sregex_iterator(); ++match) {
    const std::string name = (*match)[2];
    // Threads are part of g++'s libraries; ccache's package is named by itself.
    if (name != "Threads" && name != "CCACHE") list.push_back(match->str() + ")");
  }
  return list;
}

/// The searches that no line of tools/packages names.
std::vector<std::string> unnamed(const std::vector<std::string>& searches, const std::string& packages) {
  std::vector<std::string> list;
  for (const std::string& search : searches)
    if (packages.find(search) == std::string::npos) list.push_back(search);
  return list;
}

/// The lines of tools/packages that lack a package, who needs it, or why.
std::vector<std::string> bad_rows(const std::string& packages) {
  std::istringstream lines(packages);
  std::vector<std::string> list;
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> row = words(line);
    const bool is_whole = row.size() >= 3 && (row[1] == "build" || row[1] == "test");
    if (!line.starts_with('#') && !is_whole) list.push_back(line);
  }
  return list;
}

} // namespace

TEST_CASE("packages: tools/packages names a package for all that CMake looks for") {
  const fs::path root = RTLANG_SOURCE_DIR;
  std::string cmake = read_text(root / "CMakeLists.txt");
  for (const char* folder : {"renderer", "lang", "tools", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().filename() == "CMakeLists.txt") cmake += read_text(entry.path());
  CHECK(searches(cmake).size() >= 9);
  CHECK(unnamed(searches(cmake), read_text(root / "tools/packages")) == std::vector<std::string>{});
  CHECK(unnamed(searches("find_package(Nowhere REQUIRED)\nfind_package(fmt)"),
                "libfmt-dev build find_package(fmt)\n") == std::vector<std::string>{"find_package(Nowhere)"});
}

TEST_CASE("packages: every line of tools/packages is a package, who needs it, and why") {
  const std::string packages = read_text(fs::path(RTLANG_SOURCE_DIR) / "tools/packages");
  CHECK(std::count(packages.begin(), packages.end(), '\n') >= 15);
  CHECK(bad_rows(packages) == std::vector<std::string>{});
  CHECK(bad_rows("# a comment\ng++ build compiler\nzsh test\npovray sometimes the oracle\n") ==
        std::vector<std::string>{"zsh test", "povray sometimes the oracle"});
}
