#pragma once

namespace rt {

/// Whose rules decide where a ray hits a shape. The least distance at which hits count is up to the integrator.
enum class HitRules {
  own,   ///< exact up to rounding
  povray ///< POV-Ray 3.7's, for explaining where its pictures differ from ours: `PovrayBoxGeometry`
};

} // namespace rt
