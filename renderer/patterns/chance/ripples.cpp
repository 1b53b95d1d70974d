#include "renderer/patterns/chance/ripples.hpp"

#include "renderer/math/degrees.hpp"
#include "renderer/math/hashing.hpp"

#include <algorithm>

namespace rt::scene {

std::span<const Field> fields(const Ripples*) {
  static constexpr Field own[] = {
      field<&Ripples::sources>("sources",
                               {"10", "points that waves run out from", {.min = 1, .max = 1000, .is_whole = true}}),
      field<&Ripples::spread>("spread", {"0", "how different the waves' lengths are", not_negative}),
      field<&Ripples::seed>("seed", {"0", "another number: other points", {.is_whole = true}}),
  };
  static constexpr auto table = with_graded(own);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Ripples& ripples, const Vec3& p) {
  double sum = 0, weights = 0;
  for (int i = 0; i < ripples.sources; ++i) {
    const auto random = [&](int k) {
      const std::uint64_t hash =
          Hasher().add(static_cast<double>(ripples.seed)).add(static_cast<double>(4 * i + k)).value();
      return static_cast<double>(hash >> 11) * 0x1p-53;
    };
    const Vec3 source{4 * random(0) - 2, 4 * random(1) - 2, 4 * random(2) - 2};
    const double shortest = 1 / (1 + ripples.spread), longest = 1 + ripples.spread;
    const double wave = shortest + (longest - shortest) * random(3);
    sum += wave * sin_degrees(360 * (length(p - source) / wave));
    weights += wave;
  }
  return std::clamp((1 + sum / weights) / 2, 0.0, 1.0);
}

} // namespace rt
