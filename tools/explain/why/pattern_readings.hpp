#pragma once

#include "renderer/compile/compiled_scene.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace rt::tools::explain {

/// What one pattern shows at a point of a surface.
struct PatternReading {
  /// Of one whose value becomes a colour by stops.
  struct InStops {
    double value, place; ///< before and after frequency, phase and wave form
    double share;        ///< of the way from the stop before the place to the next
  };
  std::string_view property; ///< of the material
  int depth = 0;             ///< in how many other patterns it stands
  std::string_view noun;
  Vec3 point; ///< in its own space
  std::optional<InStops> in_stops;
  Color shown;
};

/// Of all patterns that a surface's material shows there, each before those that it shows.
std::vector<PatternReading> pattern_readings(const scene::Scene& scene, const Surface& surface);

/// Whether the surface's material bends its normal.
bool is_bumpy(const scene::Scene& scene, const Surface& surface);

} // namespace rt::tools::explain
