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

Block random_file(const RunSettings& settings, std::size_t number, Mode mode) {
  Dice dice(scene_seed(settings.seed, number));
  return random_scene(dice, mode);
}

void finish(RunResult& result, const RunSettings& settings, const std::function<void(Failure&)>& make_small) {
  std::ranges::sort(result.failures, {}, &Failure::scene);
  std::ranges::sort(result.refusals, {}, &Refusal::scene);
  std::ranges::stable_sort(result.explained, {}, &Explained::scene);
  const std::size_t kept = std::min(settings.keep_failures, result.failures.size());
  povray::run_many(kept, static_cast<int>(kept), [&](std::size_t i) { make_small(result.failures[i]); });
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
