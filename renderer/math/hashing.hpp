#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"

#include <bit>
#include <cstdint>

namespace rt {

/// Hashes numbers to 64 bits, the same on every machine.
class Hasher {
public:
  Hasher& add(std::uint64_t bits) {
    // Multipliers of MurmurHash3's finaliser (A. Appleby).
    hash_ = (hash_ ^ bits) * 0xff51afd7ed558ccd;
    hash_ = (hash_ ^ (hash_ >> 33)) * 0xc4ceb9fe1a85ec53;
    hash_ ^= hash_ >> 29;
    return *this;
  }
  /// 0 and -0 hash alike, as they compare equal.
  Hasher& add(double number) { return add(std::bit_cast<std::uint64_t>(number + 0.0)); }
  Hasher& add(const Vec3& v) { return add(v.x).add(v.y).add(v.z); }
  Hasher& add(const Color& c) { return add(c.r).add(c.g).add(c.b); }
  std::uint64_t value() const { return hash_; }

private:
  std::uint64_t hash_ = 0;
};

} // namespace rt
