#include "lang/suggest.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace rt::lang {

int edit_distance(std::string_view from, std::string_view to, int limit) {
  const auto rows = static_cast<int>(from.size());
  const auto columns = static_cast<int>(to.size());
  if (std::abs(rows - columns) > limit) return limit + 1;
  const auto width = to.size() + 1;
  std::vector<int> before_previous(width), previous(width), current(width);
  for (std::size_t j = 0; j < width; ++j) previous[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= from.size(); ++i) {
    current[0] = static_cast<int>(i);
    int best = current[0];
    for (std::size_t j = 1; j < width; ++j) {
      const bool differs = from[i - 1] != to[j - 1];
      int cost = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (differs ? 1 : 0)});
      const bool swapped = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (swapped) cost = std::min(cost, before_previous[j - 2] + 1);
      current[j] = cost;
      best = std::min(best, cost);
    }
    if (best > limit) return limit + 1;
    std::swap(before_previous, previous);
    std::swap(previous, current);
  }
  return std::min(previous.back(), limit + 1);
}

namespace {

std::string folded(std::string_view word) {
  std::string out;
  for (const char c : word) {
    if (c == '_') continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

// A third of the word may be wrong: one slip in a word of three letters, two from six on, never more than three. In words
// of one or two letters any slip makes another word.
int allowed_slips(std::size_t length) { return length <= 2 ? 0 : static_cast<int>(std::min<std::size_t>((length + 2) / 4 + (length >= 6 ? 0 : 0), 3)); }

} // namespace

} // namespace rt::lang
