// The rules of the house that can be read off the sources: who may include whom.

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

bool starts_with_one_of(const std::string& text, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(), [&](const std::string& start) { return text.starts_with(start); });
}

/// Files of the room `from` may include those of the room `to`, and what that room may include. A room is a folder with
/// all below it that is no room of its own, or a single file.
struct Arrow {
  std::string_view from, to;
};
// clang-format off
constexpr Arrow arrows[] = {
    // From the description of a scene to its picture
    {"renderer/functions", "renderer/math"},
    {"renderer/fields", "renderer/functions"},
    {"renderer/sampling", "renderer/math"},
    {"renderer/shapes", "renderer/fields"},
    {"renderer/shapes", "renderer/sampling"},
    {"renderer/patterns", "renderer/fields"},
    {"renderer/lights", "renderer/fields"},
    {"renderer/scene", "renderer/shapes"},
    {"renderer/scene", "renderer/patterns"},
    {"renderer/scene", "renderer/lights"},
    {"renderer/shading", "renderer/scene"},
    {"renderer/scattering", "renderer/shading"},
    {"renderer/scattering", "renderer/sampling"},
    {"renderer/bvh", "renderer/math"}, // knows boxes, never shapes
    {"renderer/compile", "renderer/shading"},
    {"renderer/compile", "renderer/bvh"},
    {"renderer/lighting", "renderer/compile"},
    {"renderer/integrators", "renderer/lighting"},
    {"renderer/integrators", "renderer/scattering"},
    {"renderer/render", "renderer/integrators"},
    {"renderer/render", "renderer/render/film.hpp"},
    {"renderer/render/film.hpp", "renderer/render/sums.hpp"},
    {"renderer/render/sums.hpp", "renderer/math"},
    {"renderer/image", "renderer/render/film.hpp"},

    // From text to a description
    {"lang/text", "renderer/math"},
    {"lang/diagnostics", "lang/text"},
    {"lang/syntax", "lang/diagnostics"},
    {"lang/values", "lang/diagnostics"},
    {"lang/values", "renderer/scene"},
    {"lang/builtins", "lang/values"},
    {"lang/format", "lang/syntax"},
    {"lang/check", "lang/syntax"},
    {"lang/check", "lang/builtins"},
    {"lang/check", "lang/library"},
    {"lang/analyse", "lang/check"},
    {"lang/evaluate", "lang/check"},
    {"lang/load", "lang/evaluate"},
    {"lang/load", "lang/analyse"},
    {"lang/session", "lang/load"},
    {"lang/session", "lang/format"},
    {"lang/ide", "lang/session"},

    // Programs
    {"tools/terminal", "lang/text"},
    {"tools/terminal", "renderer/render"},
    {"tools/terminal", "renderer/image"},
    {"tools/inspect", "renderer/scene"},
    {"tools/diff", "renderer/image"},
    {"tools/import", "lang/format"},
    {"tools/povray/export", "renderer/scene"}, // a witness: it sees what was written, nothing that the renderer derives
    {"tools/povray/run", "tools/povray/export"},
    {"tools/povray/run", "renderer/image"},
    {"tools/povray/compare", "tools/povray/run"},
    {"tools/povray/compare", "renderer/render"},
    {"tools/explain", "lang/load"},
    {"tools/explain", "renderer/render"},
    {"tools/explain", "renderer/image"},
    {"tools/live", "tools/explain"},
    {"tools/live", "tools/povray/compare"},
    {"tools/live", "lang/session"},
    {"tools/repl", "tools/live"},
    {"tools/repl", "tools/inspect"},
    {"tools/repl", "tools/terminal"},
    {"tools/repl", "lang/ide"},
    {"tools/preview", "tools/live"},
    {"tools/lsp", "lang/ide"},
    {"tools/lsp", "tools/terminal"},
    {"tools/rtlang", "tools/repl"},
    {"tools/rtlang", "tools/preview"},
    {"tools/rtlang", "tools/lsp"},
    {"tools/rtlang", "tools/import"},
    {"tools/rtlang", "tools/diff"},
    {"tools/oracle", "tools/povray/compare"},
    {"tools/oracle", "tools/terminal"},
    {"tools/oracle", "lang/load"},
    {"tools/bench", "tools/terminal"},
    {"tools/bench", "lang/session"},
    {"tests", "tools/rtlang"},
    {"tests", "tools/oracle"},
};
// clang-format on

