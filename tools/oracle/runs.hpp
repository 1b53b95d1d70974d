#pragma once

#include "tools/oracle/features.hpp"
#include "tools/oracle/generate.hpp"
#include "tools/povray/compare/compare.hpp"

#include <algorithm>
#include <functional>
#include <optional>

/// Many random scenes, compared with POV-Ray.
namespace rt::tools::oracle {

struct RunSettings {
  std::uint64_t seed = 1;
  std::size_t first = 0, scenes = 500; ///< indices of the run's scenes; each has a seed of its own
  int at_once = 64;                    ///< how many instances of POV-Ray run concurrently
  int width = 32, height = 24;         ///< of a picture
  int rays = 64;                       ///< for each scene's geometry
  std::size_t keep_failures = 5;       ///< how many failing scenes are minimised
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::size_t done)> on_progress;
};

struct Failure {
  std::size_t scene = 0; ///< its number
  std::string what;      ///< one line
  std::string text;      ///< the scene, minimised if `keep_failures` allowed it
};

/// A scene that POV-Ray cannot compute exactly, according to the exporter: it is not compared.
struct Refusal {
  std::size_t scene = 0;
  std::string why;
};

/// A pixel with a different colour that has an explanation.
struct Explained {
  std::size_t scene = 0;
  povray::Outlier pixel;
};

struct RunResult {
  std::size_t scenes = 0;  ///< that were compared
  std::size_t samples = 0; ///< pixels, or rays
  std::size_t depths = 0, depths_beyond_p999 = 0;
  double depth_max = 0, normal_max = 0;
  std::size_t id_mismatches = 0; ///< a different object, or a hit instead of a miss; including explained ones
  std::size_t ids_unexplained = 0;
  std::size_t color_equal = 0, color_explained_by_limits = 0, color_explained_by_rounding = 0, color_unexplained = 0;
  double color_max = 0; ///< of the pixels without explanation
  Coverage coverage;
  std::vector<Failure> failures;    ///< by the scene's index
  std::vector<Refusal> refusals;    ///< the same
  std::vector<Explained> explained; ///< the same

  /// Adds a compared scene, with the counts of its hits: a Comparison or a RunResult.
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
/// Distances and normals along random rays, with POV-Ray's `trace`, many scenes per run.
RunResult run_geometry(const RunSettings& settings);

/// Why POV-Ray cannot compute the scene exactly; nothing if it can.
std::optional<std::string> refusal(const scene::Scene& scene);

/// A table of the result, the features and, if wanted, each pair of them.
std::string report(const RunResult& result, Mode mode, bool all_pairs);
/// A line for each pixel whose colour differs with an explanation.
std::string list_explained(const RunResult& result);
/// Whether all bounds are satisfied, every feature occurred and at most one scene in a hundred was refused.
bool holds(const RunResult& result, Mode mode);

/// The file of a run's scene.
Block random_file(const RunSettings& settings, std::size_t number, Mode mode);

/// Sorts what a run found by scene, and minimises the first failures.
void finish(RunResult& result, const RunSettings& settings, const std::function<void(Failure&)>& make_small);

/// Minimises the failing file, keeping it loadable, exactly computable by POV-Ray and failing in some way, not
/// necessarily the same.
void minimise(Failure& failure, const Block& file, const std::function<bool(scene::Scene&)>& fails);

/// The description of a generated file. Throws std::runtime_error with the first diagnostic if it does not load.
scene::Scene load(const std::string& text);

} // namespace rt::tools::oracle
