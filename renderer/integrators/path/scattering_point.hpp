#pragma once

#include "renderer/integrators/path/path_scene.hpp"
#include "renderer/integrators/path/walk.hpp"
#include "renderer/sampling/mappings.hpp"
#include "renderer/scattering/bsdf.hpp"

#include <cmath>

namespace rt {

/// Where a path meets a surface, and how light is scattered there.
struct ScatteringPoint {
  Surface surface;
  Frame frame; ///< about the shading normal, turned to the viewer
  Bsdf bsdf;
  bool is_boundary;     ///< of a medium
  const Walker* walker; ///< that has come there
  Walk walk;

  /// What of light of radiance 1 from a small solid angle about `direction` goes to the viewer, for each solid angle.
  Color reflected(const Vec3& direction) const {
    const Vec3 wi = frame.local(direction);
    return bsdf.evaluate(wi) * std::abs(wi.z);
  }
  /// How densely a path goes on in a direction, per solid angle.
  double density(const Vec3& direction) const { return bsdf.density(frame.local(direction)); }
};

/// Where the walker has come to a surface of these values.
ScatteringPoint scattering_point(const PathScene& scene, const Walker& walker, const Walk& walk, const Surface& surface,
                                 const MaterialValues& values);

/// What is given off by a material of these values.
inline Color emission(const MaterialValues& values) {
  return values.color * (1 - values.refract) * values.emission;
}

} // namespace rt
