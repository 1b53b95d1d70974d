#pragma once

#include "renderer/math/tone_mapping.hpp"
#include "renderer/scene/camera.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/scene/object.hpp"
#include "renderer/scene/pattern.hpp"
#include "renderer/scene/shapes.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace rt::scene {

/// How light is computed: by Whitted's model, by path tracing, which solves the rendering equation, or not at all:
/// ambient occlusion.
enum class Mode : std::uint8_t { whitted, path, occlusion };
/// Their words, in the same order.
inline constexpr std::string_view mode_names[] = {"whitted", "path", "occlusion"};
constexpr std::string_view name(Mode mode) {
  return mode_names[static_cast<std::size_t>(mode)];
}

/// The pixel filter for random samples: constant over the pixel, or a bell with a radius of 1.5
/// pixels.
enum class PixelFilter : std::uint8_t { box, gaussian, blackman_harris };

/// The properties of the scene itself. What depends on the mode and was not specified is empty.
struct Settings {
  Resolution size{800, 600};
  Color background = black;
  Color ambient = grey(0.1);
  std::optional<int> max_depth;
  std::optional<int> samples; ///< a square number in Whitted mode
  // Absent if not specified, so that the hash of a scene without them is stable.
  std::optional<Mode> mode; ///< Whitted's
  std::optional<double> noise;
  std::optional<int> seed;           ///< 0
  std::optional<PixelFilter> filter; ///< Blackman and Harris's
  std::optional<double> reach;       ///< in `Mode::occlusion`: infinite
  std::optional<double> exposure;    ///< stops
  std::optional<Tone> tone;
  std::optional<double> min_weight;

  /// Whether light is computed by path tracing rather than by Whitted's model.
  bool is_path() const { return mode == Mode::path; }
  /// Whether a pixel is the mean of random samples.
  bool is_random() const { return mode && mode != Mode::whitted; }
};

/// Everything that a scene file says, as plain data: what evaluation produces and the compiler, the exporter and
/// `rtlang scene` read. Parameters are kept as written; nothing is derived.
struct Scene : Settings {
  Camera camera;
  Origin camera_origin;
  std::vector<Light> lights;
  std::vector<Object> objects; ///< in order of declaration, which breaks ties between equally distant hits

  Shapes shapes;
  std::vector<Material> materials;
  std::vector<Pattern> patterns;
  std::vector<Placement> transforms; ///< `at` unused: it is in the object
  std::vector<std::string> names;
  std::vector<std::string> files;
};

/// The side n of the grid of n × n samples in a pixel; nothing if `samples` is not a square number.
std::optional<int> sample_grid(int samples);

/// How far all weak rays that are not traced may together change a pixel, as a fraction of white, in Whitted mode: half
/// a step of 8 bits by default.
double min_weight(const Settings&);

inline constexpr int most_samples = 65536;

/// The samples per pixel, and the depth limit of rays, with defaults.
int sample_count(const Settings& settings);
int depth_limit(const Settings& settings);
/// Samples per pixel in Whitted mode, which some queries refer to: 1 if the scene's mode is
/// another.
int whitted_samples(const Settings& settings);

/// How its pictures of 8 and 16 bits show linear light.
ToneMapping tone_mapping(const Scene&);

/// The fields of the scene itself: `Settings`.
std::span<const Field> fields(const Scene*);
std::optional<Problem> check(const Scene&);

/// "scene.rtl:12"; empty if it was not written.
std::string place_text(const Scene& scene, Origin origin);

/// The object's complete placement in its parent.
Placement placement(const Scene& scene, const Object& object);
/// The map from object space to its parent's space.
Affine to_parent(const Scene& scene, const Object& object);

/// The bounding box of an object in its parent's space, and of all visible ones; infinite where a shape is, up to
/// rounding. Calling this for many instances of a group one by one computes the group's box each time.
Box3 bounds(const Scene& scene, const Object& object);
Box3 bounds(const Scene& scene);
/// The bounding box of the finite visible objects: what a default camera frames. Empty if there are none.
Box3 finite_bounds(const Scene& scene);
/// Number of visible primitives (neither groups nor combinations' own nodes), counting every instance; saturates at the
/// largest value.
std::uint64_t count_primitives(const Scene& scene);

} // namespace rt::scene
