#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// Spots, 2π apart.
struct Leopard : Graded {
  static constexpr std::string_view noun = "leopard";
  static constexpr std::string_view help = "round spots, which are 1, in a ground of 0; they are 2π apart";
};

std::span<const Field> fields(const Leopard*);

} // namespace rt::scene

namespace rt {

/// ((sin x + sin y + sin z)/3)², the angles in radians.
double value_at(const scene::Leopard& leopard, const Vec3& p);

} // namespace rt
