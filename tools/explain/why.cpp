#include "tools/explain/why.hpp"

#include "renderer/image/quantise.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::tools::explain {
namespace {

// The picture's own way to a pixel: the mean over the grid of its samples.
Color mean_of_samples(const RayQuery& query, int x, int y, int side) {
  Color sum = black;
  for (int i = 0; i < side * side; ++i) sum += query.radiance(query.camera().ray(x, y, i, side));
  return sum * (1.0 / (side * side));
}

} // namespace

Answer::Answer(const scene::Scene& described, std::string_view file_name, const RayQuery& query,
               const Question& question)
    : scene(described), compiled(query.scene()), file(file_name), namer(described, file_name),
      ray(resolve(question, described, query.camera())), tree(record(query, ray.ray)), sum(take_apart(*tree)),
      is_of_pixel(question.pixel.has_value()) {
  const int side = static_cast<int>(std::lround(std::sqrt(scene.samples)));
  if (question.pixel && side > 1) pixel = mean_of_samples(query, (*question.pixel)[0], (*question.pixel)[1], side);
}

std::string shown(const Color& linear) {
  const SrgbQuantiser quantise(8);
  const auto byte = [&](double v) { return quantise(static_cast<float>(v)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(linear.r), byte(linear.g), byte(linear.b));
}

} // namespace rt::tools::explain
