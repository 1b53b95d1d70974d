#include "lang/session/session_scene.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/session/session_text.hpp"
#include "renderer/math/hashing.hpp"
#include "renderer/scene/defaults.hpp"
#include "renderer/scene/names.hpp"

#include <fmt/format.h>

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

std::string point_text(const Vec3& v) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v.x, v.y, v.z);
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
  const scene::Scene defaults;
  scene.size = defaults.size;
  scene.background = defaults.background;
  scene.ambient = defaults.ambient;
  scene.max_depth = defaults.max_depth;
  scene.samples = defaults.samples;
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
  if (scene.lights.empty() && !has_ambient) assumptions_.push_back(errors::assumed_light({}, assume_light(scene)));
}

namespace {

// Cuts what statements placed into stretches. Where one ends depends on what is in it alone, so that it is found again
// when something else has changed: ends are sought once there are enough objects, and come by often enough. What is
// left behind the last end is cut into shorter ones, so that little is outside of all of them.
class Cutter {
public:
  template <class Placed>
  void cut(std::span<const Placed> placed, std::uint32_t enough) {
    Hasher hasher;
    std::size_t first = 0; // of the current range
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (placed[i].end - placed[i].begin >= enough / 4) { // is one by itself
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

namespace {

class Listing {
public:
  Listing(const scene::Scene& scene, const Program& program) : scene_(scene), program_(program) {}

  void add(const Statement& statement) {
    name_ = kind_ = {};
    look_at(statement);
    for (const scene::Object& object : statement.made.objects) add(object);
    for (const scene::Light& light : statement.made.lights) add(light);
    if (statement.made.camera)
      put("", "camera",
          fmt::format("{} to {}", point_text(statement.made.camera->at), point_text(statement.made.camera->look_at)));
    is_first_ = true;
  }

  std::vector<ListedObject> found;

private:
  // What the statement is a copy of: the name of a binding, or of a def.
  void look_at(const Statement& statement) {
    if (statement.nodes.size() != 1) return;
    const Ast& ast = statement.unit->ast;
    const NodeId base = innermost(ast, statement.nodes.front());
    if (ast.kind(base) != Kind::name) return;
    const std::string_view word = program_.symbols.name(ast.symbol(base));
    if (resolution(ast[base]) == Resolution::function)
      kind_ = word;
    else if (resolution(ast[base]) == Resolution::local)
      name_ = word;
  }

  void add(const scene::Object& object) {
    const std::string_view own =
        object.name == scene::no_name ? name_ : scene_.names[static_cast<std::size_t>(object.name)];
    const Box3 box = scene::bounds(scene_, object);
    const bool hides = !object.is_visible;
    put(own, kind_.empty() ? noun(scene_.shapes, object.shape) : kind_,
        (box.is_finite() ? "around " + point_text(box.center()) : std::string("endless")) +
            (hides ? ", not visible" : ""));
  }

  void add(const scene::Light& light) {
    const std::string_view own =
        light.name == scene::no_name ? name_ : scene_.names[static_cast<std::size_t>(light.name)];
    put(own, noun(light.source), std::visit([](const auto& source) { return place_of(source); }, light.source));
  }

  template <class L>
  static std::string place_of(const L& light) {
    if constexpr (requires { light.at, light.look_at; })
      return fmt::format("{} to {}", point_text(light.at), point_text(light.look_at));
    else if constexpr (requires { light.at; })
      return "at " + point_text(light.at);
    else if constexpr (requires { light.direction; })
      return "along " + point_text(light.direction);
    else
      return {};
  }

  void put(std::string_view name, std::string_view kind, std::string place) {
    const bool is_alike = !is_first_ && !found.empty() && found.back().kind == kind && found.back().name == name;
    is_first_ = false;
    if (is_alike)
      ++found.back().count;
    else
      found.push_back({std::string(name), std::string(kind), std::move(place), 1});
  }

  const scene::Scene& scene_;
  const Program& program_;
  std::string_view name_, kind_;
  bool is_first_ = true; // of its statement
};

} // namespace

std::vector<ListedObject> list_objects(const Document& document, const scene::Scene& scene, const Program& program) {
  Listing listing(scene, program);
  for (const StatementRef& statement : document) listing.add(*statement);
  return std::move(listing.found);
}

} // namespace rt::lang
