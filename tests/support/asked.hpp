#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/whitted.hpp"
#include "renderer/scene/builder.hpp"

#include <vector>

namespace rt::tests {

/// A scene that was compiled, to be asked by rays. Directions need not be unit vectors.
class Asked {
public:
  explicit Asked(const scene::Scene& scene) : compiled(scene, 1) {}
  explicit Asked(const scene::Builder& b) : Asked(b.scene) {}

  RayHit nearest(const Vec3& origin, const Vec3& direction) {
    return compiled.nearest({origin, direction}, {}, scratch_);
  }
  Surface surface(const Vec3& origin, const Vec3& direction) {
    return compiled.surface({origin, direction}, nearest(origin, direction));
  }
  Color radiance(const Vec3& origin, const Vec3& direction) {
    NoRecorder recorder;
    return Whitted<>(compiled, recorder).radiance({origin, normalize(direction)}, compiled.around(origin));
  }
  Color transmittance(const Vec3& from, const Vec3& to) {
    return compiled.transmittance({from, to - from}, {0, 1}, scratch_);
  }
  /// The values of t of all hits.
  std::vector<double> all(const Vec3& origin, const Vec3& direction) {
    std::vector<double> ts;
    for (const RayHit& hit : compiled.all_hits({origin, direction}, {})) ts.push_back(hit.t);
    return ts;
  }

  CompiledScene compiled;

private:
  TraceScratch scratch_;
};

} // namespace rt::tests
