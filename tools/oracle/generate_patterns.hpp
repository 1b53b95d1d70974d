#pragma once

#include "tools/oracle/dice.hpp"
#include "tools/oracle/scene_tree.hpp"

#include <functional>
#include <string>

/// Patterns that POV-Ray has too.
namespace rt::tools::oracle {

/// One of all kinds, which shows what `value` gives. Where `is_linear`, it may show mixtures.
Block random_pattern(Dice& dice, const std::function<std::string(Dice&)>& value, bool is_linear);
/// Gives it a `scale`, a `rotate` and an `at`, or not.
void place_pattern(Dice& dice, Block& pattern);

} // namespace rt::tools::oracle
