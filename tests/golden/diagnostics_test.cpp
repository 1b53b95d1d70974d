// Every scene in diagnostics/ and, beside it, the report it must give. `tools/update_diagnostics` writes the reports
// anew: read the differences before committing them.

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/load.hpp"
#include "tests/paths.hpp"
#include "tools/explain/lint/lint.hpp"
#include "tools/import/import.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using namespace rt::lang;

const fs::path folder = fs::path(RTLANG_SOURCE_DIR) / "tests/golden/diagnostics";

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<fs::path> scenes() {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".rtl" || rt::tools::import::format_of(extension.native())) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// A scene may begin with `// options: ` and what the command line is to say: -D name=value, --max-steps N, …, --stop;
/// --test: its expectations are tried, by nobody who sees; --lint: the lint looks at it; --picture: it is to be
/// rendered.
LoadOptions options_of(const std::string& text, const std::atomic<bool>& stop) {
  constexpr std::string_view mark = "// options: ";
  LoadOptions options;
  if (!text.starts_with(mark)) return options;
  std::istringstream words(text.substr(mark.size(), text.find('\n') - mark.size()));
  for (std::string word; words >> word;) {
    if (word == "-D") {
      std::string define;
      words >> define;
      options.defines.emplace_back(define.substr(0, define.find('=')), define.substr(define.find('=') + 1));
    }
    if (word == "--max-steps") words >> options.limits.steps;
    if (word == "--max-recursion") words >> options.limits.recursion;
    if (word == "--max-objects") words >> options.limits.objects;
    if (word == "--max-memory") words >> options.limits.memory_bytes;
    if (word == "--lint") options.lint = true;
    if (word == "--picture") options.needs_things = true;
    if (word == "--stop") options.stop = &stop;
    if (word == "--test") options.observe = [](const rt::scene::Scene&) { return nullptr; };
  }
  return options;
}

Loaded load(std::string name, std::string text) {
  const std::atomic<bool> stop = true;
  const LoadOptions options = options_of(text, stop);
  Loaded loaded = load_text(std::move(text), std::move(name), folder.string(), options);
  if (options.lint) loaded.diagnostics = rt::tools::explain::lint(loaded, {});
  return loaded;
}

/// Of another program's scene.
std::string import_report(const rt::tools::import::Format& format, const std::string& name, std::string text) {
  const rt::tools::import::Imported imported = format.read(std::move(text), name, {});
  std::string out;
  for (const Diagnostic& diagnostic : imported.diagnostics) out += render(diagnostic, imported.sources, false) + '\n';
  return out;
}

std::string report_of(std::string name, std::string text) {
  if (const auto* format = rt::tools::import::format_of(name)) return import_report(*format, name, std::move(text));
  const Loaded loaded = load(std::move(name), std::move(text));
  std::string out;
  for (const Diagnostic& line : loaded.printed) out += render(line, loaded.sources, false) + '\n';
  for (const Diagnostic& diagnostic : loaded.diagnostics) out += render(diagnostic, loaded.sources, false) + '\n';
  for (const Diagnostic& diagnostic : loaded.expectations.failures)
    out += render(diagnostic, loaded.sources, false) + '\n';
  return out;
}

/// What a code is about is found by the lint where it is a warning.
std::string with_options(std::string_view scene, std::string_view code) {
  return (code.starts_with('W') ? "// options: --lint\n" : "") + std::string(scene);
}

bool is_fine(std::string_view scene, std::string_view code) {
  const Loaded loaded = load("mended.rtl", with_options(scene, code));
  return std::ranges::none_of(loaded.diagnostics, [](const Diagnostic& d) { return d.severity != Severity::note; });
}

bool raises(std::string_view scene, std::string_view code) {
  return report_of("example.rtl", with_options(scene, code)).find('[' + std::string(code) + ']') != std::string::npos;
}

} // namespace

TEST_CASE("diagnostics: every scene gives its report") {
  const bool updates = std::getenv("RTLANG_UPDATE_GOLDENS") != nullptr;
  for (const fs::path& scene : scenes()) {
    const std::string report = report_of(scene.filename().string(), read(scene));
    const fs::path expected = fs::path(scene).replace_extension(".expected");
    if (updates) std::ofstream(expected, std::ios::binary) << report;
    INFO(scene.filename().string());
    CHECK(report == read(expected));
    CHECK_FALSE(report.empty());
  }
}

TEST_CASE("diagnostics: every code of the registry has a scene that raises it") {
  std::string reports;
  for (const fs::path& scene : scenes()) reports += read(fs::path(scene).replace_extension(".expected"));
  for (const Code& code : all_codes()) {
    INFO(code.code);
    CHECK(reports.find('[' + std::string(code.code) + ']') != std::string::npos);
  }
}

TEST_CASE("diagnostics: the example of an explanation raises its code, and the mended one does not") {
  for (const Code& code : all_codes()) {
    INFO(code.code);
    if (!code.example.empty()) CHECK(raises(code.example, code.code));
    if (!code.mended.empty()) CHECK(is_fine(code.mended, code.code));
    if (!code.mended.empty()) CHECK_FALSE(raises(code.mended, code.code));
  }
}
