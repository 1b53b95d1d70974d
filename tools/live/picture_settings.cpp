#include "tools/live/picture_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace rt::tools::live {
namespace {

// Why the numbers are not allowed for a field of the scene's; "" where they are.
std::string check_field(std::string_view name, const std::vector<int>& numbers) {
  scene::Scene scene;
  const auto table = scene::fields(&scene);
  const auto field = std::find_if(table.begin(), table.end(), [&](const scene::Field& f) { return f.name == name; });
  const scene::Constraint& constraint = field->constraint;
  for (const int number : numbers) {
    if (number < constraint.min || number > constraint.max)
      return fmt::format("takes whole numbers from {:.0f} to {:.0f}, not {}", constraint.min, constraint.max, number);
  }
  if (field->type == scene::FieldType::resolution) return "";
  field->set(&scene, static_cast<double>(numbers[0]));
  const auto problem = check(scene);
  return problem ? fmt::format("cannot be {}: {}", numbers[0], problem->message) : "";
}

} // namespace

std::string PictureSettings::set(std::string_view field, std::string_view text) {
  const bool is_size = field == "size";
  const auto numbers = is_size ? parse_numbers(text, 'x', 2) : parse_numbers(text, ',', 1);
  if (!numbers)
    return is_size ? fmt::format("takes width and height, as in 800x600, not `{}`", text)
                   : fmt::format("takes a whole number, not `{}`", text);
  if (std::string problem = check_field(field, *numbers); !problem.empty()) return problem;
  if (is_size)
    size = {(*numbers)[0], (*numbers)[1]};
  else
    (field == "samples" ? samples : max_depth) = numbers->front();
  return "";
}

void PictureSettings::apply_to(scene::Scene& scene) const {
  scene.size = size.value_or(scene.size);
  scene.samples = samples.value_or(scene.samples);
  scene.max_depth = max_depth.value_or(scene.max_depth);
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
