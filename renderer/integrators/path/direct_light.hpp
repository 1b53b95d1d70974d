#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/path/path_scene.hpp"
#include "renderer/integrators/path/scattering_point.hpp"
#include "renderer/integrators/ray_counts.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rt {

/// Direct light from lamps at a point: next event estimation.
class DirectLighting {
public:
  /// All must outlive it.
  DirectLighting(const PathScene& scene, RayCounts& counts)
      : path_scene_(scene), scene_(scene.scene), lamps_(scene.lamps), counts_(counts), walker_(scene.scene) {}

  /// What the lamps without size reflect off the point: from all of them if there are not too many, else from one that
  /// represents all, chosen with `number` by what it would contribute without shadows.
  Color from_lamps(const ScatteringPoint& at);
  Color from_one_lamp(const ScatteringPoint& at, double number);

  /// What the shapes that emit light reflect off the point, estimated by sampling one of them, weighted against hitting
  /// it by BSDF sampling. `numbers` are u and v on the lamp, and the choice.
  Color from_emitters(const ScatteringPoint& at, const std::array<double, 4>& numbers);

  /// The same for the lamps that have a size.
  Color from_sized_lamps(const ScatteringPoint& at, const std::array<double, 4>& numbers);

  /// Up to this many lamps are all sampled.
  static constexpr std::size_t few_lamps = 16;

private:
  struct LampLight;
  struct Sight;
  struct LampPoint;

  std::optional<LampLight> reached(const ScatteringPoint& at, const Light& lamp) const;
  Color unblocked(const ScatteringPoint& at, const Light& lamp, const LampLight& light);
  Color filtered(const ScatteringPoint& at, const LightSample& lamp);
  Sight sight_from(const ScatteringPoint& at, const Vec3& direction, double distance);
  std::optional<LampPoint> sight_of(std::uint32_t emitter, const EmitterSample& sample, const ScatteringPoint& at);
  std::optional<Color> sight_of_lamp(std::uint32_t lamp, const SizedLamps::Direction& way, const ScatteringPoint& at);
  void go_to(Sight& sight, double length) const;
  bool transmit_straight(Sight& sight, const Surface& surface);

  const PathScene& path_scene_;
  const CompiledScene& scene_;
  const Lamps& lamps_;
  RayCounts& counts_;
  TraceScratch scratch_;
  Walker walker_; // of shadow rays
  MaterialValues values_;
};

/// The balance heuristic: the weight of a strategy with this density against another.
constexpr double balance(double own, double other) {
  return own / (own + other);
}

} // namespace rt
