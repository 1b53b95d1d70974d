#include "renderer/lighting/sized_lamps.hpp"

#include "renderer/sampling/mappings.hpp"
#include "renderer/shapes/sphere.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rt {

bool has_size(const Light& lamp) {
  return lamp.shadows && extent(lamp).size > 0;
}

SizedLamps::SizedLamps(std::span<const Light> lamps) {
  for (const Light& lamp : lamps) {
    const LightExtent where = extent(lamp);
    if (has_size(lamp)) list_.push_back({&lamp, where.is_infinitely_far, where.place, where.size});
  }
}

double SizedLamps::weight(const SizedLamp& lamp, const Vec3& p) const {
  return cap_height(lamp, p) > 0 ? max_component(sample_light(*lamp.light, p).color) : 0;
}

std::optional<SizedLamps::Choice> SizedLamps::choose(const Vec3& p, double u) const {
  double sum = 0;
  for (const SizedLamp& lamp : list_) sum += weight(lamp, p);
  if (!(sum > 0)) return std::nullopt;
  double rest = u * sum;
  std::uint32_t picked = 0;
  for (std::uint32_t i = 0; i < list_.size(); ++i) {
    const double own = weight(list_[i], p);
    if (own > 0) picked = i;
    if (rest < own) break;
    rest -= own;
  }
  return Choice{picked, weight(list_[picked], p) / sum};
}

double SizedLamps::probability(std::uint32_t index, const Vec3& p) const {
  double sum = 0;
  for (const SizedLamp& lamp : list_) sum += weight(lamp, p);
  return sum > 0 ? weight(list_[index], p) / sum : 0;
}

// 1 − cos of half the angle it subtends, without a difference that cancels; 0 from inside a sphere.
double SizedLamps::cap_height(const SizedLamp& lamp, const Vec3& p) const {
  if (lamp.is_sun) return lamp.size;
  const Vec3 way = lamp.place - p;
  const double sine_squared = lamp.size * lamp.size / dot(way, way);
  return sine_squared < 1 ? sine_squared / (1 + std::sqrt(1 - sine_squared)) : 0;
}

SizedLamps::Direction SizedLamps::sample(std::uint32_t index, const Vec3& p, double u, double v) const {
  const SizedLamp& lamp = list_[index];
  const Vec3 middle = lamp.is_sun ? lamp.place : normalize(lamp.place - p);
  const Vec3 direction = TangentFrame(middle).vector(to_cone(u, v, cap_height(lamp, p)));
  if (lamp.is_sun) return {direction, std::numeric_limits<double>::infinity()};
  Hit hit{dot(lamp.place - p, direction), 0}; // it only touches, and rounding says that it does not
  intersect(SphereGeometry{lamp.place, lamp.size}, {p, direction}, {}, hit);
  return {direction, hit.t};
}

double SizedLamps::density(std::uint32_t index, const Vec3& p) const {
  const double height = cap_height(list_[index], p);
  return height > 0 ? 1 / (2 * std::numbers::pi * height) : 0;
}

Color SizedLamps::radiance(std::uint32_t index, const Vec3& p) const {
  const SizedLamp& lamp = list_[index];
  const LightSample sample = sample_light(*lamp.light, p);
  if (lamp.is_sun) return sample.color * (1 / (lamp.size * (2 - lamp.size))); // sin² = 1 − cos²
  return sample.color * (sample.distance * sample.distance / (lamp.size * lamp.size));
}

std::optional<SizedLamps::BallHit> SizedLamps::ball_on(const Ray& ray, double end) const {
  std::optional<BallHit> nearest;
  for (std::uint32_t i = 0; i < list_.size(); ++i) {
    const SizedLamp& lamp = list_[i];
    Hit hit;
    if (lamp.is_sun || !intersect(SphereGeometry{lamp.place, lamp.size}, ray, {0, end}, hit)) continue;
    nearest = BallHit{i, hit.t};
    end = hit.t;
  }
  return nearest;
}

std::optional<std::uint32_t> SizedLamps::sun_behind(const Vec3& direction, std::optional<std::uint32_t> after) const {
  for (std::uint32_t i = after ? *after + 1 : 0; i < list_.size(); ++i)
    if (list_[i].is_sun && dot(direction, list_[i].place) >= 1 - list_[i].size) return i;
  return std::nullopt;
}

} // namespace rt
