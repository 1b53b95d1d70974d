#pragma once

#include "lang/load.hpp"
#include "renderer/render/render.hpp"
#include "tools/explain/lint/lint.hpp"
#include "tools/explain/question.hpp"
#include "tools/explain/why/why.hpp"
#include "tools/live/picture_settings.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rt::tools::live {

struct ProbeOptions {
  bool all = false; ///< every hit, not just the nearest
  bool as_json = false;
};

struct WhyOptions {
  explain::Detail detail;
  bool as_json = false;
};

/// A loaded scene, with its pictures and answers about it. It is compiled once, on first use. For one thread at a
/// time.
class Document {
public:
  /// `file` is the name of the scene's own file in answers and diagnostics.
  Document(lang::Loaded loaded, std::string file, const PictureSettings& settings = {});

  /// False if the text is wrong; see `diagnostics`. Everything below them requires a scene.
  bool has_scene() const { return loaded_.scene.has_value(); }
  const std::vector<lang::Diagnostic>& diagnostics() const { return loaded_.diagnostics; }
  const lang::SourceMap& sources() const { return loaded_.sources; }

  const std::string& file() const { return file_; }
  const scene::Scene& scene() const { return *loaded_.scene; }

  /// The same bytes as rendering the file.
  Rendered render(const RenderOptions& options);
  /// With a different view.
  Rendered render(const View& view, const RenderOptions& options);
  /// In Whitted mode, whatever the scene says.
  Rendered render_whitted(const RenderOptions& options);

  // Answers end with a newline. They throw explain::QuestionError for an invalid question.
  std::string probe(const explain::Question& question, const ProbeOptions& options);
  std::string why(const explain::Question& question, const WhyOptions& options);
  /// Requires that it was loaded with `LoadOptions::lint`.
  std::vector<lang::Diagnostic> lint(const explain::LintOptions& options) const;

private:
  const RayQuery& query();

  lang::Loaded loaded_;
  std::string file_;
  std::unique_ptr<const RayQuery> query_;
};

} // namespace rt::tools::live
