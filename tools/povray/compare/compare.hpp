#pragma once

#include "tools/povray/run/shots.hpp"

#include <array>

/// Our picture against POV-Ray's, pixel by pixel.
namespace rt::tools::povray {

/// The required bounds. Each is a line of the table, and can be set by its name with `--gate NAME=VALUE`.
struct Gates {
  double ids = 0;               ///< the most unexplained pixels that may show a different object
  double depth = 1e-9;          ///< largest relative difference of distance, unexplained
  double depth_p999 = 1e-12;    ///< the same, for 99.9 % of the pixels
  double normals = 1e-6;        ///< largest angle between normals, radians, unexplained
  double color = 1e-5;          ///< a colour within this of POV-Ray's (of 1, or of itself if it is brighter) is equal
  double color_share = 0.99;    ///< at least this fraction of the pixels is equal, or all but one
  double color_unexplained = 0; ///< the most of the others that may have no explanation
};

/// The gates' names and members, for parsing and printing.
struct GateName {
  const char* name;
  double Gates::*value;
  const char* meaning;
};
std::array<GateName, 7> gate_names();

/// Why a pixel differs.
enum class Cause : std::uint8_t {
  edge,        ///< a different object is hit
  depth,       ///< the same object at a different distance
  normal,      ///< with a different normal
  shading,     ///< only the colour differs
  tangency,    ///< explained: a ray 1e-9 beside this one hits the other object
  coincidence, ///< explained: the other object's surface is as near, within 1e-6
  tolerance,   ///< explained: retraced by POV-Ray's own rules the pixel agrees
  rounding,    ///< explained: with rays rotated by at most 1e-12 it agrees
};
const char* cause_name(Cause cause);
constexpr bool is_explained(Cause cause) {
  return cause >= Cause::tangency;
}

/// A pixel that is not equal.
struct Outlier {
  int x = 0, y = 0;
  Cause cause = Cause::shading;
  std::uint32_t our_id = 0, their_id = 0;
  double depth_error = 0;  ///< relative
  double normal_error = 0; ///< radians
  double color_error = 0;  ///< as for `Gates::color`
  Rgb32 ours, theirs;
  bool is_traced_again = false;
  Rgb32 again{}; ///< our colour by POV-Ray's rules, if needed
};

struct Comparison {
  int width = 0, height = 0;
  std::vector<float> color_error, depth_error, normal_error; ///< of each pixel
  std::vector<Outlier> outliers;                             ///< worst first: unexplained, then by colour difference
  std::size_t pixels = 0;
  std::size_t id_mismatches = 0, ids_unexplained = 0;
  std::size_t depths = 0; ///< pixels in which both hit the same object
  double depth_max = 0;   ///< of those that are not explained
  double depth_p999 = 0;
  std::size_t depths_beyond_p999 = 0; ///< pixels whose error is above `Gates::depth_p999`
  double normal_max = 0;              ///< of those that are not explained
  bool has_normals = true;
  std::size_t color_equal = 0;       ///< within `Gates::color`
  std::size_t color_within_8bit = 0; ///< within 1/255
  std::size_t color_unexplained = 0;
  std::size_t color_unstable = 0; ///< explained by rounding alone
  double color_max = 0;
  int color_max_x = 0, color_max_y = 0;
};

/// `film` must have layers and the size of `shots`; both are of `scene`, which is retraced where they differ.
Comparison compare(const scene::Scene& scene, const Film& film, const Shots& shots, const Gates& gates = {});

/// One line of the result.
struct Verdict {
  std::string name, meaning;
  double value = 0, gate = 0;
  bool at_least = false; ///< the gate is a lower bound
  bool is_measured = true;
  bool holds() const { return !is_measured || (at_least ? value >= gate : value <= gate); }
};
std::vector<Verdict> judge(const Comparison& comparison, const Gates& gates);
bool all_hold(const std::vector<Verdict>& verdicts);

} // namespace rt::tools::povray
