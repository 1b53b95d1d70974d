#include "lang/session/session_scene.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "renderer/math/hashing.hpp"
#include "renderer/scene/defaults.hpp"

#include <algorithm>
#include <span>

namespace rt::lang {
namespace {

template <class F>
void for_each_with(const Document& document, int traits, F&& f) {
  for (const auto& chunk : document.chunks()) {
    if ((chunk->all_traits & traits) == 0) continue;
    for (std::size_t i = 0; i < chunk->statements.size(); ++i)
      if ((chunk->traits[i] & traits) != 0) f(*chunk->statements[i]);
  }
}

} // namespace

void SessionScene::show(const Document& document) {
  scene::Scene& scene = evaluator_.scene();
  std::size_t kept = 0;
  std::vector<const Statement*> further;
  for (const auto& chunk : document.chunks()) {
    for (std::size_t i = 0; i < chunk->statements.size(); ++i) {
      if ((chunk->traits[i] & trait_objects) == 0) continue;
      if (further.empty() && kept < placed_.size() && placed_[kept].stamp == chunk->stamps[i])
        ++kept;
      else
        further.push_back(chunk->statements[i].get());
    }
  }
  placed_.resize(kept);
  scene.objects.resize(kept == 0 ? 0 : placed_.back().end);
  for (const Statement* statement : further) {
    const auto begin = static_cast<std::uint32_t>(scene.objects.size());
    scene.objects.insert(scene.objects.end(), statement->made.objects.begin(), statement->made.objects.end());
    placed_.push_back({statement->stamp, begin, static_cast<std::uint32_t>(scene.objects.size())});
  }
  show_settings(document);
}

void SessionScene::show_settings(const Document& document) {
  scene::Scene& scene = evaluator_.scene();
  static_cast<scene::Settings&>(scene) = {};
  scene.lights.clear();
  bool has_camera = false, has_ambient = false;
  const NodeType& type = program_.types.scene();
  for_each_with(document, trait_lights | trait_camera | trait_properties, [&](const Statement& statement) {
    const StatementResult& made = statement.made;
    scene.lights.insert(scene.lights.end(), made.lights.begin(), made.lights.end());
    if (made.camera) {
      scene.camera = *made.camera;
      has_camera = true;
    }
    for (const PropertyValue& p : made.properties) {
      type.properties[p.id].field->set(&scene, evaluator_.scene_value(p));
      has_ambient = has_ambient || type.properties[p.id].name == "ambient";
    }
  });
  for (std::size_t i = scene.files.size(); i < program_.sources.size(); ++i)
    scene.files.push_back(program_.sources.file(static_cast<FileId>(i)).name);
  assume(document, has_camera, has_ambient);
}

void SessionScene::assume(const Document& document, bool has_camera, bool has_ambient) {
  scene::Scene& scene = evaluator_.scene();
  assumptions_.clear();
  if (!has_camera) {
    Box3 box;
    for (const auto& chunk : document.chunks()) box.extend(chunk->finite_box);
    assumptions_.push_back(errors::assumed_camera({}, assume_camera(scene, box)));
  }
  if (lacks_light(scene, has_ambient)) assumptions_.push_back(errors::assumed_light({}, assume_light(scene)));
}

namespace {

// Cuts what statements placed into ranges. Where one ends depends only on its own content, so that it is found again
// when something else has changed: a range may end once it has enough objects, and ends occur often enough. What
// remains after the last end is cut into shorter ones, so that little is outside of all of them.
class Cutter {
public:
  template <class Placed>
  void cut(std::span<const Placed> placed, std::uint32_t enough) {
    Hasher hasher;
    std::size_t first = 0; // of the current range
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (placed[i].end - placed[i].begin >= enough / 4) { // is a range by itself
        leave(placed.subspan(first, i - first), enough);
        found.push_back({placed[i].begin, placed[i].end, Hasher().add(placed[i].stamp).value()});
        first = i + 1;
        hasher = {};
        continue;
      }
      hasher.add(placed[i].stamp);
      const bool is_enough = placed[i].end - placed[first].begin >= enough;
      if (!is_enough || Hasher().add(placed[i].stamp).value() % 8 != 0) continue;
      found.push_back({placed[first].begin, placed[i].end, hasher.value()});
      first = i + 1;
      hasher = {};
    }
    leave(placed.subspan(first), enough);
  }

  std::vector<SceneRange> found;

private:
  template <class Placed>
  void leave(std::span<const Placed> placed, std::uint32_t enough) {
    constexpr std::uint32_t least = 128;
    if (!placed.empty() && enough / 8 >= least) cut(placed, enough / 8);
  }
};

} // namespace

std::vector<SceneRange> SessionScene::ranges() const {
  Cutter cutter;
  cutter.cut(std::span<const Placed>(placed_), 8192);
  return std::move(cutter.found);
}

} // namespace rt::lang
