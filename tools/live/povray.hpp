#pragma once

#include "tools/live/document.hpp"
#include "tools/povray/compare/report.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

/// What POV-Ray has to do with a document.
namespace rt::tools::live {

struct PovrayExport {
  std::string text;
  std::string problems; ///< what POV-Ray cannot compute exactly, each with its place; empty: the text is good
};
PovrayExport export_povray(const Document& document, bool has_comments);

struct CheckOptions {
  povray::Gates gates;
  std::chrono::milliseconds time_limit = std::chrono::minutes(10); ///< of each run of POV-Ray
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const Progress&)> on_progress; ///< of the own picture, some times a second
  /// While POV-Ray's is waited for, some times a second: the seconds since it began.
  std::function<void(double)> on_wait;
};

/// What to say meanwhile: "waiting for POV-Ray, 12 s".
std::string waiting_text(double seconds);

/// A picture compared with POV-Ray's; the report refers to the rest.
struct Check {
  Film film;
  povray::Shots shots;
  povray::Report report;
};

/// Renders the document here and in POV-Ray, both at once. Null if it was stopped. Throws povray::Missing and
/// povray::Failed. The document must outlive the check.
std::unique_ptr<const Check> check(Document& document, const CheckOptions& options);

} // namespace rt::tools::live
