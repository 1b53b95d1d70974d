#include "tools/explain/naming.hpp"

#include "renderer/scene/names.hpp"

#include <fmt/format.h>

namespace rt::tools::explain {
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
  if (object.name != scene::no_name) return fmt::format("`{}`", scene::name(scene, object.name));
  if (object.shape.kind == scene::kind_of<scene::Combination>) {
    return std::string(noun(scene.shapes.get<scene::Combination>(object.shape).operation));
  }
  return std::string(noun(scene.shapes, object.shape));
}

std::string name_of(const scene::Scene& scene, const scene::Light& light) {
  if (light.name != scene::no_name) return fmt::format("`{}`", scene::name(scene, light.name));
  return std::string(noun(light.source));
}

std::string Namer::place(scene::Origin origin) const {
  if (origin.line != 0 && origin.file < scene_.files.size() && scene_.files[origin.file] == file_)
    return fmt::format("line {}", origin.line);
  return place_text(scene_, origin);
}

std::string Namer::with_place(std::string name, scene::Origin origin) const {
  const std::string text = place(origin);
  return text.empty() ? name : fmt::format("{} ({})", name, text);
}

std::string Namer::object(const scene::Object& object) const {
  return with_place(name_of(scene_, object), object.origin);
}

std::string Namer::whole(std::span<const std::uint32_t> path) const {
  return whole(objects_on(scene_, path));
}

std::string Namer::whole(std::span<const scene::Object* const> objects) const {
  std::string text;
  for (const scene::Object* o : objects) text += (text.empty() ? "" : ", its ") + object(*o);
  return text;
}

std::string Namer::title(std::span<const std::uint32_t> path) const {
  const scene::Object* const o = owner(scene_, path);
  return o ? object(*o) : "?";
}

std::string Namer::light(std::uint32_t index) const {
  const scene::Light& light = scene_.lights[index];
  return with_place(name_of(scene_, light), light.origin);
}

} // namespace rt::tools::explain
