#include "lang/load.hpp"

#include "lang/evaluate/evaluate.hpp"
#include "lang/text/stopwatch.hpp"

namespace rt::lang {
namespace {

Loaded evaluate_analysis(Analysis analysis, const LoadOptions& options) {
  Report& report = analysis.report;
  Loaded loaded;
  loaded.statistics.parse_seconds = analysis.parse_seconds;
  loaded.statistics.check_seconds = analysis.check_seconds;
  loaded.statistics.bytes = analysis.bytes;
  const Stopwatch time;
  Evaluated evaluated = evaluate(*analysis.program, report, options.limits, options.stop, options.observe);
  loaded.statistics.evaluate_seconds = time.seconds();
  loaded.statistics.steps = evaluated.steps;
  loaded.expectations = std::move(evaluated.expectations);
  if (!report.has_errors()) loaded.scene = std::move(evaluated.scene);
  loaded.diagnostics = report.diagnostics();
  loaded.remarks = report.remarks();
  loaded.sources = std::move(analysis.program->sources);
  return loaded;
}

} // namespace

Loaded load_file(const std::string& path, const LoadOptions& options) {
  return evaluate_analysis(analyse_file(path, options), options);
}

Loaded load_text(std::string text, std::string name, const std::string& folder, const LoadOptions& options) {
  return evaluate_analysis(analyse_text(std::move(text), std::move(name), folder, options), options);
}

} // namespace rt::lang
