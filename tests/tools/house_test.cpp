// The rules of the house that can be read off the sources: who may include whom, and what the set-up installs.

#include "tests/paths.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

using Sources = std::map<std::string, std::string>; ///< path from the repository's root → text

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Sources all_sources() {
  const fs::path root = RTLANG_SOURCE_DIR;
  Sources sources;
  for (const char* folder : {"renderer", "lang", "tools", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".cpp" || extension == ".hpp")
        sources[fs::relative(entry.path(), root).generic_string()] = read(entry.path());
    }
  }
  return sources;
}

std::vector<std::string> includes(const std::string& text) {
  static const std::regex directive(R"(^[ \t]*#[ \t]*include[ \t]*["<]([^">]+)[">])", std::regex::multiline);
  std::vector<std::string> list;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), directive); match != std::sregex_iterator(); ++match)
    list.push_back((*match)[1]);
  return list;
}

/// Files whose path starts with `of` may include, of the repository's own, only what starts with one of `may_see`. The
/// first rule that fits a file counts.
struct Arrow {
  std::string of;
  std::vector<std::string> may_see;
};
const std::vector<Arrow> arrows{
    {"renderer/math/", {"renderer/math/"}},
    {"renderer/scene/", {"renderer/math/", "renderer/scene/", "renderer/shapes/"}},
    {"renderer/shapes/", {"renderer/math/", "renderer/scene/", "renderer/shapes/"}},
    {"renderer/accel/", {"renderer/math/", "renderer/accel/"}}, // knows boxes, never shapes
    {"renderer/", {"renderer/"}},
    {"lang/", {"renderer/math/", "renderer/scene/", "renderer/shapes/", "lang/"}},
    // The exporter is a witness: it sees what was written, nothing that the renderer derives from it.
    {"tools/povray/export", {"renderer/math/", "renderer/scene/", "renderer/shapes/shapes.hpp", "tools/povray/"}},
    {"tools/", {"renderer/", "lang/", "tools/"}},
    {"tests/", {"renderer/", "lang/", "tools/", "tests/"}},
};

/// Libraries that stay behind one door.
struct Door {
  std::string library;             ///< how its includes start
  std::vector<std::string> behind; ///< how the paths of those who may include it start
};
const std::vector<Door> doors{
    {"embree3/", {"renderer/accel/", "tools/bench/bars/"}}, // the latter measures Embree by itself
    {"tao/", {"lang/", "tests/lang/"}},                     // see below
    {"CLI/", {"tools/"}},
};

bool starts_with_one_of(const std::string& text, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(), [&](const std::string& start) { return text.starts_with(start); });
}

/// Every include that is not allowed, as "from -> to".
std::vector<std::string> forbidden(const Sources& sources) {
  std::vector<std::string> list;
  for (const auto& [path, text] : sources) {
    const auto arrow =
        std::find_if(arrows.begin(), arrows.end(), [&path = path](const Arrow& a) { return path.starts_with(a.of); });
    for (const std::string& target : includes(text)) {
      const bool is_ours = starts_with_one_of(target, {"renderer/", "lang/", "tools/", "tests/", "../", "./"});
      bool is_allowed = !is_ours || starts_with_one_of(target, arrow->may_see);
      for (const Door& door : doors)
        if (target.starts_with(door.library)) is_allowed = starts_with_one_of(path, door.behind);
      if (!is_allowed) list.push_back(path + " -> " + target);
    }
  }
  return list;
}

/// The .cpp files of `lang` that include a library directly or through headers.
std::vector<std::string> units_that_see(const Sources& sources, const std::string& library) {
  std::set<std::string> seeing;
  for (bool grows = true; grows;) {
    grows = false;
    for (const auto& [path, text] : sources) {
      for (const std::string& target : includes(text))
        if (target.starts_with(library) || seeing.contains(target)) grows |= seeing.insert(path).second;
    }
  }
  std::vector<std::string> units;
  for (const std::string& path : seeing)
    if (path.starts_with("lang/") && path.ends_with(".cpp")) units.push_back(path);
  return units;
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

} // namespace

TEST_CASE("house: every include follows an allowed arrow") {
  const Sources sources = all_sources();
  REQUIRE(sources.size() > 50);
  CHECK(forbidden(sources) == std::vector<std::string>{});
}

