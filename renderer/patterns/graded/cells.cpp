#include "renderer/patterns/graded/cells.hpp"

#include "renderer/math/hashing.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Cells*) {
  static constexpr Field own[] = {
      field<&Cells::seed>("seed", {"0", "another number: other values", {.is_whole = true}}),
  };
  static constexpr auto table = with_graded(own);
  return table;
}

} // namespace rt::scene

namespace rt {

// The same small shift as the checker's.
double value_at(const scene::Cells& cells, const Vec3& p) {
  const Vec3 cell{std::floor(p.x + 1e-10), std::floor(p.y + 1e-10), std::floor(p.z + 1e-10)};
  const std::uint64_t hash = Hasher().add(static_cast<double>(cells.seed)).add(cell).value();
  return static_cast<double>(hash >> 11) * 0x1p-53;
}

} // namespace rt
