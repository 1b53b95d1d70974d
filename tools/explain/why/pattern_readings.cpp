#include "tools/explain/why/pattern_readings.hpp"

#include "renderer/scene/names.hpp"
#include "renderer/shading/materials.hpp"

namespace rt::tools::explain {
namespace {

class PatternReader {
public:
  PatternReader(const scene::Scene& scene, const Vec3& point) : scene_(scene), point_(point) {}

  void read(std::string_view property, scene::PatternId id) {
    property_ = property;
    shown(id, 0);
  }
  std::vector<PatternReading> readings;

private:
  Color shown(const scene::Paint& paint, int depth) {
    if (const Color* color = std::get_if<Color>(&paint)) return *color;
    const scene::Pattern& pattern = scene_.patterns[static_cast<std::size_t>(std::get<scene::PatternId>(paint))];
    const Vec3 q = inverse(matrix(pattern.placement)).value_or(Affine{}).point(point_);
    const std::size_t i = readings.size();
    readings.push_back({property_, depth, noun(pattern.layout), q, {}, black});
    const Color color = std::visit([&](const auto& layout) { return shown(layout, q, i); }, pattern.layout);
    return readings[i].shown = color;
  }

  template <class P>
  Color shown(const P& layout, const Vec3& q, std::size_t i) {
    const int depth = readings[i].depth + 1;
    if constexpr (scene::IsGraded<P>) {
      const double value = value_at(layout, q), place = place_in_stops(layout, value);
      const PaintBlend blend = blend_at(layout, place);
      readings[i].in_stops = {value, place, blend.share};
      const Color first = shown(blend.first, depth);
      return blend.share == 0 ? first : first * (1 - blend.share) + shown(blend.second, depth) * blend.share;
    } else {
      return shown(paint_at(layout, q), depth);
    }
  }

  const scene::Scene& scene_;
  Vec3 point_;
  std::string_view property_;
};

// Null: the default.
const scene::Material* material_of(const scene::Scene& scene, const Surface& surface) {
  const bool is_default = surface.material_id == Materials::default_material();
  return is_default ? nullptr : &scene.materials[surface.material_id - 1];
}

} // namespace

std::vector<PatternReading> pattern_readings(const scene::Scene& scene, const Surface& surface) {
  PatternReader reader(scene, surface.pattern_point);
  if (const scene::Material* material = material_of(scene, surface))
    for (const scene::Field& field : fields(material))
      for_each_pattern({&field, 1}, material, [&](scene::PatternId id) { reader.read(field.name, id); });
  return std::move(reader.readings);
}

bool is_bumpy(const scene::Scene& scene, const Surface& surface) {
  const scene::Material* material = material_of(scene, surface);
  return material && std::holds_alternative<scene::PatternId>(material->bump);
}

} // namespace rt::tools::explain
