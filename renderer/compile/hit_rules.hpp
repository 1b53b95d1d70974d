#pragma once

namespace rt {

/// Whose rules decide where a ray meets a shape. How far from its origin hits count is the integrator's affair.
enum class HitRules {
  own,   ///< exact but for rounding
  povray ///< POV-Ray 3.7's, for explaining where its pictures differ from ours: `PovrayBoxGeometry`
};

} // namespace rt
