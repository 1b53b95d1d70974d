#include "tools/repl/options.hpp"

#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <type_traits>

namespace rt::tools {
namespace {

std::string unknown_option(std::string_view name, std::span<const CommandOption> options) {
  std::vector<std::string_view> names;
  for (const CommandOption& option : options) names.push_back(option.name);
  const auto guess = lang::nearest(name, names);
  return fmt::format("unknown option `--{}`{}", name, guess ? fmt::format("; did you mean `--{}`?", *guess) : "");
}

std::string set(live::PictureSettings& settings, std::string_view option, const std::string& text) {
  return settings.set(option == "max-depth" ? "max_depth" : option == "min-weight" ? "min_weight" : option, text);
}

// Returns what is wrong with the value, as PictureSettings::set does.
std::string store(const CommandOption& option, const std::string& text) {
  return std::visit(
      [&](auto* target) -> std::string {
        using Target = std::remove_pointer_t<decltype(target)>;
        if constexpr (std::is_same_v<Target, bool>) {
          *target = true;
        } else if constexpr (std::is_same_v<Target, int> || std::is_same_v<Target, std::optional<int>>) {
          const auto number = live::parse_numbers(text, ',', 1);
          if (!number || number->front() < 0) return fmt::format("takes a whole number, not `{}`", text);
          *target = number->front();
        } else if constexpr (std::is_same_v<Target, std::optional<double>>) {
          double share = 0;
          const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
          if (error != std::errc() || end != text.data() + text.size() || !(share >= 0 && share <= 1))
            return fmt::format("takes a number from 0 to 1, not `{}`", text);
          *target = share;
        } else if constexpr (std::is_same_v<Target, live::PictureSettings>) {
          return set(*target, option.name, text);
        } else if constexpr (std::is_same_v<Target, std::string>) {
          *target = text;
        } else {
          target->push_back(text);
        }
        return "";
      },
      option.target);
}

} // namespace

std::vector<CommandOption> picture_options(live::PictureSettings& settings) {
  return {{"size", &settings}, {"mode", &settings},      {"samples", &settings},   {"noise", &settings},
          {"seed", &settings}, {"max-depth", &settings}, {"min-weight", &settings}};
}

std::string take_options(std::vector<std::string>& words, std::span<const CommandOption> options) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--")) {
      others.push_back(words[i]);
      continue;
    }
    const std::string name = words[i].substr(2);
    const auto option = std::find_if(options.begin(), options.end(), [&](const auto& o) { return o.name == name; });
    if (option == options.end()) return unknown_option(name, options);
    const auto count = static_cast<std::size_t>(std::holds_alternative<bool*>(option->target) ? 0 : option->count);
    if (words.size() - i - 1 < count)
      return fmt::format("--{} takes {}", name, count == 1 ? "a value" : fmt::format("{} values", count));
    std::string problem = count == 0 ? store(*option, "") : "";
    for (std::size_t value = 0; value < count && problem.empty(); ++value) problem = store(*option, words[++i]);
    if (!problem.empty()) return fmt::format("--{} {}", name, problem);
  }
  words = std::move(others);
  return "";
}

} // namespace rt::tools
