#include "tools/oracle/runs.hpp"

#include "lang/load.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace rt::tools::oracle {

scene::Scene load(const std::string& text) {
  lang::Loaded loaded = lang::load_text(text, "random.rtl", ".", {});
  if (loaded.scene) return std::move(*loaded.scene);
  for (const lang::Diagnostic& d : loaded.diagnostics)
    if (d.severity == lang::Severity::error)
      throw std::runtime_error(fmt::format("the scene does not load: line {}: {}",
                                           loaded.sources.position(d.span.file, d.span.begin).line, d.message));
  throw std::runtime_error("the scene does not load");
}

std::optional<std::string> refusal(const scene::Scene& scene) {
  std::vector<povray::Inexact> inexact = povray::export_povray(scene).inexact;
  if (inexact.empty()) return std::nullopt;
  return std::move(inexact.front().message);
}

void minimise(Failure& failure, const Block& file, const std::function<bool(scene::Scene&)>& fails) {
  const auto still_fails = [&](const Block& block) {
    try {
      scene::Scene scene = load(print(block));
      return !refusal(scene) && fails(scene);
    } catch (const std::exception&) {
      return false;
    }
  };
  if (still_fails(file)) failure.text = print(minimise(file, still_fails, 400));
}

} // namespace rt::tools::oracle
