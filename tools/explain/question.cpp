#include "tools/explain/question.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace rt::tools::explain {
namespace {

NamedRay pixel_ray(const Question& q, const scene::Scene& scene, const CameraRays& camera) {
  const auto [x, y] = *q.pixel;
  if (x < 0 || y < 0 || x >= scene.size[0] || y >= scene.size[1])
    throw QuestionError(
        fmt::format("pixel {},{} is outside the picture of {}×{} pixels", x, y, scene.size[0], scene.size[1]));
  if (!q.sample) return {camera.ray(x + 0.5, y + 0.5), fmt::format("pixel ({}, {})", x, y)};
  const int samples = scene::whitted_samples(scene);
  if (*q.sample < 0 || *q.sample >= samples)
    throw QuestionError(
        fmt::format("the pixel has {} samples, numbered from 0: there is no sample {}", samples, *q.sample));
  return {camera.ray({x, y}, Sampler(samples), *q.sample), fmt::format("sample {} of pixel ({}, {})", *q.sample, x, y)};
}

NamedRay point_ray(const Question& q, const scene::Scene& scene, const CameraRays& camera) {
  const auto [x, y] = *q.at;
  if (!(x >= 0 && y >= 0 && x <= scene.size[0] && y <= scene.size[1]))
    throw QuestionError(
        fmt::format("{},{} is outside the picture of {}×{} pixels", x, y, scene.size[0], scene.size[1]));
  return {camera.ray(x, y), fmt::format("image point ({}, {})", x, y)};
}

// "400,300" and "0,1.5,-2": numbers between commas.
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
    throw QuestionError(fmt::format("{} takes {} comma-separated numbers, not `{}`", option, count, text));
  return numbers;
}

void require_one_of(bool pixel, bool at, bool ray) {
  if (int{pixel} + int{at} + int{ray} != 1)
    throw QuestionError("specify exactly one of --pixel X,Y, --at X,Y and --ray OX,OY,OZ DX,DY,DZ");
}

} // namespace

NamedRay resolve(const Question& q, const scene::Scene& scene, const CameraRays& camera) {
  require_one_of(q.pixel.has_value(), q.at.has_value(), q.ray.has_value());
  if (q.sample && !q.pixel) throw QuestionError("--sample goes with --pixel");
  if (q.pixel) return pixel_ray(q, scene, camera);
  if (q.at) return point_ray(q, scene, camera);
  if (q.ray->direction == Vec3{}) throw QuestionError("--ray needs a direction that is not 0,0,0");
  return {*q.ray, "ray"};
}

Question parse(const QuestionText& text) {
  require_one_of(!text.pixel.empty(), !text.at.empty(), !text.ray.empty());
  Question q;
  if (!text.pixel.empty()) {
    const auto xy = numbers_of(text.pixel, 2, "--pixel");
    if (xy[0] != std::trunc(xy[0]) || xy[1] != std::trunc(xy[1]) || std::abs(xy[0]) > 1e9 || std::abs(xy[1]) > 1e9)
      throw QuestionError("--pixel takes integers; for a point between pixel centres use --at");
    q.pixel = {static_cast<int>(xy[0]), static_cast<int>(xy[1])};
  }
  if (text.sample >= 0) q.sample = text.sample;
  if (!text.at.empty()) {
    const auto xy = numbers_of(text.at, 2, "--at");
    q.at = {xy[0], xy[1]};
  }
  if (!text.ray.empty()) {
    const auto o = numbers_of(text.ray.at(0), 3, "--ray"), d = numbers_of(text.ray.at(1), 3, "--ray");
    q.ray = Ray{{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
  }
  return q;
}

} // namespace rt::tools::explain
