#pragma once

#include "tools/live/picture_settings.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rt::tools {

/// An option of a command, and where its value goes: a flag is set, a whole number, a share (0 to 1) or a text is
/// stored, several texts are added. A setting of the picture is read by the field's name, which is the option's.
struct CommandOption {
  std::string_view name; ///< without the hyphens
  std::variant<bool*, int*, std::optional<int>*, std::optional<double>*, std::string*, std::vector<std::string>*,
               live::PictureSettings*>
      target;
  int count = 1; ///< how many words follow; more than one for several texts only
};

/// --size, --mode, --samples, --noise, --seed, --max-depth and --min-weight.
std::vector<CommandOption> picture_options(live::PictureSettings& settings);

/// Takes the options out of the words; the others stay. Returns what is wrong, "" if nothing is.
std::string take_options(std::vector<std::string>& words, std::span<const CommandOption> options);

} // namespace rt::tools
