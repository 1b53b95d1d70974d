#pragma once

#include <cstdint>

namespace rt {

/// Rays traced so far, by what they were for.
struct RayCounts {
  std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0;

  std::uint64_t total() const { return camera + shadow + reflected + refracted; }
  RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    shadow += other.shadow;
    reflected += other.reflected;
    refracted += other.refracted;
    return *this;
  }
};

} // namespace rt
