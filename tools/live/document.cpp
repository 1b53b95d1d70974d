#include "tools/live/document.hpp"

#include "tools/explain/probe.hpp"

#include <nlohmann/json.hpp>

namespace rt::tools::live {

Document::Document(lang::Loaded loaded, std::string file, const PictureSettings& settings)
    : loaded_(std::move(loaded)), file_(std::move(file)) {
  if (loaded_.scene) settings.apply_to(*loaded_.scene);
}

const RayQuery& Document::query() {
  if (!query_) query_ = std::make_unique<const RayQuery>(scene());
  return *query_;
}

Rendered Document::render(const RenderOptions& options) {
  return render(view_of(scene()), options);
}

Rendered Document::render(const View& view, const RenderOptions& options) {
  return rt::render(query().scene(), view, options);
}

Rendered Document::render_whitted(const RenderOptions& options) {
  return render(whitted_view_of(scene()), options);
}

std::string Document::probe(const explain::Question& question, const ProbeOptions& options) {
  const explain::NamedRay ray = explain::resolve(question, scene(), query().camera());
  const std::vector<HitReport> hits = explain::find_hits(query(), ray.ray, options.all);
  if (options.as_json) return explain::probe_json(scene(), ray, hits).dump(2) + "\n";
  return explain::probe_text(scene(), ray, hits, options.all);
}

std::string Document::why(const explain::Question& question, const WhyOptions& options) {
  const explain::Answer answer(scene(), file_, query(), question);
  if (options.as_json) return explain::why_json(answer, options.detail).dump(2) + "\n";
  return explain::why_text(answer, options.detail);
}

std::vector<lang::Diagnostic> Document::lint(const explain::LintOptions& options) const {
  return explain::lint(loaded_, options);
}

} // namespace rt::tools::live
