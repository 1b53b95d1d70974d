#include "tools/explain/naming.hpp"

#include <fmt/format.h>

namespace rt::tools::explain {
namespace {

std::string name_at(const scene::Scene& scene, scene::NameId id) {
  return scene.names[static_cast<std::size_t>(id)];
}

std::string with_place(const std::string& name, const std::string& place) {
  return place.empty() ? name : fmt::format("{} ({})", name, place);
}

} // namespace

std::vector<const scene::Object*> objects_on(const scene::Scene& scene, std::span<const std::uint32_t> path) {
  std::vector<const scene::Object*> found;
  const std::vector<scene::Object>* list = &scene.objects;
  for (const std::uint32_t position : path) {
    if (!list) break;
    const scene::Object& object = (*list)[position];
    found.push_back(&object);
    list = nullptr;
    if (object.shape.kind == scene::kind_of<scene::Group>) list = &scene.shapes.get<scene::Group>(object.shape).members;
    if (object.shape.kind == scene::kind_of<scene::Combination>)
      list = &scene.shapes.get<scene::Combination>(object.shape).operands;
  }
  return found;
}

const scene::Object* owner(const scene::Scene& scene, std::span<const std::uint32_t> path) {
  const auto objects = objects_on(scene, path);
  for (const scene::Object* object : objects)
    if (object->name != scene::no_name) return object;
  for (const scene::Object* object : objects)
    if (object->shape.kind == scene::kind_of<scene::Combination>) return object;
  return objects.empty() ? nullptr : objects.back();
}

std::string name_of(const scene::Scene& scene, const scene::Object& object) {
  if (object.name != scene::no_name) return fmt::format("`{}`", name_at(scene, object.name));
  if (object.shape.kind == scene::kind_of<scene::Combination>) {
    static constexpr std::string_view operations[] = {"union", "intersection", "difference"};
    return std::string(
        operations[static_cast<std::size_t>(scene.shapes.get<scene::Combination>(object.shape).operation)]);
  }
  return scene.shapes.visit(object.shape, [](const auto& shape) { return std::string(shape.noun); });
}

std::string name_of(const scene::Scene& scene, const scene::Light& light) {
  if (light.name != scene::no_name) return fmt::format("`{}`", name_at(scene, light.name));
  struct {
    std::string operator()(const scene::PointLight&) const { return "light"; }
    std::string operator()(const scene::SunLight&) const { return "sun"; }
    std::string operator()(const scene::SpotLight&) const { return "spot"; }
  } noun;
  return std::visit(noun, light.source);
}

std::string place_of(const scene::Scene& scene, scene::Origin origin) {
  if (origin.line == 0 || origin.file >= scene.files.size()) return {};
  return fmt::format("{}:{}", scene.files[origin.file], origin.line);
}

std::string describe(const scene::Scene& scene, std::span<const std::uint32_t> path) {
  std::string text;
  for (const scene::Object* object : objects_on(scene, path)) {
    if (!text.empty()) text += ", its ";
    text += with_place(name_of(scene, *object), place_of(scene, object->origin));
  }
  return text;
}

std::string describe(const scene::Scene& scene, const scene::Light& light) {
  return with_place(name_of(scene, light), place_of(scene, light.origin));
}

std::string title(const scene::Scene& scene, std::span<const std::uint32_t> path) {
  const scene::Object* const object = owner(scene, path);
  return object ? with_place(name_of(scene, *object), place_of(scene, object->origin)) : "?";
}

} // namespace rt::tools::explain
