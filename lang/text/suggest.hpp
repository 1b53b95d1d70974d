#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rt::lang {

/// How many insertions, deletions, replacements and swaps of neighbours turn one word into the other
/// (optimal string alignment), not counting beyond `limit`: anything further gives `limit + 1`.
int edit_distance(std::string_view from, std::string_view to, int limit);

/// The candidate that `word` most likely meant, or nothing if none is close enough to be worth a guess.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates);

} // namespace rt::lang
