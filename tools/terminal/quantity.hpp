#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rt::tools {

/// A non-negative integer, as "20000000", "2e7", or with a letter of either case for a power of `thousand`: "500K",
/// "20M", "4G", "1T". `thousand` is 1000 for counts, 1024 for bytes.
std::optional<std::uint64_t> parse_quantity(std::string_view text, std::uint64_t thousand);

/// A quantity for people, three digits and a power of 1000: "1.20 M", "318".
std::string human(double quantity);

} // namespace rt::tools
