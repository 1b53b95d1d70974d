#include "lang/load.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/evaluate.hpp"
#include "lang/text/stopwatch.hpp"

#include <algorithm>

namespace rt::lang {
namespace {

void require_things(const scene::Scene& scene, const Unit& main, Report& report) {
  if (scene::count_primitives(scene) > 0) return;
  // It may exist for its expectations alone.
  const auto expects = [](const Node& node) { return node.kind == Kind::expect; };
  if (std::ranges::any_of(main.ast.nodes, expects)) return;
  const auto binds = [&](NodeId item) { return main.ast.kind(item) == Kind::bind || main.ast.kind(item) == Kind::def; };
  const bool keeps_things = std::ranges::any_of(main.ast.children(main.ast.root), binds);
  report.add(errors::nothing_to_see({main.ast.file, 0, 0}, keeps_things));
}

Loaded evaluate_analysis(Analysis analysis, const LoadOptions& options) {
  Report& report = analysis.report;
  Loaded loaded;
  loaded.statistics.parse_seconds = analysis.parse_seconds;
  loaded.statistics.check_seconds = analysis.check_seconds;
  loaded.statistics.bytes = analysis.bytes;
  const Stopwatch time;
  Evaluated evaluated = evaluate(*analysis.program, report, options.limits, options.stop, options.observe);
  if (options.needs_things && !report.has_errors()) require_things(evaluated.scene, *analysis.program->main, report);
  loaded.statistics.evaluate_seconds = time.seconds();
  loaded.statistics.steps = evaluated.steps;
  loaded.expectations = std::move(evaluated.expectations);
  loaded.printed = std::move(evaluated.printed);
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
