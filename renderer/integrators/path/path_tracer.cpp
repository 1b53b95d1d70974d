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

// Surfaces that a path may cross unbent: they are no scattering, and where nothing but they are left this many end it.
constexpr int most_crossings = 1 << 20;
// From this surface on, the first being 0, paths may end by Russian roulette.
constexpr int first_roulette = 3;

// Groups of numbers: two of the camera's, then three of each surface that is met.
constexpr std::uint32_t scattering_group(int vertex) {
  return 2 + 3 * static_cast<std::uint32_t>(vertex);
}
constexpr std::uint32_t lamp_group(int vertex) {
  return scattering_group(vertex) + 1;
}
constexpr std::uint32_t sized_lamp_group(int vertex) {
  return scattering_group(vertex) + 2;
}

} // namespace

struct PathTracer::Path {
  Ray ray;
  const SampleStream& stream;
  MediumStacks::List inside;
  Color throughput = white;
  Color sum = black;
  int vertices = 0;          // surfaces met
  int depth = 0;             // those that the path did not pass unbent
  bool is_scattered = false; // in all directions, at some surface: from there on, what casts no shadow is not there
  Vec3 from = ray.origin;    // where its direction was last changed
  // Whether that was in all directions, so that a lamp could have been asked instead, and how densely it was drawn.
  bool has_rival = false;
  double density = 0;
};

// Where the path meets a surface.
struct PathTracer::Vertex {
  Surface surface;
  WhittedBsdf bsdf;
  Vec3 normal; // the shading normal, turned to the viewer
  double cosine;
  Medium medium; // behind the surface, or before it
};

PathTracer::PathTracer(const CompiledScene& scene, const Lamps& lamps, const std::atomic<bool>* stop)
    : scene_(scene), lamps_(lamps), stop_(stop), direct_(scene, lamps, scratch_, counts_) {}

void PathTracer::radiance(std::span<const Ray> rays, std::span<const SampleStream> streams,
                          const std::vector<Medium>& inside, std::span<Color> results) {
  counts_.camera += rays.size();
  StaticVector<RayHit, camera_batch_size> hits;
  for (std::size_t i = 0; i < rays.size(); ++i) hits.add([] { return RayHit{}; });
  if (rays.size() > 1)
    scene_.nearest(rays, OwnRules::hit_range(), hits, scratch_);
  else
    hits[0] = scene_.nearest(rays[0], OwnRules::hit_range(), scratch_);
  for (std::size_t i = 0; i < rays.size(); ++i) results[i] = follow(rays[i], hits[i], streams[i], inside);
}

Color PathTracer::follow(const Ray& ray, const RayHit& first, const SampleStream& stream,
                         const std::vector<Medium>& inside) {
  media_.release(0);
  Path path{ray, stream, media_.make(inside)};
  if (meet(path, first)) go_on(path);
  return path.sum;
}

// The path starts at a white Lambert surface that is nowhere: π times what that reflects.
Color PathTracer::irradiance(const Vec3& point, const Vec3& normal, const SampleStream& stream,
                             const std::vector<Medium>& inside) {
  static constexpr MaterialValues white_matte{.diffuse = white};
  media_.release(0);
  Path path{{point, -normal}, stream, media_.make(inside)};
  Surface surface{point, normal, normal};
  surface.offset = rounding_bound(64) * (magnitude(point) + 1);
  const Vertex at{surface, WhittedBsdf(white_matte), normal, 1, {}};
  if (scatter(path, at)) go_on(path);
  return path.sum * std::numbers::pi;
}

void PathTracer::go_on(Path& path) {
  for (int crossings = 0; crossings < most_crossings && !is_stopped(); ++crossings)
    if (!meet(path, next_hit(path))) return;
}

// False: the path ends there.
bool PathTracer::meet(Path& path, const RayHit& hit) {
  if (add_lamp(path, hit ? hit.t : std::numeric_limits<double>::infinity())) return false;
  if (!hit) {
    path.sum += path.throughput * scene_.environment(path.ray.direction);
    return false;
  }
  const Surface surface = scene_.surface(path.ray, hit);
  const double approach = dot(surface.shading_normal, path.ray.direction);
  const Vertex at{surface,
                  WhittedBsdf(scene_.values(surface, values_)),
                  approach > 0 ? -surface.shading_normal : surface.shading_normal,
                  std::abs(approach),
                  {surface.order, surface.ior}};
  add_emission(path, at, hit);
  return path.depth > scene_.max_depth() ? passes(path, at) : scatter(path, at);
}

RayHit PathTracer::next_hit(const Path& path) {
  return path.is_scattered ? scene_.nearest_casting(path.ray, OwnRules::hit_range(), scratch_)
                           : scene_.nearest(path.ray, OwnRules::hit_range(), scratch_);
}

// The light of a lamp with a size before whatever the path meets at `end`: true where the path ends there. A sun is
// seen where it meets nothing, before the rest of the sky.
bool PathTracer::add_lamp(Path& path, double end) const {
  const SizedLamps& lamps = lamps_.sized;
  if (lamps.is_empty()) return false;
  const auto add = [&](std::uint32_t lamp) {
    double weight = 1;
    if (path.has_rival)
      weight = balance(path.density, lamps.probability(lamp, path.from) * lamps.density(lamp, path.from));
    path.sum += path.throughput * lamps.radiance(lamp, path.from) * weight;
  };
  if (const auto ball = lamps.ball_on(path.ray, end)) {
    add(ball->index);
    return true;
  }
  if (std::isinf(end))
    for (auto sun = lamps.sun_behind(path.ray.direction); sun; sun = lamps.sun_behind(path.ray.direction, sun))
      add(*sun);
  return false;
}

