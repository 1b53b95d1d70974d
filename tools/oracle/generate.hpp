#pragma once

#include "tools/oracle/dice.hpp"
#include "tools/oracle/scene_tree.hpp"

/// Random scenes over everything that POV-Ray can compute too.
namespace rt::tools::oracle {

enum class Mode : std::uint8_t {
  color,    ///< whole pictures
  geometry, ///< shapes and transforms alone, more of them
};

/// How long a scene's things are, from 1 to 100, evenly spread by order of magnitude: one is modelled in metres, the
/// next in centimetres. POV-Ray's limits are lengths of 1e-4 and 1e-3 whatever the scene: small scenes meet them most
/// often. `random_scene` begins with it.
double random_length_unit(Dice& dice);
Block random_scene(Dice& dice, Mode mode);

/// Parts of it, each in a file of its own.
Block random_shape(Dice& dice, int depth, bool is_solid);
void add_material(Dice& dice, Block& thing, bool is_in_solid);
std::vector<Block> random_lights(Dice& dice);
Block random_camera(Dice& dice);
/// Adds `at` (no coordinate beyond `reach` units of length), `rotate`, `scale` and a chain.
void place(Dice& dice, Block& thing, double reach);

} // namespace rt::tools::oracle
