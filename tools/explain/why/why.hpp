#pragma once

#include "tools/explain/naming.hpp"
#include "tools/explain/question.hpp"
#include "tools/explain/text.hpp"
#include "tools/explain/why/light_path.hpp"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Why a ray carries the light that it carries.
namespace rt::tools::explain {

/// A question that has been traced.
struct Answer {
  /// `file` is the name of the scene's own file in `scene.files`. Scene and tracer must outlive the answer.
  Answer(const scene::Scene& scene, std::string_view file, const RayQuery& query, const Question& question);

  const scene::Scene& scene;
  const CompiledScene& compiled;
  std::string_view file;
  Namer namer;
  NamedRay ray;
  std::unique_ptr<RayNode> tree;
  Sum sum;
  LightPath path;
  std::optional<Color> pixel; ///< if the pixel has several samples: their mean
};

/// How much of the ray tree an explanation shows; a ray that is not shown is a line with its radiance. By default it
/// shows the rays on the path that carries most of the light.
struct Detail {
  bool all = false;              ///< every ray
  std::optional<int> depth{};    ///< rays down to this depth, the first ray's being 0
  std::optional<double> least{}; ///< rays with at least this weight, by its largest component

  bool is_path_only() const { return !all && !depth && !least; }
};
bool shows(const Answer& answer, const Detail& detail, const RayNode& ray);

/// The rays, the terms of the radiance, and the sentence.
std::string why_text(const Answer& answer, const Detail& detail);
nlohmann::ordered_json why_json(const Answer& answer, const Detail& detail);

/// A term of the sum in words; terms with the same words are merged.
struct NamedTerm {
  std::string text; ///< "sun (line 7) on `table` (line 30), mirrored in `ball` (line 9)"
  Color value;
};
/// All of them, largest first.
std::vector<NamedTerm> named_terms(const Answer& answer);

/// One sentence: why it is dark, bright or coloured.
std::string verdict(const Answer& answer);

/// The displayed colour: "#rrggbb".
std::string shown(const Color& linear, const ToneMapping& mapping);

/// How a term's light got there: "the sky, mirrored in `ball` (line 7)" without its first words.
std::string way_text(const Namer& namer, const Sum& sum, std::uint32_t last_step);

} // namespace rt::tools::explain
