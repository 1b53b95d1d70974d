#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// Distances from points by chance, one in each cube of one unit (S. Worley, A Cellular Texture Basis Function,
/// SIGGRAPH 1996).
struct Crackle : Graded {
  enum class Measure : std::uint8_t { first, second, edge };
  static constexpr std::string_view noun = "crackle";
  static constexpr std::string_view help = "cells about points by chance, about one unit in size, like dried mud";
  Measure measure = Measure::edge;
  int seed = 0;
};

std::span<const Field> fields(const Crackle*);

} // namespace rt::scene

namespace rt {

/// The distances from the nearest point and from the one after it.
struct CellDistances {
  double first, second;
};
CellDistances cell_distances(int seed, const Vec3& p);

/// The distance from the nearest point, from the second nearest, or the difference of both, which is 0 at the edges of
/// the cells; held at 1.
double value_at(const scene::Crackle& crackle, const Vec3& p);

} // namespace rt
