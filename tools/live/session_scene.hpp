#pragma once

#include "lang/session/session.hpp"
#include "renderer/compile/compile.hpp"
#include "renderer/compile/compiled_scene.hpp"
#include "tools/live/document.hpp"

#include <optional>

namespace rt::tools::live {

/// A session's scene in pictures and answers. Derived data is kept until the session changes.
class SessionScene {
public:
  /// `options` are those that the session was created with. The session must outlive this.
  SessionScene(lang::Session& session, const lang::LoadOptions& options);

  /// A picture of the current scene; only what changed since the last one is compiled. The session must not change
  /// meanwhile.
  Rendered render(const PictureSettings& settings, const RenderOptions& options);

  /// The document as it would be saved, loaded as the file "session": places in answers are lines of
  /// `Session::formatted`. Without a scene if loading was stopped.
  Document& document(const PictureSettings& settings = {});

private:
  const CompiledScene& compiled();

  lang::Session& session_;
  lang::LoadOptions options_;
  CompileCache cache_{0};
  std::optional<CompiledScene> compiled_; // of the scene at a version
  std::size_t compiled_version_ = 0;
  std::optional<Document> document_; // for a version and these settings
  std::size_t document_version_ = 0;
  PictureSettings document_settings_;
};

} // namespace rt::tools::live
