#pragma once

#include "renderer/render/ray_query.hpp"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Which ray a question is about.
namespace rt::tools::explain {

/// An invalid question; the message is for the user.
struct QuestionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One of a pixel, a point of the picture, and a ray.
struct Question {
  std::optional<std::array<int, 2>> pixel{}; ///< its centre, or one of its samples
  std::optional<int> sample{};               ///< of the pixel's grid, row by row from 0
  std::optional<std::array<double, 2>> at{}; ///< continuous: pixel (0, 0) has its centre at (0.5, 0.5)
  std::optional<Ray> ray{};                  ///< as given: t is in multiples of its direction
};

/// A question as written in the options of a command.
struct QuestionText {
  std::string pixel{}, at{};      ///< "400,300", "10.5,20.25"
  int sample = -1;                ///< none
  std::vector<std::string> ray{}; ///< origin and direction, "0,1.5,-2" each
};
/// Throws QuestionError for anything that is not a pixel, a point or a ray.
Question parse(const QuestionText& text);

/// The ray and its name: "pixel (400, 300)". Throws QuestionError for a place outside the picture, a ray without
/// direction, or not exactly one of the three.
struct NamedRay {
  Ray ray;
  std::string name;
};
NamedRay resolve(const Question& question, const scene::Scene& scene, const CameraRays& camera);

} // namespace rt::tools::explain
