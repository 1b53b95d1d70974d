#include "renderer/integrators/path/path_tracer.hpp"

#include "renderer/integrators/rules.hpp"
#include "renderer/math/rounding.hpp"
#include "renderer/math/static_vector.hpp"
#include "renderer/sampling/mappings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rt {
namespace {

// Surfaces that a path may cross unbent: they do not scatter, and if nothing else ends a path this many do.
constexpr int most_crossings = 1 << 20;
// From this surface on, the first being 0, paths may end by Russian roulette.
constexpr int first_roulette = 3;

// Groups of numbers: two for the camera, then three for each surface that is hit.
constexpr std::uint32_t scattering_group(int vertex) {
  return first_free_group + 3 * static_cast<std::uint32_t>(vertex);
}
constexpr std::uint32_t lamp_group(int vertex) {
  return scattering_group(vertex) + 1;
}
constexpr std::uint32_t sized_lamp_group(int vertex) {
  return scattering_group(vertex) + 2;
}

} // namespace

struct PathTracer::Path {
  Walk walk;
  const SampleStream& stream;
  Color throughput = white;
  Color sum = black;
  int vertices = 0;            // surfaces hit
  int depth = 0;               // those that the path did not cross unbent
  Vec3 from = walk.ray.origin; // where its direction last changed
  // Whether that was sampled from a density, so that a lamp could have been sampled instead, and how large that was.
  bool has_rival = false;
  double density = 0;
};

PathTracer::PathTracer(const PathScene& scene, const std::atomic<bool>* stop)
    : path_scene_(scene), scene_(scene.scene), lamps_(scene.lamps), stop_(stop), walker_(scene_),
      direct_(scene, counts_) {}

void PathTracer::radiance(std::span<const Ray> rays, std::span<const SampleStream> streams,
                          const std::vector<Medium>& inside, std::span<Color> results) {
  counts_.camera += rays.size();
  StaticVector<RayHit, camera_batch_size> hits;
  for (std::size_t i = 0; i < rays.size(); ++i) hits.add([] { return RayHit{}; });
  scene_.nearest(rays, OwnRules::hit_range(), hits, scratch_);
  for (std::size_t i = 0; i < rays.size(); ++i) results[i] = follow(rays[i], hits[i], streams[i], inside);
}

Color PathTracer::follow(const Ray& ray, const RayHit& first, const SampleStream& stream,
                         const std::vector<Medium>& inside) {
  Path path{walker_.start(ray, inside), stream};
  if (intersect(path, first)) continue_path(path);
  return path.sum;
}

// The path starts at a white Lambertian surface of no extent: π times what that reflects.
Color PathTracer::irradiance(const Vec3& point, const Vec3& normal, const SampleStream& stream,
                             const std::vector<Medium>& inside) {
  static const MaterialValues white_matte{.diffuse = white};
  static const MaterialTables no_tables = make_material_tables(white_matte, std::array{1.0});
  Path path{walker_.start({point, -normal}, inside), stream};
  const Surface surface{{point, normal, rounding_bound(64) * (magnitude(point) + 1)}, normal};
  const ScatteringPoint at{surface,  TangentFrame(normal), Bsdf(white_matte, no_tables, 1, {0, 0, 1}), false, &walker_,
                           path.walk};
  if (scatter(path, at)) continue_path(path);
  return path.sum * std::numbers::pi;
}

void PathTracer::continue_path(Path& path) {
  for (int crossings = 0; crossings < most_crossings && !is_stopped(); ++crossings)
    if (!intersect(path, walker_.nearest(path.walk))) return;
}

// False: the path ends there.
bool PathTracer::intersect(Path& path, const RayHit& hit) {
  const auto met = walker_.intersect(path.walk, hit);
  if (add_lamp(path, met ? met->length : std::numeric_limits<double>::infinity())) return false;
  path.throughput *= walker_.left_after(path.walk, met ? met->length : std::numeric_limits<double>::max());
  if (!met) {
    path.sum += path.throughput * scene_.environment(path.walk.ray.direction);
    return false;
  }
  const MaterialValues& values = scene_.values(met->surface, values_);
  add_emission(path, emission(values), *met);
  const ScatteringPoint at = scattering_point(path_scene_, walker_, path.walk, met->surface, values);
  return path.depth > scene_.max_depth() ? passes(path, at) : scatter(path, at);
}

