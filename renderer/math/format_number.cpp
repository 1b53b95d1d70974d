#include "renderer/math/format_number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt {

std::string format_number(double number) {
  if (std::isnan(number)) return "not a number";
  if (std::isinf(number)) return number > 0 ? "infinity" : "-infinity";
  return fmt::format("{}", number + 0.0);
}

} // namespace rt
