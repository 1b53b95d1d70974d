#pragma once

#include "renderer/render/render.hpp"

#include <string>
#include <string_view>

namespace rt::tools {

/// The line that stands on the terminal while a picture is made: a bar, the share that is done, rays per second and the
/// time that is left if the rest takes as long as what is done.
std::string progress_line(const Progress& progress);

/// Shows that line on standard error, which must be a terminal, and takes it away at the end of its own life. Nothing
/// is shown of what is done at once.
class ProgressBar {
public:
  ProgressBar() = default;
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();
  void show(const Progress& progress);
  /// Another line in its place: what takes `seconds` so far.
  void show(std::string_view line, double seconds);

private:
  bool is_shown_ = false;
};

} // namespace rt::tools
