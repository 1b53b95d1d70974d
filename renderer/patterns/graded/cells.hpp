#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// Cubes of one unit, each of one value by chance.
struct Cells : Graded {
  static constexpr std::string_view noun = "cells";
  static constexpr std::string_view help = "cubes of one unit, each at a place of the stops by chance";
  int seed = 0;
};

std::span<const Field> fields(const Cells*);

} // namespace rt::scene

namespace rt {

/// A number by the hash of the seed and the whole parts, as evenly spread as can be.
double value_at(const scene::Cells& cells, const Vec3& p);

} // namespace rt
