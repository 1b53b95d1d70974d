// A code of the registry is raised in one place, by a function with a name: where it is used, nobody writes it out.

#include "lang/diagnostics/diagnostic.hpp"
#include "tests/paths.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

using namespace rt::lang;

namespace fs = std::filesystem;

namespace {

/// The codes that stand in the sources as literals, outside of the registry and comments, with the files they stand in.
std::multimap<std::string, std::string> codes_in_sources() {
  static const std::regex literal("\"([EWN][0-9]{4})\"");
  std::multimap<std::string, std::string> codes;
  for (const char* folder : {"lang", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RTLANG_SOURCE_DIR) / folder)) {
      const std::string path = entry.path().lexically_relative(RTLANG_SOURCE_DIR).generic_string();
      const bool is_source = path.ends_with(".cpp") || path.ends_with(".hpp");
      if (!is_source || path.starts_with("lang/diagnostics/codes/")) continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        line = line.substr(0, line.find("//"));
        for (auto found = std::sregex_iterator(line.begin(), line.end(), literal); found != std::sregex_iterator();
             ++found)
          codes.emplace((*found)[1], path);
      }
    }
  }
  return codes;
}

} // namespace

TEST_CASE("codes: each is raised by one function, in a file of such functions") {
  const auto codes = codes_in_sources();
  for (const auto& [code, path] : codes) {
    INFO(code << " in " << path);
    CHECK(find_code(code));
    CHECK(codes.count(code) == 1);
    CHECK((path.ends_with("_errors.cpp") || path.ends_with("_codes.cpp") || path.ends_with("_warnings.cpp") ||
           path == "lang/check/lint/rules.hpp"));
  }
  for (const Code& code : all_codes()) {
    INFO(code.code);
    CHECK(codes.contains(std::string(code.code)));
  }
}
