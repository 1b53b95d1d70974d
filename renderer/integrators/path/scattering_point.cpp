#include "renderer/integrators/path/scattering_point.hpp"

#include "renderer/integrators/rules.hpp"

#include <algorithm>

namespace rt {

ScatteringPoint scattering_point(const PathScene& scene, const Walker& walker, const Walk& walk, const Surface& surface,
                                 const MaterialValues& values) {
  constexpr double least_cosine = 1e-9; // for a surface seen edge-on, or whose normal faces away
  const TangentFrame frame(OwnRules::turned_normal(surface, walk.ray.direction));
  Vec3 wo = frame.local(-walk.ray.direction);
  wo.z = std::max(wo.z, least_cosine);
  return {surface,
          frame,
          Bsdf(values, scene.tables.of(surface.material_id), walker.eta(walk, surface, values), wo),
          values.refract > 0 && !values.thin,
          &walker,
          walk};
}

} // namespace rt
