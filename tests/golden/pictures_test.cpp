// A small picture by POV-Ray for every example and every feature by itself: ours must show the same objects, at the
// same distances, in the same colours. This needs no POV-Ray; `tools/update_goldens`, which writes the pictures anew,
// does.

#include "lang/load.hpp"
#include "renderer/image/file.hpp"
#include "tests/paths.hpp"
#include "tools/oracle/feature_scenes.hpp"
#include "tools/oracle/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
namespace povray = rt::tools::povray;
using namespace rt;
using namespace rt::tools::oracle;

const fs::path folder = fs::path(RTLANG_SOURCE_DIR) / "tests/golden/pictures";
constexpr int feature_width = 40, example_width = 48;

scene::Scene scene_of(lang::Loaded&& loaded, const std::string& name, int width) {
  INFO(name);
  REQUIRE(loaded.scene);
  scene::Scene scene = std::move(*loaded.scene);
  scene.size = {width, width * scene.size[1] / scene.size[0]};
  return scene;
}

using Scenes = std::map<std::string, scene::Scene>;

Scenes all_scenes() {
  Scenes scenes;
  for (const FeatureScene& f : feature_scenes())
    scenes.emplace(f.name, scene_of(lang::load_text(f.text, f.name + ".rtl", ".", {}), f.name, feature_width));
  const fs::path root = fs::path(RTLANG_SOURCE_DIR) / "examples";
  for (const auto& [prefix, place] : {std::pair("example_", root), std::pair("exercise_", root / "exercises")})
    for (const auto& entry : fs::directory_iterator(place)) {
      const fs::path file = entry.path();
      if (file.extension() == ".rtl")
        scenes.emplace(prefix + file.stem().string(),
                       scene_of(lang::load_file(file.string(), {}), file.string(), example_width));
    }
  return scenes;
}

std::string path_of(const std::string& name) {
  return (folder / (name + ".png")).string();
}
std::string index_path() {
  return (folder / "exports").string();
}

bool is_updating() {
  return std::getenv("RTLANG_UPDATE_GOLDENS") != nullptr;
}

// Of pictures whose export has changed; others stay as they are, to the byte.
void update(const Scenes& scenes) {
  fs::create_directories(folder);
  const GoldenIndex before = fs::exists(index_path()) ? read_index(read_file(index_path())) : GoldenIndex{};
  GoldenIndex index;
  std::vector<std::string> changed;
  for (const auto& [name, scene] : scenes) {
    index[name] = export_hash(scene);
    const auto known = before.find(name);
    if (known == before.end() || known->second != index[name] || !fs::exists(path_of(name))) changed.push_back(name);
  }
  povray::run_many(changed.size(), 16, [&](std::size_t i) {
    povray::ShootOptions one;
    one.at_once = 1;
    replace_file(path_of(changed[i]), encode_golden(povray::shoot(scenes.at(changed[i]), one)));
  });
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png" && !scenes.count(entry.path().stem().string())) fs::remove(entry.path());
  replace_file(index_path(), write_index(index));
}

// The names of the gates that do not hold.
std::string failing(const povray::Comparison& comparison) {
  std::string names;
  for (const povray::Verdict& v : povray::judge(comparison, golden_gates()))
    if (!v.holds()) names += (names.empty() ? "" : " ") + v.name;
  return names;
}

} // namespace

TEST_CASE("pictures: every example and every feature is what POV-Ray made of it") {
  const Scenes scenes = all_scenes();
  REQUIRE(scenes.size() > 100);
  if (is_updating()) update(scenes);
  const GoldenIndex index = read_index(read_file(index_path()));
  std::size_t pixels = 0, equal = 0;
  for (const auto& [name, scene] : scenes) {
    INFO(name << ": if the change is meant, tools/update_goldens has POV-Ray render it again");
    REQUIRE(index.count(name));
    CHECK(index.at(name) == export_hash(scene));
    const povray::Comparison comparison =
        compare_with_golden(scene, decode_golden(read_file(path_of(name)), path_of(name)));
    CHECK(comparison.width == scene.size[0]);
    CHECK(failing(comparison) == "");
    pixels += comparison.pixels, equal += comparison.color_equal;
  }
  INFO(equal << " of " << pixels << " pixels have the same colour");
  CHECK(static_cast<double>(equal) >= 0.9999 * static_cast<double>(pixels));
}

TEST_CASE("pictures: there is none without its scene, and all together stay small") {
  const GoldenIndex index = read_index(read_file(index_path()));
  std::uintmax_t size = 0, count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    size += entry.file_size();
    if (entry.path().extension() != ".png") continue;
    ++count;
    INFO(entry.path().string());
    CHECK(index.count(entry.path().stem().string()));
  }
  CHECK(count == index.size());
  CHECK(size < 3'000'000);
}

TEST_CASE("pictures: a change of the scene makes the kept one stale, a wrong picture fails") {
  Scenes scenes = all_scenes();
  scene::Scene& scene = scenes.at("shape_sphere");
  const GoldenIndex index = read_index(read_file(index_path()));
  const povray::Shots golden = decode_golden(read_file(path_of("shape_sphere")), "shape_sphere");
  REQUIRE(failing(compare_with_golden(scene, golden)) == "");
  const std::size_t middle = static_cast<std::size_t>(golden.width) * static_cast<std::size_t>(golden.height) / 2 + 20;

  povray::Shots other = golden;
  other.ids[middle] = 1;
  CHECK(failing(compare_with_golden(scene, other)) == "ids");
  other = golden;
  other.depth[middle] *= 1 + 2e-9;
  CHECK(failing(compare_with_golden(scene, other)) == "depth");
  other = golden;
  other.color[middle].g += 2.0f / 65535;
  CHECK(failing(compare_with_golden(scene, other)) == "color_unexplained");

  REQUIRE(index.at("shape_sphere") == export_hash(scene));
  scene.shapes.all<scene::Sphere>()[0].radius *= 1 + 1e-7;
  CHECK(index.at("shape_sphere") != export_hash(scene));
  CHECK(failing(compare_with_golden(scene, golden)).find("depth") != std::string::npos);
}

TEST_CASE("pictures: what is written is read again, to the bit") {
  povray::Shots shots{2,
                      1,
                      {{0, 1.0f / 65535, 1}, {0.5f, 0.25f, 0.75f}},
                      {0, 70000},
                      {std::numeric_limits<double>::infinity(), 12.345},
                      {},
                      true};
  const povray::Shots read = decode_golden(encode_golden(shots), "test");
  CHECK(read.width == 2);
  CHECK(read.height == 1);
  CHECK(read.color[0].g == shots.color[0].g);
  CHECK(read.color[0].b == 1);
  CHECK(std::abs(read.color[1].r - 0.5f) <= 0.5f / 65535);
  CHECK(read.ids == shots.ids);
  CHECK(std::isinf(read.depth[0]));
  CHECK(read.depth[1] == Approx(12.345).epsilon(3e-13));
  // The middle of a step of the packing stays where it is.
  shots.depth[1] = read.depth[1];
  CHECK(decode_golden(encode_golden(shots), "test").depth[1] == read.depth[1]);
  CHECK_THROWS(decode_golden("no picture", "test"));
}
