#pragma once

#include "tools/oracle/features.hpp"
#include "tools/oracle/generate.hpp"
#include "tools/povray/compare/compare.hpp"

#include <algorithm>
#include <functional>
#include <optional>

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

/// A scene that POV-Ray cannot compute exactly, as the exporter said: it is left out of the comparison.
struct Refusal {
  std::size_t scene = 0;
  std::string why;
};

/// A pixel of another colour that has an explanation.
struct Explained {
  std::size_t scene = 0;
  povray::Outlier pixel;
};

struct RunResult {
  std::size_t scenes = 0;  ///< that were compared
  std::size_t samples = 0; ///< pixels, or rays
  std::size_t depths = 0, depths_beyond_p999 = 0;
  double depth_max = 0, normal_max = 0;
  std::size_t id_mismatches = 0; ///< another object, or a hit for a miss; explained ones too
  std::size_t ids_unexplained = 0;
  std::size_t color_equal = 0, color_explained_by_limits = 0, color_explained_by_rounding = 0, color_unexplained = 0;
  double color_max = 0; ///< of the pixels without explanation
  Coverage coverage;
  std::vector<Failure> failures;    ///< by the scene's number
  std::vector<Refusal> refusals;    ///< the same
  std::vector<Explained> explained; ///< the same

  /// Adds a scene that was compared, with what was found of its hits: a Comparison or a RunResult.
  template <class Counts>
  void add_geometry(const Counts& one, const std::vector<std::size_t>& features) {
    ++scenes;
    depths += one.depths;
    depths_beyond_p999 += one.depths_beyond_p999;
    depth_max = std::max(depth_max, one.depth_max);
    normal_max = std::max(normal_max, one.normal_max);
    id_mismatches += one.id_mismatches;
    ids_unexplained += one.ids_unexplained;
    coverage.add(features);
  }
};

/// Whole pictures: ids, distances, normals and colours.
RunResult run_colors(const RunSettings& settings);
/// Distances and normals along random rays, through POV-Ray's `trace`, many scenes in one run of it.
RunResult run_geometry(const RunSettings& settings);

/// Why POV-Ray cannot compute the scene exactly; nothing if it can.
std::optional<std::string> refusal(const scene::Scene& scene);

/// A table of the result, the features and, if wanted, each pair of them.
std::string report(const RunResult& result, Mode mode, bool all_pairs);
/// A line for each pixel whose colour differs with an explanation.
std::string list_explained(const RunResult& result);
/// Whether all bounds hold, every feature occurred and no more than one scene in a hundred was refused.
bool holds(const RunResult& result, Mode mode);

/// The file of a run's scene.
Block random_file(const RunSettings& settings, std::size_t number, Mode mode);

/// Puts what a run found in the order of its scenes, and makes the first failures small.
void finish(RunResult& result, const RunSettings& settings, const std::function<void(Failure&)>& make_small);

/// Makes the failing file as small as it can be while it loads, can be computed exactly by POV-Ray and `fails` in some
/// way, not necessarily the same.
void minimise(Failure& failure, const Block& file, const std::function<bool(scene::Scene&)>& fails);

/// The description of a generated file. Throws std::runtime_error with the first diagnostic if it does not load.
scene::Scene load(const std::string& text);

} // namespace rt::tools::oracle
