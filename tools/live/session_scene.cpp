#include "tools/live/session_scene.hpp"

namespace rt::tools::live {

SessionScene::SessionScene(lang::Session& session, const lang::LoadOptions& options)
    : session_(session), options_(options) {
  options_.lint = true;
}

const CompiledScene& SessionScene::compiled() {
  const scene::Scene& scene = session_.scene();
  if (!compiled_ || compiled_version_ != session_.version()) {
    std::vector<Part> parts;
    for (const lang::SceneRange& range : session_.ranges()) parts.push_back({range.begin, range.end, range.stamp});
    compiled_.reset();
    compiled_.emplace(scene, parts, cache_);
    compiled_version_ = session_.version();
  }
  return *compiled_;
}

Rendered SessionScene::render(const PictureSettings& settings, const RenderOptions& options) {
  View view = view_of(session_.scene());
  view.size = settings.size.value_or(view.size);
  view.samples = settings.samples.value_or(view.samples);
  return rt::render(compiled(), view, options);
}

Document& SessionScene::document(const PictureSettings& settings) {
  const bool is_current =
      document_ && document_->has_scene() && document_version_ == session_.version() && document_settings_ == settings;
  if (is_current) return *document_;
  document_.reset();
  document_.emplace(lang::load_text(session_.formatted(), "session", session_.folder(), options_), "session", settings);
  document_version_ = session_.version();
  document_settings_ = settings;
  return *document_;
}

} // namespace rt::tools::live
