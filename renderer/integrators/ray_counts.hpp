#pragma once

#include <cstdint>

namespace rt {

/// Rays traced so far, by purpose.
struct RayCounts {
  std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0;
  std::uint64_t scattered = 0; ///< off a matte surface, in any direction

  std::uint64_t total() const { return camera + shadow + reflected + refracted + scattered; }
  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    shadow += other.shadow;
    reflected += other.reflected;
    refracted += other.refracted;
    scattered += other.scattered;
    return *this;
  }
};

} // namespace rt
