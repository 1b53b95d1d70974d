#include "tools/explain/why/why.hpp"

#include "renderer/image/quantise.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::tools::explain {

Answer::Answer(const scene::Scene& described, std::string_view file_name, const RayQuery& query,
               const Question& question)
    : scene(described), compiled(query.scene()), file(file_name), namer(described, file_name),
      ray(resolve(question, described, query.camera())), tree(record(query, ray.ray)), sum(take_apart(*tree)),
      path(main_path(*tree, sum)) {
  if (question.pixel && scene::whitted_samples(scene) > 1)
    pixel = query.pixel((*question.pixel)[0], (*question.pixel)[1]);
}

bool shows(const Answer& answer, const Detail& detail, const RayNode& ray) {
  if (!ray.is_expanded) return false;
  const std::vector<PathStep>& path = answer.path.steps;
  if (detail.is_path_only())
    return std::any_of(path.begin(), path.end(), [&](const PathStep& step) { return step.ray == &ray; });
  return ray.depth <= detail.depth.value_or(ray.depth) && max_component(ray.weight) >= detail.least.value_or(0);
}

std::string shown(const Color& linear, const ToneMapping& mapping) {
  const SrgbQuantiser quantise(8);
  const ToneCurve curve(mapping);
  const auto byte = [&](double v) { return quantise(curve(static_cast<float>(v))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(linear.r), byte(linear.g), byte(linear.b));
}

} // namespace rt::tools::explain
