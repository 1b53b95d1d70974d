#include "renderer/integrators/path/direct_light.hpp"

#include "renderer/integrators/rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rt {
namespace {

// A lamp's point is hit where it was sampled, up to this fraction of the distance.
constexpr double same_place = 1e-7;
// Panes of glass on the way to a lamp: if there are more, they transmit nothing.
constexpr int most_panes = 1 << 10;

} // namespace

struct DirectLighting::LampLight {
  LightSample sample;
  Color reflected; // without shadows
};

// A ray on its way to a lamp.
struct DirectLighting::Sight {
  Walk walk;
  double distance; // the remaining distance
  Color passed = white;
};

// The point of a shape that shines, and what is let by on the way there.
struct DirectLighting::LampPoint {
  Surface surface;
  Color passed;
};

std::optional<DirectLighting::LampLight> DirectLighting::reached(const ScatteringPoint& at, const Light& lamp) const {
  const LightSample sample = sample_light(lamp, at.surface.position);
  if (sample.color == black || sample.distance == 0) return std::nullopt;
  const Color reflected = sample.color * at.reflected(sample.to_light) * std::numbers::pi;
  if (reflected == black) return std::nullopt;
  return LampLight{sample, reflected};
}

// Glass transmits a lamp's light unbent, as in Whitted mode: bent, it would never reach a lamp without size.
Color DirectLighting::unblocked(const ScatteringPoint& at, const Light& lamp, const LampLight& light) {
  if (!lamp.shadows) return light.reflected;
  ++counts_.shadow;
  const Ray ray = OwnRules::leave(at.surface, light.sample.to_light);
  if (lamps_.sized.ball_on(ray, light.sample.distance)) return black;
  if (scene_.absorbs() || at.walk.contact.is_inside()) [[unlikely]]
    return light.reflected * filtered(at, light.sample);
  return light.reflected * scene_.transmittance(ray, OwnRules::shadow_range(light.sample.distance), scratch_);
}

// The transmittance of all that is on the straight line to a lamp, including media between surfaces.
Color DirectLighting::filtered(const ScatteringPoint& at, const LightSample& lamp) {
  Sight sight = sight_from(at, lamp.to_light, OwnRules::shadow_range(lamp.distance).upper);
  for (int panes = 0; panes < most_panes; ++panes) {
    const auto met = walker_.next(sight.walk);
    const bool arrives = !met || met->length >= sight.distance;
    sight.passed *= walker_.left_after(sight.walk, arrives ? sight.distance : met->length);
    if (arrives) return sight.passed;
    const MaterialValues& values = scene_.values(met->surface, values_);
    sight.passed *= values.color * values.refract;
    if (sight.passed == black) return black;
    sight.distance -= met->length;
    walker_.leave(sight.walk, met->surface, !values.thin, lamp.to_light);
  }
  return black;
}

Color DirectLighting::from_lamps(const ScatteringPoint& at) {
  Color sum = black;
  for (const Light& lamp : lamps_.sizeless)
    if (const auto light = reached(at, lamp)) sum += unblocked(at, lamp, *light);
  return sum;
}

Color DirectLighting::from_one_lamp(const ScatteringPoint& at, double number) {
  const Light* picked = nullptr;
  std::optional<LampLight> picked_light;
  double sum = 0, picked_weight = 0;
  for (const Light& lamp : lamps_.sizeless) {
    const auto light = reached(at, lamp);
    if (!light) continue;
    // Reservoir sampling: each replaces those before it with its due probability, and what is left of the number is
    // again uniform.
    const double weight = max_component(light->reflected), probability = weight / (sum += weight);
    if (number < probability) {
      picked = &lamp, picked_light = light, picked_weight = weight;
      number /= probability;
    } else {
      number = (number - probability) / (1 - probability);
    }
  }
  return picked ? unblocked(at, *picked, *picked_light) * (sum / picked_weight) : black;
}

DirectLighting::Sight DirectLighting::sight_from(const ScatteringPoint& at, const Vec3& direction, double distance) {
  Sight sight{walker_.start_like(*at.walker, at.walk), distance};
  sight.walk.meets_casting_only = true;
  walker_.leave(sight.walk, at.surface, at.is_boundary, direction);
  return sight;
}