TEST_CASE("house: an arrow that is not allowed is found") {
  const auto is_forbidden = [](const std::string& path, const std::string& include) {
    return forbidden({{path, "#pragma once\n\n  # include " + include + "\n"}}).size() == 1;
  };
  CHECK(is_forbidden("renderer/math/vec3.hpp", R"("renderer/scene/scene.hpp")"));
  CHECK(is_forbidden("renderer/shapes/sphere.cpp", R"("renderer/render.hpp")"));
  CHECK(is_forbidden("renderer/scene/scene.cpp", R"("lang/source.hpp")"));
  CHECK(is_forbidden("renderer/accel/tree.hpp", R"("renderer/shapes/sphere.hpp")"));
  CHECK(is_forbidden("renderer/render.cpp", R"("lang/load.hpp")"));
  CHECK(is_forbidden("renderer/render.cpp", R"("../lang/load.hpp")"));
  CHECK(is_forbidden("lang/evaluate.cpp", R"("renderer/accel/tree.hpp")"));
  CHECK(is_forbidden("lang/evaluate.cpp", R"("renderer/integrators/whitted.hpp")"));
  CHECK(is_forbidden("lang/evaluate.cpp", R"("renderer/film.hpp")"));
  CHECK(is_forbidden("renderer/render.cpp", "<tao/pegtl.hpp>"));
  CHECK(is_forbidden("tools/rtlang/fmt_command.cpp", "<tao/pegtl.hpp>"));
  CHECK(is_forbidden("renderer/render.cpp", "<embree3/rtcore.h>"));
  CHECK(is_forbidden("tools/povray/export.cpp", R"("renderer/camera.hpp")"));
  CHECK(is_forbidden("tools/povray/export.cpp", R"("renderer/shapes/hit.hpp")"));
  CHECK(is_forbidden("tools/rtlang/main.cpp", R"("tests/tools/program.hpp")"));

  CHECK_FALSE(is_forbidden("lang/evaluate.cpp", R"("renderer/shapes/shapes.hpp")"));
  CHECK_FALSE(is_forbidden("renderer/accel/tree.cpp", "<embree3/rtcore.h>"));
  CHECK_FALSE(is_forbidden("tools/rtlang/render_command.cpp", R"("renderer/render.hpp")"));
  CHECK_FALSE(is_forbidden("renderer/render.cpp", "<vector>"));
}

TEST_CASE("house: one translation unit of the language sees PEGTL") {
  CHECK(units_that_see(all_sources(), "tao/") == std::vector<std::string>{"lang/parse.cpp"});
  const Sources bad{{"lang/grammar.hpp", "#include <tao/pegtl.hpp>\n"},
                    {"lang/parse.cpp", "#include \"lang/grammar.hpp\"\n"},
                    {"lang/check.hpp", "#include \"lang/grammar.hpp\"\n"},
                    {"lang/check.cpp", "#include \"lang/check.hpp\"\n"}};
  CHECK(units_that_see(bad, "tao/") == std::vector<std::string>{"lang/check.cpp", "lang/parse.cpp"});
}

TEST_CASE("house: a header includes no using namespace and is guarded") {
  for (const auto& [path, text] : all_sources()) {
    if (!path.ends_with(".hpp")) continue;
    INFO(path);
    CHECK(text.starts_with("#pragma once\n"));
    CHECK(text.find("using namespace") == std::string::npos);
  }
}

TEST_CASE("house: tools/packages names a package for all that CMake looks for") {
  const fs::path root = RTLANG_SOURCE_DIR;
  std::string cmake = read(root / "CMakeLists.txt");
  for (const char* folder : {"renderer", "lang", "tools", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().filename() == "CMakeLists.txt") cmake += read(entry.path());
  const std::string packages = read(root / "tools/packages");

  static const std::regex call(R"((find_package|pkg_check_modules|find_program)\((\w+))");
  int found = 0;
  for (auto match = std::sregex_iterator(cmake.begin(), cmake.end(), call); match != std::sregex_iterator(); ++match) {
    const std::string what = match->str() + ")", name = (*match)[2];
    if (name == "Threads" || name == "CCACHE") continue; // part of g++'s libraries; named by its package
    INFO(what << " needs a line in tools/packages that says so");
    CHECK(packages.find(what) != std::string::npos);
    ++found;
  }
  CHECK(found >= 9);
}

TEST_CASE("house: every line of tools/packages is a package, who needs it, and why") {
  std::istringstream lines(read(fs::path(RTLANG_SOURCE_DIR) / "tools/packages"));
  int count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::vector<std::string> row = words(line);
    INFO(line);
    REQUIRE(row.size() >= 3);
    CHECK((row[1] == "build" || row[1] == "test"));
    ++count;
  }
  CHECK(count >= 15);
}
