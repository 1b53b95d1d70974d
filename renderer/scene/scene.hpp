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

/// How light is followed: by Whitted's formula, by paths that solve the rendering equation, or not at all: how open
/// surfaces are.
enum class Mode : std::uint8_t { whitted, path, occlusion };
/// Their words, in the same order.
inline constexpr std::string_view mode_names[] = {"whitted", "path", "occlusion"};
constexpr std::string_view name(Mode mode) {
  return mode_names[static_cast<std::size_t>(mode)];
}

/// How much of the light around a pixel counts for it where samples are random, by its distance: evenly over the pixel,
/// or a bell 1.5 pixels wide to each side.
enum class PixelFilter : std::uint8_t { box, gaussian, blackman_harris };

/// The properties of the scene itself. What depends on the mode and was not written is empty.
struct Settings {
  Resolution size{800, 600};
  Color background = black;
  Color ambient = grey(0.1);
  std::optional<int> max_depth;
  std::optional<int> samples; ///< a square number in Whitted's mode
  // Absent where they are not written, so that the hash of a scene without them is what it was.
  std::optional<Mode> mode; ///< Whitted's
  std::optional<double> noise;
  std::optional<int> seed;           ///< 0
  std::optional<PixelFilter> filter; ///< Blackman and Harris's
  std::optional<double> reach;       ///< in `Mode::occlusion`: infinite
  std::optional<double> exposure;    ///< stops
  std::optional<Tone> tone;
  std::optional<double> min_weight;

  /// Whether paths are followed, and not Whitted's formula.
  bool is_path() const { return mode == Mode::path; }
  /// Whether a pixel is the mean of samples that are drawn at random.
  bool is_random() const { return mode && mode != Mode::whitted; }
};

/// All that a scene file says, as plain data: what evaluation yields and the compiler, the exporter and `rtlang scene`
/// read. Parameters stand as they were written; nothing is derived.
struct Scene : Settings {
  Camera camera;
  Origin camera_origin;
  std::vector<Light> lights;
  std::vector<Object> objects; ///< in order of declaration, which decides between equally distant hits

  Shapes shapes;
  std::vector<Material> materials;
  std::vector<Pattern> patterns;
  std::vector<Placement> transforms; ///< `at` unused: it is in the object
  std::vector<std::string> names;
  std::vector<std::string> files;
};

/// The side n of the grid of n × n samples in a pixel; nothing where `samples` is no square number.
std::optional<int> sample_grid(int samples);

/// How far weak rays that are not followed may move a pixel together, of white, in Whitted's mode: half a step of 8
/// bits if nothing is written.
double min_weight(const Settings&);

inline constexpr int most_samples = 65536;

/// How often each pixel is sampled, and how often a ray may be scattered, whatever was written.
int sample_count(const Settings& settings);
int depth_limit(const Settings& settings);
/// Samples of the picture in Whitted's mode, which is what some questions are about: 1 where the scene's mode is
/// another.
int whitted_samples(const Settings& settings);

/// How its pictures of 8 and 16 bits show its light.
ToneMapping tone_mapping(const Scene&);

/// The fields of the scene itself: `Settings`.
std::span<const Field> fields(const Scene*);
std::optional<Problem> check(const Scene&);

/// "scene.rtl:12"; empty where it was not written.
std::string place_text(const Scene& scene, Origin origin);

/// The object's placement in its parent, whole.
Placement placement(const Scene& scene, const Object& object);
/// The map from the object's own space to its parent's.
Affine to_parent(const Scene& scene, const Object& object);

/// The box around an object in its parent's space, and around all visible ones; infinite where a shape is, up to
/// rounding. Asking for many instances of a group one by one computes the group's box each time.
Box3 bounds(const Scene& scene, const Object& object);
Box3 bounds(const Scene& scene);
/// The box around the finite visible objects: what a camera that was not written frames. Empty where there are none.
Box3 finite_bounds(const Scene& scene);
/// Number of visible primitives (neither groups nor combinations' own nodes), instances counted each time; the largest
/// number there is where it would be more.
std::uint64_t count_primitives(const Scene& scene);

} // namespace rt::scene
