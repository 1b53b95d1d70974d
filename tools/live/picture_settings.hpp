#pragma once

#include "renderer/scene/scene.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools::live {

/// Invalid settings for a scene; the message says which and why.
struct SettingsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What overrides the scene's own settings for a picture.
struct PictureSettings {
  std::optional<scene::Resolution> size = {};
  std::optional<int> samples = {}, max_depth = {}, seed = {};
  std::optional<double> min_weight = {};
  std::optional<scene::Mode> mode = {};
  std::optional<double> noise = {};

  /// Parses one of them, named like the scene's field: "800x600" for `size`, "path" for `mode`, "0.01" for `noise` and
  /// `min_weight`, "16" for the others.
  /// Returns what is wrong as the predicate of a sentence ("takes a whole number, not `x`"), or "" if it was set.
  std::string set(std::string_view field, std::string_view text);
  /// If the mode changes, the scene's `samples` and `max_depth`, which were written for its own mode, are ignored.
  /// Throws SettingsError for inconsistent settings.
  void apply_to(scene::Scene& scene) const;

  friend bool operator==(const PictureSettings&, const PictureSettings&) = default;
};

/// Integers separated by `separator`: "800x600", "10,10,50,50". Empty unless there are exactly `count`.
std::optional<std::vector<int>> parse_numbers(std::string_view text, char separator, std::size_t count);

} // namespace rt::tools::live
