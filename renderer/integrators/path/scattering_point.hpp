#pragma once

#include "renderer/integrators/path/path_scene.hpp"
#include "renderer/integrators/path/walk.hpp"
#include "renderer/sampling/mappings.hpp"
#include "renderer/scattering/bsdf.hpp"

#include <cmath>

namespace rt {

/// Where a path hits a surface, and how it scatters light there.
struct ScatteringPoint {
  Surface surface;
  TangentFrame frame; ///< about the shading normal, facing the viewer
  Bsdf bsdf;
  bool is_boundary;     ///< it bounds a medium
  const Walker* walker; ///< that arrived there
  Walk walk;

  /// The radiance towards the viewer per unit radiance and solid angle of light from `direction`: BSDF times cosine.
  Color reflected(const Vec3& direction) const {
    const Vec3 wi = frame.local(direction);
    return bsdf.evaluate(wi) * std::abs(wi.z);
  }
  /// The density, per solid angle, with which a path continues in a direction.
  double density(const Vec3& direction) const { return bsdf.density(frame.local(direction)); }
};

/// Where the walker has reached a surface with these values.
ScatteringPoint scattering_point(const PathScene& scene, const Walker& walker, const Walk& walk, const Surface& surface,
                                 const MaterialValues& values);

/// The light emitted by a material with these values.
inline Color emission(const MaterialValues& values) {
  return values.color * (1 - values.refract) * values.emission;
}

} // namespace rt
