#include "lang/evaluate/evaluator.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace rt::lang {
namespace {

using scene::MaterialId;

/// Looks through the scene for combinations whose parts that refract, or mirror by Fresnel's equations, disagree about
/// what is inside.
class MediaCheck {
public:
  explicit MediaCheck(const scene::Scene& scene) : scene_(scene) {}

  struct Conflict {
    std::uint32_t combination;
    double first, second;
  };
  std::vector<Conflict> conflicts;

  void visit(const std::vector<scene::Object>& objects, MaterialId inherited) {
    for (const scene::Object& object : objects) {
      const MaterialId material = object.material == scene::no_material ? inherited : object.material;
      const scene::ShapeRef shape = object.shape;
      const bool is_group = shape.kind == scene::kind_of<scene::Group>;
      if (!is_group && shape.kind != scene::kind_of<scene::Combination>) continue;
      if (!seen_.emplace(shape.index * 2 + (is_group ? 1U : 0U), static_cast<std::uint32_t>(material)).second) continue;
      if (is_group)
        visit(scene_.shapes.get<scene::Group>(shape).members, material);
      else if (object.material == scene::no_material)
        compare_parts(shape.index, inherited);
    }
  }

private:
  void compare_parts(std::uint32_t combination, MaterialId inherited) {
    first_ = second_ = 0;
    collect(scene_.shapes.all<scene::Combination>()[combination].operands, inherited);
    if (second_ != 0) conflicts.push_back({combination, first_, second_});
  }

  void collect(const std::vector<scene::Object>& operands, MaterialId inherited) {
    for (const scene::Object& operand : operands) {
      if (second_ != 0) return;
      const MaterialId material = operand.material == scene::no_material ? inherited : operand.material;
      if (operand.shape.kind == scene::kind_of<scene::Combination>) {
        collect(scene_.shapes.get<scene::Combination>(operand.shape).operands, material);
        continue;
      }
      if (material == scene::no_material) continue;
      const scene::Material& m = scene_.materials[static_cast<std::size_t>(material)];
      if (m.refract == 0 && !m.fresnel) continue;
      if (first_ == 0)
        first_ = m.ior;
      else if (m.ior != first_)
        second_ = m.ior;
    }
  }

  const scene::Scene& scene_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen_;
  double first_ = 0, second_ = 0; // indices of refraction, which are never 0
};

} // namespace

void Evaluator::check_media(const std::vector<scene::Object>& objects) {
  if (scene_.shapes.all<scene::Combination>().empty()) return;
  MediaCheck check(scene_);
  check.visit(objects, scene::no_material);
  for (const MediaCheck::Conflict& conflict : check.conflicts) {
    fail("E0408", combination_places_[conflict.combination],
         "the parts of this solid refract differently, and one solid is one medium",
         fmt::format("`ior` is {} in one part and {} in another", format_number(conflict.first),
                     format_number(conflict.second)),
         "give the whole a material, or its parts the same `ior`");
  }
}

} // namespace rt::lang
