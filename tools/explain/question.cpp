#include "tools/explain/question.hpp"

#include "tools/terminal/exit_code.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace rt::tools::explain {
namespace {

NamedRay pixel_ray(const Question& q, const scene::Scene& scene, const CameraRays& camera) {
  const auto [x, y] = *q.pixel;
  if (x < 0 || y < 0 || x >= scene.size[0] || y >= scene.size[1])
    throw UsageError(
        fmt::format("pixel {},{} is outside the picture of {}×{} pixels", x, y, scene.size[0], scene.size[1]));
  if (!q.sample) return {camera.ray(x + 0.5, y + 0.5), fmt::format("pixel ({}, {})", x, y)};
  if (*q.sample < 0 || *q.sample >= scene.samples)
    throw UsageError(
        fmt::format("the pixel has {} samples, numbered from 0: there is no sample {}", scene.samples, *q.sample));
  return {camera.ray({x, y}, Sampler(scene.samples), *q.sample),
          fmt::format("sample {} of pixel ({}, {})", *q.sample, x, y)};
}

NamedRay point_ray(const Question& q, const scene::Scene& scene, const CameraRays& camera) {
  const auto [x, y] = *q.at;
  if (!(x >= 0 && y >= 0 && x <= scene.size[0] && y <= scene.size[1]))
    throw UsageError(fmt::format("{},{} is outside the picture of {}×{} pixels", x, y, scene.size[0], scene.size[1]));
  return {camera.ray(x, y), fmt::format("image point ({}, {})", x, y)};
}

} // namespace

NamedRay resolve(const Question& q, const scene::Scene& scene, const CameraRays& camera) {
  if ((q.pixel ? 1 : 0) + (q.at ? 1 : 0) + (q.ray ? 1 : 0) != 1)
    throw UsageError("ask about one of --pixel X,Y, --at X,Y and --ray OX,OY,OZ DX,DY,DZ");
  if (q.sample && !q.pixel) throw UsageError("--sample goes with --pixel");
  if (q.pixel) return pixel_ray(q, scene, camera);
  if (q.at) return point_ray(q, scene, camera);
  if (q.ray->direction == Vec3{}) throw UsageError("--ray needs a direction that is not 0,0,0");
  return {*q.ray, "ray"};
}

std::vector<double> numbers_of(const std::string& text, std::size_t count, std::string_view option) {
  std::vector<double> numbers;
  const char* p = text.c_str();
  for (;;) {
    char* end = nullptr;
    const double number = std::strtod(p, &end);
    if (end == p || !std::isfinite(number)) break;
    numbers.push_back(number);
    p = end;
    if (*p != ',') break;
    ++p;
  }
  if (*p != '\0' || numbers.size() != count)
    throw UsageError(fmt::format("{} takes {} numbers with commas between them, not `{}`", option, count, text));
  return numbers;
}

} // namespace rt::tools::explain
