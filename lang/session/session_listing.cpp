#include "lang/session/session_listing.hpp"

#include "lang/session/session_text.hpp"
#include "renderer/scene/names.hpp"
#include "renderer/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace rt::lang {
namespace {

std::string point_text(const Vec3& v) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v.x, v.y, v.z);
}

template <class L>
std::string place_of(const L& light) {
  if constexpr (requires { light.at, light.look_at; })
    return fmt::format("{} to {}", point_text(light.at), point_text(light.look_at));
  else if constexpr (requires { light.at; })
    return "at " + point_text(light.at);
  else if constexpr (requires { light.direction; })
    return "along " + point_text(light.direction);
  else
    return {};
}

class Listing {
public:
  Listing(const Statement& statement, const scene::Scene& scene, const Program& program) : scene_(scene) {
    look_at(statement, program);
    for (const scene::Object& object : statement.made.objects) add(object);
    for (const scene::Light& light : statement.made.lights) add(light);
    if (const auto& camera = statement.made.camera)
      put("", "camera", fmt::format("{} to {}", point_text(camera->at), point_text(camera->look_at)));
  }

  std::vector<ListedObject> found;

private:
  // What the statement is a copy of: the name of a binding, or of a def.
  void look_at(const Statement& statement, const Program& program) {
    if (statement.nodes.size() != 1) return;
    const Ast& ast = statement.unit->ast;
    const NodeId base = innermost(ast, statement.nodes.front());
    if (ast.kind(base) != Kind::name) return;
    const std::string_view word = program.symbols.name(ast.symbol(base));
    if (resolution(ast[base]) == Resolution::function)
      kind_ = word;
    else if (resolution(ast[base]) == Resolution::local)
      name_ = word;
  }

  void add(const scene::Object& object) {
    const Box3 box = scene::bounds(scene_, object);
    const bool hides = !object.is_visible;
    put(own_name(object.name), kind_.empty() ? noun(scene_.shapes, object.shape) : kind_,
        (box.is_finite() ? "around " + point_text(box.center()) : std::string("endless")) +
            (hides ? ", not visible" : ""));
  }

  void add(const scene::Light& light) {
    put(own_name(light.name), noun(light.source),
        std::visit([](const auto& source) { return place_of(source); }, light.source));
  }

  std::string_view own_name(scene::NameId id) const { return id == scene::no_name ? name_ : scene::name(scene_, id); }

  void put(std::string_view name, std::string_view kind, std::string place) {
    if (name == kind_) name = {}; // a def's name is common to all its copies
    if (!found.empty() && found.back().kind == kind && found.back().name == name)
      ++found.back().count;
    else
      found.push_back({std::string(name), std::string(kind), std::move(place), 1});
  }

  const scene::Scene& scene_;
  std::string_view name_, kind_;
};

std::uint64_t item_count(const Statement& statement) {
  const Ast& ast = statement.unit->ast;
  std::uint64_t count = 0;
  for (const NodeId node : statement.nodes) count += ast.kind(node) == Kind::repeat ? ast.repeat(node).count : 1;
  return count;
}

} // namespace

std::vector<ListedObject> list_objects(const Statement& statement, const scene::Scene& scene, const Program& program) {
  return Listing(statement, scene, program).found;
}

Numbering::Range Numbering::next(const Statement& statement) {
  if (statement.declares()) return {};
  const std::vector<ListedObject> objects = list_objects(statement, scene_, program_);
  const bool has_names = std::none_of(objects.begin(), objects.end(), [](const auto& o) { return o.name.empty(); });
  if (has_names) return {};
  const Range range{last_ + 1, item_count(statement)};
  last_ += range.count;
  return range;
}

} // namespace rt::lang
