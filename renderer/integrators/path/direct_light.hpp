#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/path/lobes.hpp"
#include "renderer/integrators/ray_counts.hpp"
#include "renderer/lighting/lamps.hpp"

#include <array>
#include <optional>
#include <vector>

namespace rt {

/// A point of a surface that scatters light in all directions.
struct DiffusePoint {
  const Surface& surface;
  Vec3 normal;               ///< the shading normal, turned to the viewer
  Color albedo;              ///< of Lambert's reflection
  double share;              ///< the probability with which the path goes on by it
  const MediumStacks& media; ///< where `inside` is
  MediumStacks::List inside; ///< the solids that the point is seen from the inside of

  /// How densely the path goes on in a direction, per solid angle.
  double density(const Vec3& direction) const;
};

/// What lamps give to a point, without further surfaces: next event estimation.
class DirectLighting {
public:
  /// All must outlive it.
  DirectLighting(const CompiledScene& scene, const Lamps& lamps, TraceScratch& scratch, RayCounts& counts)
      : scene_(scene), lamps_(lamps), scratch_(scratch), counts_(counts) {}

  /// What the lamps without size reflect off the point: from all of them, if there are not too many, or from one that
  /// stands for all, picked for `number` by what it would give without shadows.
  Color from_lamps(const DiffusePoint& at);
  Color from_one_lamp(const DiffusePoint& at, double number);

  /// What the shapes that shine reflect off the point, estimated by asking one of them, weighted against finding it by
  /// chance. `numbers` are u and v on the lamp, and the choice.
  Color from_emitters(const DiffusePoint& at, const std::array<double, 4>& numbers);

  /// The same for the lamps that have a size.
  Color from_sized_lamps(const DiffusePoint& at, const std::array<double, 4>& numbers);

  /// Up to this many lamps all are asked.
  static constexpr std::size_t few_lamps = 16;

private:
  struct LampLight;
  struct Sight;

  std::optional<LampLight> reached(const DiffusePoint& at, const Light& lamp) const;
  Color unblocked(const DiffusePoint& at, const Light& lamp, const LampLight& light);
  std::optional<Sight> sight_of(std::uint32_t emitter, const EmitterSample& sample, const DiffusePoint& at);
  bool pass(Sight& sight, MediumStacks::List& inside);
  std::optional<Color> sight_of_lamp(std::uint32_t lamp, const SizedLamps::Direction& way, const DiffusePoint& at);
  MediumStacks::List surroundings(const DiffusePoint& at);

  const CompiledScene& scene_;
  const Lamps& lamps_;
  TraceScratch& scratch_;
  RayCounts& counts_;
  MediumStacks media_; // of the rays to lamps
  MaterialValues values_;
};

/// The balance heuristic: the weight of a strategy with this density against another.
constexpr double balance(double own, double other) {
  return own / (own + other);
}

} // namespace rt
