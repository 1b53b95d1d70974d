#pragma once

#include "renderer/integrators/integrator.hpp"
#include "renderer/render/film.hpp"
#include "renderer/scene/scene.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

namespace rt {

/// What is known while a picture is being rendered.
struct Progress {
  double fraction = 0;              ///< of all tiles, 0 to 1
  std::uint64_t rays = 0;           ///< traced so far, of every kind
  double seconds = 0;               ///< since tracing began
  int samples = 0;                  ///< per pixel, with random samples
  std::optional<double> noise = {}; ///< of the noisiest block, once it is known
};

/// A fraction of the samples of a picture with random samples, in pairs of one for each half: those for which
/// ⌊sample/2⌋ mod `count` is `index` − 1. All parts of one count add up to the whole.
struct SamplePart {
  int index = 1, count = 1;
  bool is_whole() const { return count == 1; }
  friend bool operator==(const SamplePart&, const SamplePart&) = default;
};

struct RenderOptions {
  int threads = 0;                  ///< 0: one per core
  std::optional<PixelRect> crop;    ///< the film holds only this part of the picture; within the scene's resolution
  bool layers = false;              ///< fill the film's layers
  std::optional<double> time_limit; ///< seconds: with random samples no pass is started that would exceed it
  SamplePart part = {};             ///< with random samples
  bool sums = false;                ///< with random samples: the film keeps its sums
  const Film* earlier = nullptr;    ///< with random samples: sums of the same part, to which samples are added
  IntegratorKind integrator = IntegratorKind::whitted; ///< in Whitted mode
  const std::atomic<bool>* stop = nullptr; ///< set from outside (a signal handler): rendering ends within a tile
  std::function<void(const Progress&)> on_progress; ///< called by one thread at a time, a few times a second
  /// Called for each finished tile, by one thread at a time: these pixels of the film have their values; others may be
  /// written meanwhile. The rectangle is in the film's coordinates, even if that is a crop.
  std::function<void(const Film&, const PixelRect&)> on_tile;
};

struct RenderStatistics {
  std::uint64_t primitives = 0;
  RayCounts rays;
  double build_seconds = 0; ///< compiling the description and building the acceleration structure
  double trace_seconds = 0;
  int threads = 0;
  double samples = 0;          ///< per pixel, on average
  std::optional<double> noise; ///< with random samples, of the noisiest block: see `NoiseBlocks`
  /// With random samples: those that were not finite and count as black; and the first pixel that has one, in the whole
  /// picture, row by row, with the id of the object at its centre (0: none).
  struct Dropped {
    std::uint64_t samples;
    int x, y;
    std::uint32_t object_id;
  };
  std::optional<Dropped> dropped = {};
};

struct Rendered {
  Film film;
  RenderStatistics statistics;
  bool is_complete = true; ///< false if stopped: the tiles not traced are black, and before the first there is no film
};

/// The whole pipeline from description to picture. The same bytes for any number of threads.
Rendered render(const scene::Scene& scene, const RenderOptions& options);

class CompiledScene;

/// How a compiled scene is to be viewed.
struct View {
  scene::Camera camera;
  scene::Resolution size{};
  int samples = 1; ///< a square number in Whitted mode
  ToneMapping tone_mapping = {};
  scene::Mode mode = scene::Mode::whitted;
  int seed = 0; ///< this and the following with random samples only
  scene::PixelFilter filter = scene::PixelFilter::blackman_harris;
  double noise = 0; ///< at which a part of the picture needs no more samples
};
/// As the scene says; and in Whitted mode regardless, for comparisons.
View view_of(const scene::Scene& scene);
View whitted_view_of(const scene::Scene& scene);
/// Sets colour, error and samples of a film's pixels from its sums.
void show_sums(Film& film, bool has_error);
/// The memory that the sums take besides the film.
std::uint64_t sums_bytes(const PixelRect& rect);

/// The same for a compiled scene; its primitives and build time are not reported.
Rendered render(const CompiledScene& scene, const View& view, const RenderOptions& options);

} // namespace rt
