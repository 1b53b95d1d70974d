#pragma once

#include "tools/oracle/features.hpp"
#include "tools/oracle/generate.hpp"
#include "tools/povray/compare.hpp"

#include <functional>

/// Random scenes, many of them, against POV-Ray.
namespace rt::tools::oracle {

struct RunSettings {
  std::uint64_t seed = 1;
  std::size_t first = 0, scenes = 500; ///< numbers of the run's scenes; each has a seed of its own
  int at_once = 64;                    ///< how many POV-Rays work at the same time
  int width = 32, height = 24;         ///< of a picture
  int rays = 64;                       ///< for each scene's geometry
  std::size_t keep_failures = 5;       ///< so many failing scenes are made small
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::size_t done)> on_progress;
};

struct Failure {
  std::size_t scene = 0; ///< its number
  std::string what;      ///< one line
  std::string text;      ///< the scene, as small as it could be made where `keep_failures` allowed that
};

struct RunResult {
  std::size_t scenes = 0;
  std::size_t samples = 0; ///< pixels, or rays
  std::size_t depths = 0, depths_beyond_p999 = 0;
  double depth_max = 0, normal_max = 0;
  std::size_t id_mismatches = 0; ///< another object, or a hit for a miss; explained ones too
  std::size_t ids_unexplained = 0;
  std::size_t color_equal = 0, color_explained_by_limits = 0, color_explained_by_rounding = 0, color_unexplained = 0;
  double color_max = 0; ///< of the pixels without explanation
  Coverage coverage;
  std::vector<Failure> failures; ///< by the scene's number
};

/// Whole pictures: ids, distances, normals and colours.
RunResult run_colors(const RunSettings& settings);
/// Distances and normals along random rays, through POV-Ray's `trace`, many scenes in one run of it.
RunResult run_geometry(const RunSettings& settings);

/// A table of the result, the features and, if wanted, each pair of them.
std::string report(const RunResult& result, Mode mode, bool all_pairs);
/// Whether all bounds hold and every feature occurred.
bool holds(const RunResult& result, Mode mode);

/// The description of a generated file. Throws std::runtime_error with the first diagnostic if it does not load.
scene::Scene load(const std::string& text);

} // namespace rt::tools::oracle
