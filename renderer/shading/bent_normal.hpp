#pragma once

#include "renderer/math/affine.hpp"

#include <optional>

namespace rt {

/// A normal that bumps bend. A surface that is raised along its unit normal n by a height h has the normal n − ∇h, ∇h
/// along the surface alone (J. F. Blinn, Simulation of Wrinkled Surfaces, SIGGRAPH 1978), where heights are measured in
/// the space of the object that writes the material.
struct BentNormal {
  Vec3 normal; ///< n as other spaces see it: not unit there
  Vec3 slope;  ///< ∇h

  /// Carries it to another space, whose inverse map is given.
  void carry(const Affine& inverse) {
    normal = inverse.transposed_vector(normal);
    slope = inverse.transposed_vector(slope);
  }
  /// The unit normal, on the side of `unbent`, the unit normal of the surface without bumps.
  Vec3 value(const Vec3& unbent) const {
    const Vec3 bent = unbent * length(normal) - slope;
    return dot(bent, unbent) > 0 ? normalize(bent) : unbent;
  }
};

} // namespace rt
