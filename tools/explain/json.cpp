#include "tools/explain/json.hpp"

#include "renderer/scene/names.hpp"
#include "tools/explain/naming.hpp"

namespace rt::tools::explain {

using json = nlohmann::ordered_json;

json with_place(const scene::Scene& scene, json named, scene::Origin origin) {
  if (origin.line != 0 && origin.file < scene.files.size())
    named["file"] = scene.files[origin.file], named["line"] = origin.line;
  return named;
}

json objects_json(const scene::Scene& scene, std::span<const std::uint32_t> path) {
  json objects = json::array();
  for (const scene::Object* object : objects_on(scene, path)) {
    json o{{"shape", scene.shapes.visit(object->shape, [](const auto& shape) { return std::string(shape.noun); })}};
    if (object->name != scene::no_name) o["name"] = scene::name(scene, object->name);
    objects.push_back(with_place(scene, std::move(o), object->origin));
  }
  return objects;
}

} // namespace rt::tools::explain
