#pragma once

#include "tools/oracle/dice.hpp"

#include <string>

/// Functions of the point, as text of the scene language.
namespace rt::tools::oracle {

/// `fn(p) => …`, a number between `low` and `high`.
std::string random_number_function(Dice& dice, double low, double high);
/// `fn(p) => …`, a colour.
std::string random_color_function(Dice& dice);

} // namespace rt::tools::oracle