std::optional<DirectLighting::LampPoint> DirectLighting::sight_of(std::uint32_t emitter, const EmitterSample& sample,
                                                                  const ScatteringPoint& at) {
  ++counts_.shadow;
  Sight sight = sight_from(at, sample.direction, sample.distance);
  for (int panes = 0; panes < most_panes; ++panes) {
    const auto met = walker_.next(sight.walk);
    if (!met || lamps_.sized.ball_on(sight.walk.ray, met->length)) return std::nullopt;
    go_to(sight, met->length);
    if (std::abs(sight.distance) <= same_place * sample.distance && lamps_.emitters.find(met->hit) == emitter)
      return LampPoint{met->surface, sight.passed};
    if (sight.distance < 0 || !transmit_straight(sight, met->surface)) return std::nullopt;
  }
  return std::nullopt;
}

// The transmittance on the way to the lamp, if it is seen at all.
std::optional<Color> DirectLighting::sight_of_lamp(std::uint32_t lamp, const SizedLamps::Direction& way,
                                                   const ScatteringPoint& at) {
  ++counts_.shadow;
  Sight sight = sight_from(at, way.to_lamp, way.distance);
  for (int panes = 0; panes < most_panes; ++panes) {
    const auto met = walker_.next(sight.walk);
    const double end = met ? met->length : std::numeric_limits<double>::infinity();
    const auto ball = lamps_.sized.ball_on(sight.walk.ray, end);
    if (ball ? ball->index != lamp : !met && !std::isinf(way.distance)) return std::nullopt;
    go_to(sight, ball ? ball->distance : std::min(end, std::numeric_limits<double>::max()));
    if (ball || !met) return sight.passed;
    if (!transmit_straight(sight, met->surface)) return std::nullopt;
  }
  return std::nullopt;
}

void DirectLighting::go_to(Sight& sight, double length) const {
  sight.passed *= walker_.left_after(sight.walk, length);
  sight.distance -= length;
}

// What does not bend a ray lets it by; what does is for the path to find a way through.
bool DirectLighting::transmit_straight(Sight& sight, const Surface& surface) {
  const MaterialValues& values = scene_.values(surface, values_);
  if (!(values.refract > 0)) return false;
  const ScatteringPoint pane = scattering_point(path_scene_, walker_, sight.walk, surface, values);
  sight.passed *= pane.bsdf.passed_straight();
  walker_.leave(sight.walk, surface, pane.is_boundary, sight.walk.ray.direction);
  return sight.passed != black;
}

Color DirectLighting::from_sized_lamps(const ScatteringPoint& at, const std::array<double, 4>& numbers) {
  const Vec3& p = at.surface.position;
  const auto choice = lamps_.sized.choose(p, numbers[2]);
  if (!choice) return black;
  const SizedLamps::Direction way = lamps_.sized.sample(choice->index, p, numbers[0], numbers[1]);
  const Color reflected = at.reflected(way.to_lamp);
  if (reflected == black) return black;
  const auto passed = sight_of_lamp(choice->index, way, at);
  if (!passed) return black;
  const double density = choice->probability * lamps_.sized.density(choice->index, p);
  const double weight = balance(density, at.density(way.to_lamp)) / density;
  return reflected * *passed * lamps_.sized.radiance(choice->index, p) * weight;
}

Color DirectLighting::from_emitters(const ScatteringPoint& at, const std::array<double, 4>& numbers) {
  if (lamps_.emitters.is_empty()) return black;
  const Vec3& p = at.surface.position;
  const Emitters::Choice choice = lamps_.emitters.choose(p, numbers[2]);
  const Emitter& emitter = lamps_.emitters[choice.index];
  const auto sample = emitter.sample(p, numbers[0], numbers[1]);
  if (!sample) return black;
  const Color reflected = at.reflected(sample->direction);
  if (reflected == black) return black;
  const auto lamp = sight_of(choice.index, *sample, at);
  if (!lamp) return black;
  const Color radiance = emission(scene_.values(lamp->surface, values_));
  const double density =
      choice.probability * emitter.density(p, sample->direction, lamp->surface.position, lamp->surface.normal);
  const double weight = balance(density, at.density(sample->direction)) / density;
  return reflected * lamp->passed * radiance * weight;
}

} // namespace rt
