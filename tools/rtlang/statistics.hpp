#pragma once

#include "lang/load.hpp"
#include "renderer/render/render.hpp"

#include <string>
#include <vector>

namespace rt::tools {

/// What one run cost and produced.
struct RunStatistics {
  std::string scene;                ///< the scene's file as given
  std::vector<std::string> outputs; ///< as given, "-" for standard output
  int width = 0, height = 0;        ///< of the picture that was written
  std::string scene_hash;
  bool is_complete = true;
  lang::LoadStatistics load;
  RenderStatistics render;
  double load_seconds = 0, write_seconds = 0, total_seconds = 0; ///< wall time
};

std::uint64_t count_rays(const RenderStatistics& statistics);

/// One line: picture, rays, time.
std::string summary(const RunStatistics& statistics);
/// A table of several lines for people, the same as one JSON object for machines; both with the process's CPU time and
/// peak memory.
std::string table(const RunStatistics& statistics);
std::string json(const RunStatistics& statistics);

} // namespace rt::tools
