#pragma once

#include "tools/live/document.hpp"
#include "tools/povray/compare/report.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

/// What can be done with a document and POV-Ray.
namespace rt::tools::live {

struct PovrayExport {
  std::string text;
  std::string problems; ///< what POV-Ray cannot compute exactly, each with its place; empty: the text is exact
};
PovrayExport export_povray(const Document& document, bool has_comments);

struct CheckOptions {
  povray::Gates gates;
  std::chrono::milliseconds time_limit = std::chrono::minutes(10); ///< for each run of POV-Ray
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const Progress&)> on_progress; ///< for our own picture, a few times a second
  /// While waiting for POV-Ray's, a few times a second: the seconds since it started.
  std::function<void(double)> on_wait;
};

/// A status message: "waiting for POV-Ray, 12 s".
std::string waiting_text(double seconds);

/// A picture compared with POV-Ray's; the report refers to the other members.
struct Check {
  Film film;
  povray::Shots shots;
  povray::Report report;
};

/// Renders the document here and in POV-Ray, concurrently. Null if it was stopped. Throws povray::Missing and
/// povray::Failed. The document must outlive the check.
std::unique_ptr<const Check> check(Document& document, const CheckOptions& options);

} // namespace rt::tools::live
