#include "tools/live/picture_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rt::tools::live {
namespace {

const scene::Field& field_of(std::string_view name) {
  const auto table = scene::fields(static_cast<const scene::Scene*>(nullptr));
  return *std::find_if(table.begin(), table.end(), [&](const scene::Field& f) { return f.name == name; });
}

// Why the numbers are not allowed for a field of the scene; "" if they are.
std::string check_field(std::string_view name, const std::vector<int>& numbers) {
  const scene::Constraint& constraint = field_of(name).constraint;
  for (const int number : numbers) {
    if (number < constraint.min || number > constraint.max)
      return fmt::format("takes whole numbers from {:.0f} to {:.0f}, not {}", constraint.min, constraint.max, number);
  }
  return "";
}

} // namespace

std::string PictureSettings::set(std::string_view field, std::string_view text) {
  if (field == "min_weight") {
    double number = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || rest != text.data() + text.size() || !(number >= 0 && number <= 1))
      return fmt::format("takes a number from 0 to 1, not `{}`", text);
    min_weight = number;
    return "";
  }
  if (field == "mode") {
    const auto choices = field_of(field).choices;
    const auto choice = std::find(choices.begin(), choices.end(), text);
    if (choice == choices.end()) return fmt::format("takes one of {}, not `{}`", fmt::join(choices, ", "), text);
    mode = static_cast<scene::Mode>(choice - choices.begin());
    return "";
  }
  if (field == "noise") {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number) || !(number > 0))
      return fmt::format("takes a number above 0, not `{}`", text);
    noise = number;
    return "";
  }
  const bool is_size = field == "size";
  const auto numbers = is_size ? parse_numbers(text, 'x', 2) : parse_numbers(text, ',', 1);
  if (!numbers)
    return is_size ? fmt::format("takes width and height, as in 800x600, not `{}`", text)
                   : fmt::format("takes a whole number, not `{}`", text);
  if (std::string problem = check_field(field, *numbers); !problem.empty()) return problem;
  if (is_size)
    size = {(*numbers)[0], (*numbers)[1]};
  else
    (field == "samples" ? samples : field == "seed" ? seed : max_depth) = numbers->front();
  return "";
}

void PictureSettings::apply_to(scene::Scene& scene) const {
  if (mode && *mode != scene.mode.value_or(scene::Mode::whitted)) scene.samples = scene.max_depth = std::nullopt;
  if (mode) scene.mode = mode;
  scene.size = size.value_or(scene.size);
  if (min_weight) scene.min_weight = min_weight;
  if (seed) scene.seed = seed;
  if (samples) scene.samples = samples;
  if (noise) scene.noise = noise;
  if (max_depth) scene.max_depth = max_depth;
  if (const auto problem = check(scene))
    throw SettingsError(
        fmt::format("--{} cannot be {}: {}", problem->field, scene::sample_count(scene), problem->message));
}

std::optional<std::vector<int>> parse_numbers(std::string_view text, char separator, std::size_t count) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    int number = 0;
    const auto [rest, error] = std::from_chars(at, end, number);
    if (error != std::errc()) return std::nullopt;
    numbers.push_back(number);
    if (rest == end) break;
    if (*rest != separator) return std::nullopt;
    at = rest + 1;
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

} // namespace rt::tools::live