/// A library whose headers only these translation units see, be it through headers of ours.
struct Door {
  std::string_view library;             ///< how its includes start
  std::vector<std::string_view> behind; ///< rooms
};
const std::vector<Door> doors{
    {"tao/", {"lang/syntax/parse.cpp", "tests/lang/syntax"}},
    {"embree3/", {"renderer/bvh/bvh.cpp", "renderer/bvh/bvh_embree.cpp", "tools/bench/bars"}},
    {"tbb/", {"renderer/bvh"}},
    {"Imf", {"renderer/image/exr.cpp"}},
    {"png.h", {"renderer/image/png.cpp", "tools/oracle/golden.cpp", "tools/bench/peers", "tests/renderer/image"}},
    {"CLI/", {"tools/rtlang", "tools/oracle/main.cpp", "tools/bench/peers"}},
    {"chafa", {"tools/terminal/picture.cpp"}},
    {"histedit.h", {"tools/repl/line_editor.cpp"}},
    {"SDL", {"tools/preview/window_sdl.cpp"}},
    {"nlohmann/json.hpp", {"lang/diagnostics", "tools", "tests"}},
    {"benchmark/", {"tools/bench/micro"}},
    {"catch2/", {"tests"}},
};

bool is_in(std::string_view path, std::string_view room) {
  return path.starts_with(room) && (path.size() == room.size() || path[room.size()] == '/' || path[room.size()] == '.');
}

/// The room a file belongs to: the innermost. "" for none.
std::string_view room_of(std::string_view path) {
  std::string_view room;
  for (const Arrow& arrow : arrows)
    for (const std::string_view end : {arrow.from, arrow.to})
      if (is_in(path, end) && end.size() > room.size()) room = end;
  return room;
}

bool may_see(std::string_view from, std::string_view to) {
  if (from == to) return true;
  return std::any_of(std::begin(arrows), std::end(arrows),
                     [&](const Arrow& arrow) { return arrow.from == from && may_see(arrow.to, to); });
}

/// Every include that follows no arrow, as "from -> to".
std::vector<std::string> forbidden(const Sources& sources) {
  std::vector<std::string> list;
  for (const auto& [path, text] : sources) {
    for (const std::string& target : includes(text)) {
      const bool is_ours = starts_with_one_of(target, {"renderer/", "lang/", "tools/", "tests/", "../", "./"});
      if (!is_ours || target == "tests/paths.hpp") continue;
      const std::string_view room = room_of(target);
      if (room.empty() || !may_see(room_of(path), room)) list.push_back(path + " -> " + target);
    }
  }
  return list;
}

/// All that a file includes, directly or through headers of ours.
std::set<std::string> seen_from(const Sources& sources, const std::string& path) {
  std::set<std::string> seen;
  std::vector<std::string> pending{path};
  while (!pending.empty()) {
    const auto file = sources.find(pending.back());
    pending.pop_back();
    if (file == sources.end()) continue;
    for (const std::string& target : includes(file->second))
      if (seen.insert(target).second) pending.push_back(target);
  }
  return seen;
}

/// Every translation unit that sees a library it should not, as "unit sees header".
std::vector<std::string> peeping(const Sources& sources) {
  std::vector<std::string> list;
  for (const auto& [path, text] : sources) {
    if (!path.ends_with(".cpp")) continue;
    for (const std::string& target : seen_from(sources, path))
      for (const Door& door : doors)
        if (target.starts_with(door.library) && std::none_of(door.behind.begin(), door.behind.end(),
                                                             [&path = path](auto room) { return is_in(path, room); }))
          list.push_back(path + " sees " + target);
  }
  return list;
}

/// Every table that is indexed by a variant's position, as "file: index". With one more alternative it would be read
/// beyond its end: a visit, which then does not compile, says the same.
std::vector<std::string> indexed_by_position(const Sources& sources) {
  static const std::regex index(R"(\[[^\][]*\.index\(\)\s*\])");
  std::vector<std::string> list;
  for (const auto& [path, text] : sources)
    for (auto match = std::sregex_iterator(text.begin(), text.end(), index); match != std::sregex_iterator(); ++match)
      list.push_back(path + ": " + match->str());
  return list;
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// What no longer fits a screen, or a head: "file: 401 lines", "folder: 26 files".
std::vector<std::string> too_large(const Sources& sources) {
  std::vector<std::string> list;
  std::map<std::string, int> files;
  for (const auto& [path, text] : sources) {
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > 400) list.push_back(path + ": " + std::to_string(lines) + " lines");
    ++files[path.substr(0, path.rfind('/'))];
  }
  for (const auto& [folder, count] : files)
    if (count > 25) list.push_back(folder + ": " + std::to_string(count) + " files");
  return list;
}

/// What must not be in a header, as "header: what".
std::vector<std::string> bad_headers(const Sources& sources) {
  std::vector<std::string> list;
  for (const auto& [path, text] : sources) {
    if (!path.ends_with(".hpp")) continue;
    if (!text.starts_with("#pragma once\n")) list.push_back(path + ": not guarded");
    if (text.find("using namespace") != std::string::npos) list.push_back(path + ": using namespace");
  }
  return list;
}

} // namespace

