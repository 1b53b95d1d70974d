#include "tools/inspect/object_ids.hpp"

#include "renderer/scene/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace rt::tools {
namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

const scene::Group* group(const scene::Scene& scene, const scene::Object& object) {
  const bool is_group = object.shape.kind == scene::kind_of<scene::Group>;
  return is_group ? &scene.shapes.get<scene::Group>(object.shape) : nullptr;
}

} // namespace

ObjectIds::ObjectIds(const scene::Scene& scene)
    : scene_(scene), in_group_(scene.shapes.all<scene::Group>().size(), unknown) {
  firsts_.reserve(scene.objects.size() + 1);
  firsts_.push_back(1);
  for (const scene::Object& object : scene.objects) firsts_.push_back(firsts_.back() + count(object));
}

std::uint64_t ObjectIds::count(const scene::Object& object) const {
  if (!object.is_visible) return 0;
  const scene::Group* members = group(scene_, object);
  if (!members) return 1;
  std::uint64_t sum = in_group_[object.shape.index];
  if (sum != unknown) return sum;
  sum = 0;
  for (const scene::Object& member : members->members) sum += count(member);
  return in_group_[object.shape.index] = sum;
}

void ObjectIds::add_named(const scene::Object& object, std::uint64_t first, std::vector<NamedRange>& list) const {
  if (object.name != scene::no_name) {
    const std::string_view name = scene::name(scene_, object.name);
    const std::uint64_t n = count(object);
    if (n == 0) return;
    if (!list.empty() && list.back().name == name && list.back().ids.last + 1 == first)
      list.back().ids.last += n;
    else
      list.push_back({name, {first, first + n - 1}});
    return;
  }
  const scene::Group* members = object.is_visible ? group(scene_, object) : nullptr;
  if (!members) return;
  for (const scene::Object& member : members->members) {
    add_named(member, first, list);
    first += count(member);
  }
}

std::vector<ObjectIds::NamedRange> ObjectIds::manifest() const {
  std::vector<NamedRange> list;
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) add_named(scene_.objects[i], firsts_[i], list);
  return list;
}

std::string ObjectIds::name(std::uint64_t id) const {
  if (id == 0 || id >= firsts_.back()) return {};
  const auto i = static_cast<std::size_t>(std::upper_bound(firsts_.begin(), firsts_.end(), id) - firsts_.begin()) - 1;
  const scene::Object* object = &scene_.objects[i];
  std::uint64_t rest = id - firsts_[i];
  for (;;) {
    if (object->name != scene::no_name) return std::string(scene::name(scene_, object->name));
    const scene::Group* members = group(scene_, *object);
    if (!members) break;
    for (const scene::Object& member : members->members) {
      object = &member;
      const std::uint64_t n = count(member);
      if (rest < n) break;
      rest -= n;
    }
  }
  return scene_.shapes.visit(object->shape, [&](const auto& shape) { return fmt::format("{} {}", shape.noun, id); });
}

} // namespace rt::tools