void PathTracer::add_emission(Path& path, const Vertex& at, const RayHit& hit) const {
  const Color emission = at.bsdf.body() * at.bsdf.values().emission;
  if (emission == black) return;
  double weight = 1;
  if (path.has_rival) {
    if (const auto emitter = lamps_.emitters.find(hit)) {
      const double rival = lamps_.emitters.probability(*emitter, path.from) *
                           lamps_.emitters[*emitter].density(path.from, path.ray.direction, at.surface.point,
                                                             at.surface.geometric_normal);
      weight = balance(path.density, rival);
    }
  }
  path.sum += path.throughput * emission * weight;
}

Lobes PathTracer::lobes_at(const Path& path, const Vertex& at) const {
  double eta = 1, fresnel_eta = 1;
  if (at.bsdf.is_transparent()) eta = media_.transition(path.inside, at.medium).eta();
  if (at.bsdf.is_mirror() && at.bsdf.values().fresnel) fresnel_eta = media_.fresnel_eta(path.inside, at.medium);
  return lobes(at.bsdf, at.cosine, eta, fresnel_eta);
}

// False: the path ends.
bool PathTracer::scatter(Path& path, const Vertex& at) {
  const Lobes l = lobes_at(path, at);
  const double diffuse = max_component(path.throughput * l.diffuse), mirror = max_component(path.throughput * l.mirror),
               transmission = max_component(path.throughput * l.transmission), all = diffuse + mirror + transmission;
  if (!(all > 0)) return false;
  const auto numbers = path.stream.group(scattering_group(path.vertices));
  const double picked = numbers[2] * all;
  if (diffuse > 0) path.sum += path.throughput * direct_light(path, at, l, diffuse / all);
  ++path.vertices;
  if (picked < diffuse) {
    path.throughput *= l.diffuse * (all / diffuse);
    go_anywhere(path, at, diffuse / all, numbers);
  } else if (picked < diffuse + mirror) {
    path.throughput *= l.mirror * (all / mirror);
    path.has_rival = false;
    path.from = at.surface.point;
    path.ray = OwnRules::leave(at.surface, reflect(path.ray.direction, at.normal));
    ++counts_.reflected;
  } else {
    path.throughput *= l.transmission * (all / transmission);
    go_through(path, at, l);
    if (!l.is_bent) return true; // as if nothing had happened
  }
  return path.depth++ < first_roulette || survives(path, numbers[3]);
}

// Once it must not be scattered any more, a path still crosses what does not bend it, as rays to lamps do.
bool PathTracer::passes(Path& path, const Vertex& at) {
  if (!at.bsdf.is_transparent()) return false;
  const Lobes l = lobes_at(path, at);
  if (l.is_bent || l.transmission == black) return false;
  path.throughput *= l.transmission;
  go_through(path, at, l);
  return true;
}

Color PathTracer::direct_light(const Path& path, const Vertex& at, const Lobes& l, double share) {
  const DiffusePoint point{at.surface, at.normal, l.diffuse, share, media_, path.inside};
  const auto numbers = path.stream.group(lamp_group(path.vertices));
  const bool asks_all = path.depth == 0 && lamps_.sizeless.size() <= DirectLighting::few_lamps;
  Color sum = direct_.from_emitters(point, numbers);
  sum += asks_all ? direct_.from_lamps(point) : direct_.from_one_lamp(point, numbers[3]);
  if (!lamps_.sized.is_empty())
    sum += direct_.from_sized_lamps(point, path.stream.group(sized_lamp_group(path.vertices)));
  return sum;
}

void PathTracer::go_anywhere(Path& path, const Vertex& at, double share, const std::array<double, 4>& numbers) {
  const Vec3 direction = Frame(at.normal).vector(to_cosine_hemisphere(numbers[0], numbers[1]));
  path.has_rival = path.is_scattered = true;
  path.from = at.surface.point;
  path.density = share * dot(direction, at.normal) / std::numbers::pi;
  path.ray = OwnRules::leave(at.surface, direction);
  ++counts_.scattered;
}

// A surface that does not bend the ray leaves the last scattering's chance of asking a lamp as it is.
void PathTracer::go_through(Path& path, const Vertex& at, const Lobes& l) {
  ++counts_.refracted;
  path.inside = media_.after(path.inside, at.medium, 0);
  path.has_rival = path.has_rival && !l.is_bent;
  if (l.is_bent) path.from = at.surface.point;
  const Vec3& d = path.ray.direction;
  path.ray = OwnRules::leave(at.surface, l.is_bent ? refract(d, at.normal, l.eta, at.cosine, l.cos_behind) : d);
}

bool PathTracer::survives(Path& path, double number) const {
  const double probability = std::min(0.95, max_component(path.throughput));
  if (number >= probability) return false;
  path.throughput = path.throughput * (1 / probability);
  return true;
}

} // namespace rt
