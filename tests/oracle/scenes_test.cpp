#include "tests/oracle/live.hpp"
#include "tests/paths.hpp"
#include "tools/oracle/feature_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <random>

using namespace rt;
using namespace rt::tests;
namespace povray = rt::tools::povray;

namespace {

// Pixels of a whole run: of them 99.99 % have to be equal.
struct Sum {
  std::size_t pixels = 0, equal = 0, depths = 0, imprecise = 0;
  void add(const povray::Comparison& c) {
    pixels += c.pixels, equal += c.color_equal, depths += c.depths, imprecise += c.depths_beyond_p999;
  }
  void check() const {
    INFO(equal << " of " << pixels << " pixels are equal");
    CHECK(static_cast<double>(equal) >= 0.9999 * static_cast<double>(pixels));
    CHECK(static_cast<double>(imprecise) <= 0.001 * static_cast<double>(depths));
  }
};

void check_all(const std::vector<std::pair<std::string, scene::Scene>>& scenes) {
  std::vector<povray::Comparison> results(scenes.size());
  povray::run_many(scenes.size(), 16, [&](std::size_t i) {
    const scene::Scene& scene = scenes[i].second;
    povray::ShootOptions shoot;
    shoot.at_once = 1;
    results[i] = povray::compare(scene, film_of(scene), povray::shoot(scene, shoot));
  });
  Sum sum;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    INFO(scenes[i].first << ": " << failing(results[i]));
    CHECK(holds(results[i]));
    sum.add(results[i]);
  }
  sum.check();
}

std::vector<std::filesystem::path> examples() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path root = RTLANG_SOURCE_DIR "/examples";
  for (const std::filesystem::path& folder : {root, root / "exercises"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".rtl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

scene::Scene example(const std::filesystem::path& file) {
  scene::Scene scene = loaded(lang::load_file(file.string(), {}), file.string());
  INFO(file.string());
  const auto inexact = povray::export_povray(scene).inexact;
  for (const auto& i : inexact) UNSCOPED_INFO(i.message);
  CHECK(inexact.empty());
  return scene;
}

} // namespace

TEST_CASE("every example in its own size is what POV-Ray makes of it") {
  std::vector<std::pair<std::string, scene::Scene>> scenes;
  for (const auto& file : examples()) scenes.emplace_back(file.filename().string(), example(file));
  REQUIRE(scenes.size() > 20);
  check_all(scenes);
}

TEST_CASE("examples of what POV-Ray does not have stand apart, and their export says so") {
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RTLANG_SOURCE_DIR "/examples/own")) {
    if (entry.path().extension() != ".rtl") continue;
    INFO(entry.path().string());
    const scene::Scene scene = loaded(lang::load_file(entry.path().string(), {}), entry.path().string());
    CHECK_FALSE(povray::export_povray(scene).inexact.empty());
    ++found;
  }
  CHECK(found > 0);
}

// Every size has other rays, and with them other chances to graze an edge.
TEST_CASE("every example in two sizes drawn by lot is what POV-Ray makes of it") {
  std::mt19937 lot(20261128);
  const auto side = [&] { return static_cast<int>(40 + lot() % 361); };
  std::vector<std::pair<std::string, scene::Scene>> scenes;
  for (const auto& file : examples())
    for (int i = 0; i < 2; ++i) {
      scene::Scene scene = example(file);
      scene.size = {side(), side()};
      scenes.emplace_back(fmt::format("{}, {} x {}", file.filename().string(), scene.size[0], scene.size[1]),
                          std::move(scene));
    }
  check_all(scenes);
}

TEST_CASE("every feature by itself is what POV-Ray makes of it") {
  std::vector<std::pair<std::string, scene::Scene>> scenes;
  for (const auto& feature : tools::oracle::feature_scenes()) {
    INFO(feature.name);
    scene::Scene scene = scene_of(feature.text);
    CHECK(povray::export_povray(scene).inexact.empty());
    scenes.emplace_back(feature.name, std::move(scene));
  }
  check_all(scenes);
}
