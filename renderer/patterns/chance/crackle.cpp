#include "renderer/patterns/chance/crackle.hpp"

#include "renderer/math/hashing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt::scene {

std::span<const Field> fields(const Crackle*) {
  static constexpr std::string_view measures[] = {"first", "second", "edge"};
  static constexpr Field own[] = {
      field<&Crackle::measure>("measure", {.default_text = "edge",
                                           .help = "the distance from the nearest point, from the second, or the "
                                                   "difference",
                                           .choices = measures}),
      field<&Crackle::seed>("seed", {"0", "another number: other points", {.is_whole = true}}),
  };
  static constexpr auto table = with_graded(own);
  return table;
}

} // namespace rt::scene

namespace rt {
namespace {

Vec3 point_in(int seed, const Vec3& cell) {
  const auto coordinate = [&](double axis) {
    return static_cast<double>(Hasher().add(static_cast<double>(seed)).add(axis).add(cell).value() >> 11) * 0x1p-53;
  };
  return cell + Vec3{coordinate(0), coordinate(1), coordinate(2)};
}

} // namespace

// Cells are looked at ring by ring about the one that p is in; a point in the ring k is at least k − 1 away.
CellDistances cell_distances(int seed, const Vec3& p) {
  const Vec3 middle{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CellDistances found{infinity, infinity};
  for (int ring = 0; ring <= 3 && ring - 1 < found.second; ++ring) {
    for (int x = -ring; x <= ring; ++x)
      for (int y = -ring; y <= ring; ++y) {
        const bool is_side = std::max(std::abs(x), std::abs(y)) == ring;
        for (int z = -ring; z <= ring; z += is_side || ring == 0 ? 1 : 2 * ring) {
          const Vec3 cell = middle + Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          const double distance = length(p - point_in(seed, cell));
          found.second = std::min(found.second, std::max(found.first, distance));
          found.first = std::min(found.first, distance);
        }
      }
  }
  return found;
}

double value_at(const scene::Crackle& crackle, const Vec3& p) {
  const CellDistances distances = cell_distances(crackle.seed, p);
  switch (crackle.measure) {
  case scene::Crackle::Measure::first:
    return std::min(distances.first, 1.0);
  case scene::Crackle::Measure::second:
    return std::min(distances.second, 1.0);
  case scene::Crackle::Measure::edge:
    break;
  }
  return std::min(distances.second - distances.first, 1.0);
}

} // namespace rt
