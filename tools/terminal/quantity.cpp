#include "tools/terminal/quantity.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>

namespace rt::tools {

std::optional<std::uint64_t> parse_quantity(std::string_view text, std::uint64_t thousand) {
  constexpr std::string_view letters = "KMGT";
  double factor = 1;
  if (!text.empty()) {
    const std::size_t power = letters.find(static_cast<char>(std::toupper(static_cast<unsigned char>(text.back()))));
    if (power != std::string_view::npos) {
      factor = std::pow(static_cast<double>(thousand), static_cast<double>(power) + 1);
      text.remove_suffix(1);
    }
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  value *= factor;
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  // Up to 2^63 every integral double fits an integer.
  if (!(value >= 0) || value > 0x1p63 || value != std::floor(value)) return std::nullopt;
  return static_cast<std::uint64_t>(value);
}

std::string human(double quantity) {
  constexpr std::string_view prefixes[] = {"", " k", " M", " G", " T"};
  std::size_t power = 0;
  // What would be rounded to 1000 takes the next prefix.
  while (quantity >= 999.5 && power + 1 < std::size(prefixes)) {
    quantity /= 1000;
    ++power;
  }
  if (power == 0 && quantity == std::floor(quantity)) return fmt::format("{:.0f}", quantity);
  const int decimals = quantity < 9.995 ? 2 : quantity < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f}{}", quantity, decimals, prefixes[power]);
}

} // namespace rt::tools
