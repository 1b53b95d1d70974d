#pragma once

#include "tools/povray/compare/compare.hpp"

/// The result of a check, for users and for machines.
namespace rt::tools::povray {

struct Report {
  std::string scene; ///< the file's name
  std::string povray_version;
  const scene::Scene* description = nullptr;
  const Film* film = nullptr;
  const Shots* shots = nullptr;
  Comparison comparison;
  std::vector<Inexact> inexact;
  Gates gates;
  double render_seconds = 0, povray_seconds = 0;

  std::vector<Verdict> verdicts() const;
  bool holds() const { return all_hold(verdicts()); }
};

/// "ball, still_life.rtl:12" for the id of an object, "nothing" for 0.
std::string object_text(const scene::Scene& scene, const std::vector<ObjectName>& names, std::uint32_t id);

/// A table, and a line for each of the worst pixels.
std::string report_text(const Report& report);
std::string report_json(const Report& report);
/// A self-contained page: both pictures, the maps of differences, the table, the worst pixels enlarged.
std::string report_html(const Report& report);

} // namespace rt::tools::povray