// The light of a lamp with a size in front of whatever the path hits at `end`: true if the path ends there. A sun is
// seen where it hits nothing, in front of the rest of the sky.
bool PathTracer::add_lamp(Path& path, double end) const {
  const SizedLamps& lamps = lamps_.sized;
  if (lamps.is_empty()) return false;
  const auto add = [&](std::uint32_t lamp, double distance) {
    double weight = 1;
    if (path.has_rival)
      weight = balance(path.density, lamps.probability(lamp, path.from) * lamps.density(lamp, path.from));
    path.sum += path.throughput * walker_.left_after(path.walk, distance) * lamps.radiance(lamp, path.from) * weight;
  };
  const Ray& ray = path.walk.ray;
  if (const auto ball = lamps.ball_on(ray, end)) {
    add(ball->index, ball->distance);
    return true;
  }
  if (std::isinf(end))
    for (auto sun = lamps.sun_behind(ray.direction); sun; sun = lamps.sun_behind(ray.direction, sun))
      add(*sun, std::numeric_limits<double>::max());
  return false;
}

void PathTracer::add_emission(Path& path, const Color& emission, const Intersection& met) const {
  if (emission == black) return;
  double weight = 1;
  if (path.has_rival) {
    if (const auto emitter = lamps_.emitters.find(met.hit)) {
      const double rival = lamps_.emitters.probability(*emitter, path.from) *
                           lamps_.emitters[*emitter].density(path.from, path.walk.ray.direction, met.surface.position,
                                                             met.surface.normal);
      weight = balance(path.density, rival);
    }
  }
  path.sum += path.throughput * emission * weight;
}

// False if the path ends.
bool PathTracer::scatter(Path& path, const ScatteringPoint& at) {
  const auto numbers = path.stream.group(scattering_group(path.vertices));
  if (at.bsdf.has_spread()) path.sum += path.throughput * direct_light(path, at);
  ++path.vertices;
  const auto sample = at.bsdf.sample(numbers[0], numbers[1], numbers[2]);
  if (!sample || sample->weight == black) return false;
  path.throughput *= sample->weight;
  if (sample->is_straight) {
    go_straight(path, at);
    return true;
  }
  ++(!sample->is_perfect ? counts_.scattered : sample->wi.z < 0 ? counts_.refracted : counts_.reflected);
  // From the first surface on that has a non-specular lobe, what casts no shadow is ignored.
  path.walk.meets_casting_only |= !sample->is_perfect;
  path.has_rival = !sample->is_perfect;
  path.density = sample->density;
  path.from = at.surface.position;
  walker_.leave(path.walk, at.surface, at.is_boundary, normalize(at.frame.vector(sample->wi)));
  return path.depth++ < first_roulette || survives(path, numbers[3]);
}

// When it must not be scattered any more, a path still crosses what does not bend it, as shadow rays do.
bool PathTracer::passes(Path& path, const ScatteringPoint& at) {
  if (at.bsdf.passed_straight() == black) return false;
  path.throughput *= at.bsdf.passed_straight();
  go_straight(path, at);
  return true;
}

// As if nothing had happened: the density of the last scattering event still applies.
void PathTracer::go_straight(Path& path, const ScatteringPoint& at) {
  ++counts_.refracted;
  walker_.leave(path.walk, at.surface, at.is_boundary, path.walk.ray.direction);
}

Color PathTracer::direct_light(const Path& path, const ScatteringPoint& at) {
  const auto numbers = path.stream.group(lamp_group(path.vertices));
  const bool asks_all = path.depth == 0 && lamps_.sizeless.size() <= DirectLighting::few_lamps;
  Color sum = direct_.from_emitters(at, numbers);
  sum += asks_all ? direct_.from_lamps(at) : direct_.from_one_lamp(at, numbers[3]);
  if (!lamps_.sized.is_empty()) sum += direct_.from_sized_lamps(at, path.stream.group(sized_lamp_group(path.vertices)));
  return sum;
}

bool PathTracer::survives(Path& path, double number) {
  const double probability = std::min(0.95, max_component(path.throughput));
  if (number >= probability) return false;
  path.throughput = path.throughput * (1 / probability);
  return true;
}

} // namespace rt
