#pragma once

#include "tools/live/picture_settings.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rt::tools {

/// An option of a command, and its destination: a flag is set, an integer, a fraction (0 to 1) or a text is stored,
/// several texts are appended. A picture setting is parsed under the field's name, which is the option's.
struct CommandOption {
  std::string_view name; ///< without the hyphens
  std::variant<bool*, int*, std::optional<int>*, std::optional<double>*, std::string*, std::vector<std::string>*,
               live::PictureSettings*>
      target;
  int count = 1; ///< how many words follow; more than one only for several texts
};

/// --size, --mode, --samples, --noise, --seed, --max-depth and --min-weight.
std::vector<CommandOption> picture_options(live::PictureSettings& settings);

/// Removes the options from the words. Returns what is wrong, or "".
std::string take_options(std::vector<std::string>& words, std::span<const CommandOption> options);

} // namespace rt::tools
