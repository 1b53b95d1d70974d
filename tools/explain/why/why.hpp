#pragma once

#include "tools/explain/naming.hpp"
#include "tools/explain/question.hpp"
#include "tools/explain/text.hpp"
#include "tools/explain/why/contributions.hpp"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// Why a ray brings the light it brings.
namespace rt::tools::explain {

/// A question that has been traced.
struct Answer {
  /// `file` is what the scene's own file is called in `scene.files`. Scene and tracer must outlive the answer.
  Answer(const scene::Scene& scene, std::string_view file, const RayQuery& query, const Question& question);

  const scene::Scene& scene;
  const CompiledScene& compiled;
  std::string_view file;
  Namer namer;
  NamedRay ray;
  std::unique_ptr<RayNode> tree;
  Sum sum;
  std::optional<Color> pixel; ///< where the pixel has several samples: their mean
};

/// The whole tree of rays down to `depth`, the list of what adds up to the radiance, and the sentence.
std::string why_text(const Answer& answer, int depth);
nlohmann::ordered_json why_json(const Answer& answer, int depth);

/// One sentence: why it is dark, bright or coloured as it is.
std::string verdict(const Answer& answer);

/// What the picture shows of it: "#rrggbb".
std::string shown(const Color& linear, const ToneMapping& mapping);

/// How a term's light came: "the sky, mirrored in `ball` (line 7)" without its first words.
std::string way_text(const Namer& namer, const Sum& sum, std::uint32_t last_step);

} // namespace rt::tools::explain
