#include "renderer/scene/validation/media_conflicts.hpp"

#include <optional>
#include <set>
#include <utility>

namespace rt::scene {
namespace {

/// The objects of a list during its traversal, and the material that they inherit. Not recursive: scenes may be nested
/// arbitrarily deep.
struct ListFrame {
  std::span<const Object> objects;
  MaterialId inherited;
  std::size_t next = 0;
};

MaterialId material_of(const Object& object, MaterialId inherited) {
  return object.material == no_material ? inherited : object.material;
}

std::optional<double> ior_that_matters(const Scene& scene, MaterialId id) {
  if (id == no_material) return std::nullopt;
  const Material& material = scene.materials[static_cast<std::size_t>(id)];
  if (is_opaque(material) && !material.fresnel) return std::nullopt;
  return material.ior;
}

std::optional<MediaConflict> conflict_within(const Scene& scene, std::uint32_t combination, MaterialId inherited) {
  std::optional<double> first;
  std::vector<ListFrame> path{{scene.shapes.all<Combination>()[combination].operands, inherited}};
  while (!path.empty()) {
    ListFrame& frame = path.back();
    if (frame.next == frame.objects.size()) {
      path.pop_back();
      continue;
    }
    const Object& operand = frame.objects[frame.next++];
    const MaterialId material = material_of(operand, frame.inherited);
    if (refers_to_composite(operand.shape)) {
      path.push_back({parts(scene.shapes, operand.shape), material});
      continue;
    }
    const std::optional<double> ior = ior_that_matters(scene, material);
    if (!ior) continue;
    if (!first) first = ior;
    if (*ior != *first) return MediaConflict{combination, *first, *ior};
  }
  return std::nullopt;
}

} // namespace

std::vector<MediaConflict> media_conflicts(const Scene& scene, std::span<const Object> objects) {
  std::vector<MediaConflict> conflicts;
  if (scene.shapes.all<Combination>().empty()) return conflicts;
  std::set<std::pair<std::uint64_t, MaterialId>> seen;
  std::vector<ListFrame> path{{objects, no_material}};
  while (!path.empty()) {
    ListFrame& frame = path.back();
    if (frame.next == frame.objects.size()) {
      path.pop_back();
      continue;
    }
    const Object& object = frame.objects[frame.next++];
    if (!refers_to_composite(object.shape)) continue;
    const std::uint64_t key = std::uint64_t{object.shape.index} << 8 | object.shape.kind;
    const MaterialId inherited = frame.inherited, material = material_of(object, inherited);
    if (!seen.emplace(key, material).second) continue;
    if (object.shape.kind == kind_of<Group>)
      path.push_back({parts(scene.shapes, object.shape), material});
    else if (object.material == no_material)
      if (const auto conflict = conflict_within(scene, object.shape.index, inherited)) conflicts.push_back(*conflict);
  }
  return conflicts;
}

} // namespace rt::scene
