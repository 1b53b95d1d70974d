#pragma once

#include "renderer/render/render.hpp"

#include <string>
#include <string_view>

namespace rt::tools {

/// The line shown on the terminal while a picture is rendered: a bar, the fraction done, rays per second and the
/// remaining time, extrapolated.
std::string progress_line(const Progress& progress);

/// Shows that line on standard error, which must be a terminal, and removes it at the end of its lifetime. Nothing is
/// shown for work that finishes at once.
class ProgressBar {
public:
  ProgressBar() = default;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();
  void show(const Progress& progress);
  /// Another line in its place, for work that has taken `seconds` so far.
  void show(std::string_view line, double seconds);

private:
  bool is_shown_ = false;
};

} // namespace rt::tools
