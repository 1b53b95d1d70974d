#include "lang/text/suggest.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
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

// About a third of a word may be wrong; with one or two letters any slip makes a different word.
int allowed_slips(std::size_t length) {
  return length < 3 ? 0 : std::clamp(static_cast<int>(length) / 3, 1, 3);
}

// The distance of a candidate, or nothing if it is too far. Case and underscores do not count, and a truncated word
// (`rad`) or two swapped letters (`ta`) count as one slip.
std::optional<int> slips(const std::string& word, const std::string& candidate) {
  if (word == candidate) return 0;
  if (word.size() >= 3 && candidate.starts_with(word)) return 1;
  if (word.size() == 2 && candidate.size() == 2 && word[0] == candidate[1] && word[1] == candidate[0]) return 1;
  const int allowed = allowed_slips(std::max(word.size(), candidate.size()));
  const int distance = edit_distance(word, candidate, allowed);
  return distance <= allowed ? std::optional(distance) : std::nullopt;
}

} // namespace

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates) {
  const std::string plain = folded(word);
  std::optional<std::string_view> best;
  std::pair<int, bool> best_score;
  for (const std::string_view candidate : candidates) {
    if (candidate == word) continue;
    const std::string other = folded(candidate);
    const std::optional<int> distance = slips(plain, other);
    if (!distance) continue;
    const std::pair score(*distance, plain.substr(0, 1) != other.substr(0, 1)); // first letters are seldom wrong
    if (best && score >= best_score) continue;
    best = candidate;
    best_score = score;
  }
  return best;
}

} // namespace rt::lang