TEST_CASE("house: every include follows an arrow") {
  const Sources sources = all_sources();
  REQUIRE(sources.size() > 50);
  CHECK(forbidden(sources) == std::vector<std::string>{});
}

TEST_CASE("house: every source stands in a room, and every room has one") {
  std::set<std::string_view> rooms;
  for (const auto& [path, text] : all_sources()) {
    INFO(path);
    CHECK(room_of(path) != "");
    rooms.insert(room_of(path));
  }
  CHECK(room_of("renderer/nowhere/made_up.cpp") == "");
  for (const Arrow& arrow : arrows) {
    INFO(arrow.from << " -> " << arrow.to);
    CHECK(rooms.contains(arrow.from));
    CHECK(rooms.contains(arrow.to));
  }
}

TEST_CASE("house: for every room, an include against the arrows is found") {
  std::set<std::string_view> rooms;
  for (const Arrow& arrow : arrows) rooms.insert(arrow.from), rooms.insert(arrow.to);
  const auto file_in = [](std::string_view room) {
    return std::string(room) + (room.ends_with(".hpp") ? "" : "/made_up.hpp");
  };
  for (const std::string_view from : rooms) {
    for (const std::string_view to : rooms) {
      INFO(from << " -> " << to);
      const Sources one{{file_in(from), "#pragma once\n\n  # include \"" + file_in(to) + "\"\n"}};
      CHECK(forbidden(one).empty() == may_see(from, to));
      // Were both allowed, the arrows would not say which comes first.
      if (from != to) CHECK_FALSE((may_see(from, to) && may_see(to, from)));
    }
  }
  CHECK(forbidden({{"renderer/render/render.cpp", "#include \"../lang/load.hpp\"\n"}}).size() == 1);
  CHECK(forbidden({{"renderer/render/render.cpp", "#include \"lang/nowhere.hpp\"\n"}}).size() == 1);
  CHECK(forbidden({{"tools/povray/export/export.cpp", "#include \"renderer/compile/csg.hpp\"\n"}}).size() == 1);
  CHECK(forbidden({{"renderer/render/render.cpp", "#include <vector>\n"}}).empty());
}

TEST_CASE("house: a library is seen behind its door only, headers included") {
  CHECK(peeping(all_sources()) == std::vector<std::string>{});
}

TEST_CASE("house: for every door, one who sees through a header is found") {
  for (const Door& door : doors) {
    std::string header(door.library);
    if (!header.ends_with(".h") && !header.ends_with(".hpp")) header += "made_up.h";
    const Sources bad{{"renderer/fields/door.hpp", "#include <" + header + ">\n"},
                      {"renderer/fields/way.hpp", "#include \"renderer/fields/door.hpp\"\n"},
                      {"renderer/fields/unit.cpp", "#include \"renderer/fields/way.hpp\"\n"}};
    INFO(door.library);
    CHECK(peeping(bad) == std::vector<std::string>{"renderer/fields/unit.cpp sees " + header});
  }
}

TEST_CASE("house: a header includes no using namespace and is guarded") {
  CHECK(bad_headers(all_sources()) == std::vector<std::string>{});
  CHECK(bad_headers({{"lang/a.hpp", "int i;\n"}}) == std::vector<std::string>{"lang/a.hpp: not guarded"});
  CHECK(bad_headers({{"lang/a.hpp", "#pragma once\nusing namespace rt;\n"}}) ==
        std::vector<std::string>{"lang/a.hpp: using namespace"});
  CHECK(bad_headers({{"lang/a.cpp", "using namespace rt;\n"}}).empty());
}

TEST_CASE("house: a file has at most 400 lines, a folder at most 25 sources") {
  CHECK(too_large(all_sources()) == std::vector<std::string>{});
  const std::string longest = repeated("int i;\n", 400), long_one = longest + "int j;\n";
  CHECK(too_large({{"lang/long.cpp", longest}}).empty());
  CHECK(too_large({{"lang/long.cpp", long_one}}) == std::vector<std::string>{"lang/long.cpp: 401 lines"});
  Sources folder;
  for (int i = 0; i < 26; ++i) folder["lang/text/" + std::to_string(i) + ".cpp"] = "";
  CHECK(too_large(folder) == std::vector<std::string>{"lang/text: 26 files"});
  folder.erase("lang/text/0.cpp");
  CHECK(too_large(folder).empty());
}

TEST_CASE("house: no table is indexed by a variant's position") {
  CHECK(indexed_by_position(all_sources()) == std::vector<std::string>{});
  const std::string position = "[light.source." + std::string("index() ]");
  const Sources bad{{"tools/names.cpp", "return nouns" + position + ";\nreturn table[i];\n"}};
  CHECK(indexed_by_position(bad) == std::vector<std::string>{"tools/names.cpp: " + position});
}
