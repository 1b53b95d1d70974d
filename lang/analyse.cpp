#include "lang/analyse.hpp"

#include "lang/check/check.hpp"
#include "lang/check/errors/statement_errors.hpp"
#include "lang/check/files.hpp"
#include "lang/check/lint/text_lint.hpp"
#include "lang/text/stopwatch.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace rt::lang {
namespace {

// To be called once the scene's params are known.
void report_unused_defines(Program& program, Report& report) {
  std::vector<std::string_view> params;
  for (const Symbol symbol : program.param_names) params.push_back(program.symbols.name(symbol));
  for (const Define& define : program.defines) {
    if (define.is_used) continue;
    // As typed, with the name to point at.
    const std::string_view name = program.symbols.name(define.name);
    const std::string value = program.sources.file(define.unit->ast.file).text;
    const FileId file = program.sources.add("command line", {}, fmt::format("-D {}={}", name, value));
    errors::unused_define(report, {file, 3, 3 + static_cast<std::uint32_t>(name.size())}, name, params);
  }
}

Analysis analyse(std::string text, std::string name, std::string path, const std::filesystem::path& folder,
                 const AnalyseOptions& options) {
  Analysis analysis;
  analysis.program = std::make_unique<Program>();
  Program& program = *analysis.program;
  Report& report = analysis.report;
  Files files(program, report, *options.files, folder, options.include_roots);
  if (options.lint) report.want_remarks();
  if (options.lint || options.keeps_references) program.references.keep();
  if (options.keeps_references) files.unfold_repeats();
  program.main = &files.parse_text(std::move(name), std::move(path), std::move(text));
  files.parse_library_and_defines(options.defines);
  const double parsed_before = files.parse_seconds();
  const Stopwatch check_time;
  check(program, files, report);
  report_unused_defines(program, report);
  if (options.lint) lint_text(program, report);
  analysis.check_seconds = check_time.seconds() - (files.parse_seconds() - parsed_before);
  analysis.parse_seconds = files.parse_seconds();
  analysis.bytes = files.bytes();
  return analysis;
}

} // namespace

Analysis analyse_file(const std::string& path, const AnalyseOptions& options) {
  std::string text = options.files->read(path);
  const std::filesystem::path whole = options.files->canonical(path);
  return analyse(std::move(text), path, whole.string(), whole.parent_path(), options);
}

Analysis analyse_text(std::string text, std::string name, const std::string& folder, const AnalyseOptions& options) {
  return analyse(std::move(text), std::move(name), {}, folder, options);
}

} // namespace rt::lang
