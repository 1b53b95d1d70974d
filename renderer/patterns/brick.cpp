#include "renderer/patterns/brick.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Brick*) {
  static constexpr Field table[] = {
      field<&Brick::mortar>("mortar", {"0.5", "colour, number or pattern of the joints", not_negative}),
      field<&Brick::color>("color",
                           {"linear_rgb(0.3, 0.05, 0.03)", "colour, number or pattern of a brick", not_negative}),
      field<&Brick::size>("size", {.default_text = "[0.6, 0.2, 0.3]",
                                   .help = "from one brick to the next, its mortar included",
                                   .constraint = positive,
                                   .type = FieldType::size}),
      field<&Brick::joint>("joint", {"0.03", "width of the mortar", not_negative}),
  };
  return table;
}

} // namespace rt::scene

namespace rt {
namespace {

// Whether what repeats after each `length` is in mortar there: it lies below whole multiples, and within the same small
// shift as the checker's of them.
bool is_joint(double at, double length, double joint, double shift) {
  const double shifted = (at + joint + 1e-10) / length + shift;
  return (shifted - std::floor(shifted)) * length <= joint;
}

} // namespace

scene::Paint paint_at(const scene::Brick& brick, const Vec3& p) {
  const Vec3& size = brick.size;
  if (is_joint(p.y, size.y, brick.joint, 0)) return brick.mortar;
  const double courses = std::floor((p.y + brick.joint + 1e-10) / size.y);
  const bool is_even = std::fmod(courses, 2) == 0;
  const bool is_mortar =
      is_joint(p.x, size.x, brick.joint, is_even ? 0 : 0.5) || is_joint(p.z, size.z, brick.joint, is_even ? 0.5 : 0);
  return is_mortar ? brick.mortar : brick.color;
}

} // namespace rt
