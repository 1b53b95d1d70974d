#include "renderer/integrators/path/direct_light.hpp"

#include "renderer/integrators/rules.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rt {
namespace {

// A lamp's point is hit where it was drawn, up to this share of the distance.
constexpr double same_place = 1e-7;
// Panes of glass on the way to a lamp: where more stand, they let nothing by.
constexpr int most_panes = 1 << 10;

} // namespace

double DiffusePoint::density(const Vec3& direction) const {
  return share * std::max(0.0, dot(normal, direction)) / std::numbers::pi;
}

struct DirectLighting::LampLight {
  LightSample sample;
  Color reflected; // without shadows
};

std::optional<DirectLighting::LampLight> DirectLighting::reached(const DiffusePoint& at, const Light& lamp) const {
  const LightSample sample = sample_light(lamp, at.surface.point);
  const double cosine = dot(at.normal, sample.to_light);
  if (!(cosine > 0)) return std::nullopt;
  const Color reflected = sample.color * at.albedo * cosine;
  if (reflected == black) return std::nullopt;
  return LampLight{sample, reflected};
}

// Glass lets a lamp's light by unbent, as in Whitted's mode: bent, it would never find a lamp without size.
Color DirectLighting::unblocked(const DiffusePoint& at, const Light& lamp, const LampLight& light) {
  if (!lamp.shadows) return light.reflected;
  ++counts_.shadow;
  const Ray ray = OwnRules::leave(at.surface, light.sample.to_light);
  if (lamps_.sized.ball_on(ray, light.sample.distance)) return black;
  return light.reflected * scene_.transmittance(ray, OwnRules::shadow_range(light.sample.distance), scratch_);
}

Color DirectLighting::from_lamps(const DiffusePoint& at) {
  Color sum = black;
  for (const Light& lamp : lamps_.sizeless)
    if (const auto light = reached(at, lamp)) sum += unblocked(at, lamp, *light);
  return sum;
}

Color DirectLighting::from_one_lamp(const DiffusePoint& at, double number) {
  const Light* picked = nullptr;
  std::optional<LampLight> picked_light;
  double sum = 0, picked_weight = 0;
  for (const Light& lamp : lamps_.sizeless) {
    const auto light = reached(at, lamp);
    if (!light) continue;
    // Each takes the place of those before it with the probability that is its due, and what is left of the number is
    // as good as new.
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

// A ray on its way to a lamp, or where it met it.
struct DirectLighting::Sight {
  Ray ray;
  double distance; // that is left
  RayHit hit{};
  Surface surface{};
  Color passed = white;
};

std::optional<DirectLighting::Sight> DirectLighting::sight_of(std::uint32_t emitter, const EmitterSample& sample,
                                                              const DiffusePoint& at) {
  Sight sight{OwnRules::leave(at.surface, sample.direction), sample.distance};
  ++counts_.shadow;
  MediumStacks::List inside = surroundings(at);
  for (int panes = 0; panes < most_panes; ++panes) {
    sight.hit = scene_.nearest_casting(sight.ray, OwnRules::hit_range(), scratch_);
    if (!sight.hit || lamps_.sized.ball_on(sight.ray, sight.hit.t)) return std::nullopt;
    sight.surface = scene_.surface(sight.ray, sight.hit);
    if (std::abs(sight.hit.t - sight.distance) <= same_place * sample.distance &&
        lamps_.emitters.find(sight.hit) == emitter)
      return sight;
    if (!pass(sight, inside)) return std::nullopt;
  }
  return std::nullopt;
}

MediumStacks::List DirectLighting::surroundings(const DiffusePoint& at) {
  media_.release(0);
  return media_.make({at.media.begin(at.inside), at.inside.size});
}

// What is let by on the way to the lamp, if it is seen at all.
std::optional<Color> DirectLighting::sight_of_lamp(std::uint32_t lamp, const SizedLamps::Direction& way,
                                                   const DiffusePoint& at) {
  Sight sight{OwnRules::leave(at.surface, way.to_lamp), way.distance};
  ++counts_.shadow;
  MediumStacks::List inside = surroundings(at);
  for (int panes = 0; panes < most_panes; ++panes) {
    sight.hit = scene_.nearest_casting(sight.ray, OwnRules::hit_range(), scratch_);
    const double end = sight.hit ? sight.hit.t : std::numeric_limits<double>::infinity();
    if (const auto ball = lamps_.sized.ball_on(sight.ray, end))
      return ball->index == lamp ? std::optional(sight.passed) : std::nullopt;
    if (!sight.hit) return std::isinf(way.distance) ? std::optional(sight.passed) : std::nullopt;
    sight.surface = scene_.surface(sight.ray, sight.hit);
    if (!pass(sight, inside)) return std::nullopt;
  }
  return std::nullopt;
}

Color DirectLighting::from_sized_lamps(const DiffusePoint& at, const std::array<double, 4>& numbers) {
  const Vec3& p = at.surface.point;
  const auto choice = lamps_.sized.choose(p, numbers[2]);
  if (!choice) return black;
  const SizedLamps::Direction way = lamps_.sized.sample(choice->index, p, numbers[0], numbers[1]);
  const double cosine = dot(at.normal, way.to_lamp);
  if (!(cosine > 0)) return black;
  const auto passed = sight_of_lamp(choice->index, way, at);
  if (!passed) return black;
  const double density = choice->probability * lamps_.sized.density(choice->index, p);
  const double weight = balance(density, at.density(way.to_lamp)) / density;
  return at.albedo * *passed * lamps_.sized.radiance(choice->index, p) * (cosine / std::numbers::pi * weight);
}

// What does not bend a ray lets it by; what does is for the path to find a way through.
bool DirectLighting::pass(Sight& sight, MediumStacks::List& inside) {
  const WhittedBsdf bsdf(scene_.values(sight.surface, values_));
  if (!bsdf.is_transparent() || sight.hit.t > sight.distance) return false;
  const Medium medium{sight.surface.order, sight.surface.ior};
  const double eta = media_.transition(inside, medium).eta();
  const double cosine = std::abs(dot(sight.surface.shading_normal, sight.ray.direction));
  const Lobes through = lobes(bsdf, cosine, eta, media_.fresnel_eta(inside, medium));
  if (through.is_bent || through.transmission == black) return false;
  sight.passed *= through.transmission;
  sight.distance -= sight.hit.t;
  inside = media_.after(inside, medium, 0);
  sight.ray = OwnRules::leave(sight.surface, sight.ray.direction);
  return true;
}

Color DirectLighting::from_emitters(const DiffusePoint& at, const std::array<double, 4>& numbers) {
  if (lamps_.emitters.is_empty()) return black;
  const Vec3& p = at.surface.point;
  const Emitters::Choice choice = lamps_.emitters.choose(p, numbers[2]);
  const Emitter& emitter = lamps_.emitters[choice.index];
  const auto sample = emitter.sample(p, numbers[0], numbers[1]);
  if (!sample) return black;
  const double cosine = dot(at.normal, sample->direction);
  if (!(cosine > 0)) return black;
  const auto sight = sight_of(choice.index, *sample, at);
  if (!sight) return black;
  const WhittedBsdf bsdf(scene_.values(sight->surface, values_));
  const double density =
      choice.probability * emitter.density(p, sample->direction, sight->surface.point, sight->surface.geometric_normal);
  const double weight = balance(density, at.density(sample->direction)) / density;
  return at.albedo * sight->passed * bsdf.body() * bsdf.values().emission * (cosine / std::numbers::pi * weight);
}

} // namespace rt
