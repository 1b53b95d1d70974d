#include "tools/terminal/progress_bar.hpp"

#include "tools/terminal/console.hpp"
#include "tools/terminal/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::tools {
namespace {

std::string duration(double seconds) {
  const long whole = std::lround(std::min(seconds, 1e9));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

} // namespace

std::string progress_line(const Progress& progress) {
  constexpr int width = 30;
  const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
  const auto done = static_cast<std::size_t>(std::floor(fraction * width));
  std::string line = fmt::format("[{}{}] {:3.0f} %", std::string(done, '#'), std::string(width - done, '.'),
                                 std::floor(fraction * 100));
  if (progress.seconds > 0)
    line += fmt::format("  {} rays/s", human(static_cast<double>(progress.rays) / progress.seconds));
  if (progress.samples > 0) line += fmt::format("  {} samples", progress.samples);
  if (progress.noise) line += fmt::format(", noise {:.2g}", *progress.noise);
  if (fraction > 0) line += fmt::format("  {} left", duration(progress.seconds * (1 - fraction) / fraction));
  return line;
}

void ProgressBar::show(const Progress& progress) {
  show(progress_line(progress), progress.seconds);
}

void ProgressBar::show(std::string_view line, double seconds) {
  constexpr double at_once = 0.3; // seconds
  if (!is_shown_ && seconds < at_once) return;
  is_shown_ = true;
  print_error(fmt::format("\r{}\x1b[K", line));
}

ProgressBar::~ProgressBar() {
  if (is_shown_) print_error("\r\x1b[K");
}

} // namespace rt::tools
