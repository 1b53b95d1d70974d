#include "lang/load.hpp"
#include "tests/paths.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> examples() {
  std::vector<fs::path> found;
  for (const char* folder : {RTLANG_SOURCE_DIR "/examples", RTLANG_SOURCE_DIR "/examples/own"})
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".rtl") found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace

TEST_CASE("examples: every scene loads, says what it teaches, and hangs in the gallery") {
  const std::string gallery = read(RTLANG_SOURCE_DIR "/examples/README.md");
  REQUIRE(examples().size() >= 15);
  for (const fs::path& path : examples()) {
    INFO(path.filename().string());
    CHECK(read(path).starts_with("// "));
    const fs::path root = RTLANG_SOURCE_DIR "/examples";
    CHECK(gallery.find("(" + fs::relative(path, root).generic_string() + ")") != std::string::npos);
    CHECK(fs::exists(root / "gallery" / (path.stem().string() + ".png")));
    const auto loaded = rt::lang::load_file(path.string(), {});
    REQUIRE(loaded.scene);
    CHECK(std::none_of(loaded.diagnostics.begin(), loaded.diagnostics.end(),
                       [](const auto& d) { return d.severity != rt::lang::Severity::note; }));
    CHECK_FALSE(loaded.scene->objects.empty());
  }
}

TEST_CASE("examples: only the first scene leaves its camera and its light to the program") {
  for (const fs::path& path : examples()) {
    const auto loaded = rt::lang::load_file(path.string(), {});
    const bool is_hello = path.stem() == "hello";
    INFO(path.filename().string());
    REQUIRE(loaded.scene);
    CHECK((loaded.scene->camera_origin.line == 0) == is_hello);
    CHECK_FALSE(loaded.scene->lights.empty());
  }
}
