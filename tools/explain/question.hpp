#pragma once

#include "renderer/render/ray_query.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which ray a question is about.
namespace rt::tools::explain {

/// One of a pixel, a point of the picture, and a ray.
struct Question {
  std::optional<std::array<int, 2>> pixel; ///< its centre, or one of its samples
  std::optional<int> sample;               ///< of the pixel's grid, row by row from 0
  std::optional<std::array<double, 2>> at; ///< continuous: pixel (0, 0) has its centre at (0.5, 0.5)
  std::optional<Ray> ray;                  ///< as given: t counts the lengths of its direction
};

/// The ray and how it is called: "pixel (400, 300)". Throws UsageError where the question is about a place outside the
/// picture, a ray without direction, or not exactly one thing.
struct NamedRay {
  Ray ray;
  std::string name;
};
NamedRay resolve(const Question& question, const scene::Scene& scene, const CameraRays& camera);

/// "400,300" and "0,1.5,-2": numbers between commas. Throws UsageError, naming the option.
std::vector<double> numbers_of(const std::string& text, std::size_t count, std::string_view option);

} // namespace rt::tools::explain
