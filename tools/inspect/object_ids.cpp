#include "tools/inspect/object_ids.hpp"

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

std::string ObjectIds::name(std::uint64_t id) const {
  if (id == 0 || id >= firsts_.back()) return {};
  const auto i = static_cast<std::size_t>(std::upper_bound(firsts_.begin(), firsts_.end(), id) - firsts_.begin()) - 1;
  const scene::Object* object = &scene_.objects[i];
  std::uint64_t rest = id - firsts_[i];
  for (;;) {
    if (object->name != scene::no_name) return scene_.names[static_cast<std::size_t>(object->name)];
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
