#include "renderer/sampling/sobol.hpp"

namespace rt {
namespace {

constexpr int dimensions = 4;
using Directions = std::array<std::array<std::uint32_t, 32>, dimensions>; // by the bits of the index, lowest first

// A primitive polynomial of degree s with coefficients a, and the initial direction numbers m.
struct Generator {
  unsigned s, a;
  std::array<std::uint32_t, 3> m;
};
constexpr std::array<Generator, dimensions - 1> generators{{{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}}};

constexpr Directions make_directions() {
  Directions v{};
  for (unsigned bit = 0; bit < 32; ++bit) v[0][bit] = 1u << (31 - bit); // van der Corput
  for (std::size_t d = 1; d < dimensions; ++d) {
    const Generator& g = generators[d - 1];
    for (unsigned bit = 0; bit < 32; ++bit) {
      if (bit < g.s) {
        v[d][bit] = g.m[bit] << (31 - bit);
        continue;
      }
      v[d][bit] = v[d][bit - g.s] ^ (v[d][bit - g.s] >> g.s);
      for (unsigned k = 1; k < g.s; ++k)
        if ((g.a >> (g.s - 1 - k)) % 2 == 1) v[d][bit] ^= v[d][bit - k];
    }
  }
  return v;
}

// The contribution of each value of each byte of the reversed index to the four coordinates.
using Tables = std::array<std::array<std::array<std::uint32_t, dimensions>, 256>, 4>;

constexpr Tables make_tables() {
  const Directions directions = make_directions();
  Tables tables{};
  for (unsigned byte = 0; byte < 4; ++byte)
    for (unsigned value = 0; value < 256; ++value)
      for (unsigned bit = 0; bit < 8; ++bit)
        if ((value >> bit) % 2 == 1)
          for (std::size_t d = 0; d < dimensions; ++d)
            tables[byte][value][d] ^= reverse_bits(directions[d][31 - (8 * byte + bit)]);
  return tables;
}

const Tables tables = make_tables(); // 16 KiB

} // namespace

std::array<std::uint32_t, 4> reversed_sobol(std::uint32_t reversed_index) {
  const auto& a = tables[0][reversed_index & 0xff];
  const auto& b = tables[1][(reversed_index >> 8) & 0xff];
  const auto& c = tables[2][(reversed_index >> 16) & 0xff];
  const auto& d = tables[3][reversed_index >> 24];
  std::array<std::uint32_t, 4> point;
  for (std::size_t i = 0; i < point.size(); ++i) point[i] = a[i] ^ b[i] ^ c[i] ^ d[i];
  return point;
}

} // namespace rt
