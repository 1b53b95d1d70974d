// Every scene in diagnostics/ and, beside it, the report it must give. `tools/update_diagnostics` writes the reports anew:
// read the differences before committing them.

#include "lang/diagnostic.hpp"
#include "lang/parse.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
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
    if (entry.path().extension() == ".rtl") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string report_of(std::string name, std::string text) {
  SourceMap sources;
  SymbolTable symbols;
  const FileId file = sources.add(std::move(name), "", std::move(text));
  std::string out;
  for (const Diagnostic& diagnostic : parse(sources, file, symbols).diagnostics) {
    out += render(diagnostic, sources, false) + '\n';
  }
  return out;
}

bool raises(std::string_view scene, std::string_view code) {
  return report_of("example.rtl", std::string(scene)).find('[' + std::string(code) + ']') != std::string::npos;
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
    if (!code.mended.empty()) CHECK(report_of("mended.rtl", std::string(code.mended)).empty());
  }
}
