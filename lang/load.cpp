#include "lang/load.hpp"

#include "lang/check/check.hpp"
#include "lang/evaluate/evaluate.hpp"
#include "lang/library/library.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace rt::lang {

namespace fs = std::filesystem;

namespace {

class Stopwatch {
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void read_defines(Program& program, Files& files, const LoadOptions& options) {
  for (const auto& [name, text] : options.defines) {
    Unit& unit = files.parse_expression_text(fmt::format("-D {}", name), text);
    program.defines.push_back({program.symbols.intern(name), &unit, 0, false});
  }
}

// Once the scene's params are known.
void report_unused_defines(Program& program, Report& report) {
  for (const Define& define : program.defines) {
    if (define.is_used) continue;
    Diagnostic* d = report.error("E0604", define.unit->ast.span(define.unit->ast.root));
    if (!d) continue;
    std::vector<std::string_view> names;
    for (const Symbol symbol : program.param_names) names.push_back(program.symbols.name(symbol));
    const std::string_view name = program.symbols.name(define.name);
    const auto guess = nearest(name, names);
    d->message = fmt::format("the scene has no `param` called `{}`", name);
    if (guess) d->label = fmt::format("did you mean `{}`?", *guess);
    if (!names.empty()) d->notes.push_back({std::nullopt, fmt::format("it has {}", fmt::join(names, ", "))});
  }
}

Loaded load(std::string text, std::string name, std::string path, const fs::path& folder, const LoadOptions& options) {
  Program program;
  Report report;
  Files files(program, report, folder, options.include_roots);
  Loaded loaded;
  program.main = &files.parse_text(std::move(name), std::move(path), std::move(text));
  program.library = &files.parse_text(std::string(library_name), {}, std::string(library_text()));
  read_defines(program, files, options);
  if (options.lint) {
    report.want_remarks();
    program.uses = std::make_unique<NameUses>();
  }
  const double parsed_before = files.parse_seconds();
  const Stopwatch check_time;
  check(program, files, report);
  report_unused_defines(program, report);
  if (program.uses && !report.has_errors()) program.uses->tell(report, program.symbols);
  loaded.statistics.check_seconds = check_time.seconds() - (files.parse_seconds() - parsed_before);
  loaded.statistics.parse_seconds = files.parse_seconds();
  loaded.statistics.bytes = files.bytes();
  const Stopwatch evaluate_time;
  Evaluated evaluated = evaluate(program, report, options.limits, options.stop, options.observe);
  loaded.statistics.evaluate_seconds = evaluate_time.seconds();
  loaded.statistics.steps = evaluated.steps;
  loaded.expectations = std::move(evaluated.expectations);
  if (!report.has_errors()) loaded.scene = std::move(evaluated.scene);
  loaded.diagnostics = report.finish();
  loaded.remarks = report.finish_remarks();
  loaded.sources = std::move(program.sources);
  return loaded;
}

} // namespace

Loaded load_file(const std::string& path, const LoadOptions& options) {
  std::string text = read_file(path);
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(path, error);
  return load(std::move(text), path, error ? path : whole.string(), whole.parent_path(), options);
}

Loaded load_text(std::string text, std::string name, const std::string& folder, const LoadOptions& options) {
  return load(std::move(text), std::move(name), {}, folder, options);
}

} // namespace rt::lang
