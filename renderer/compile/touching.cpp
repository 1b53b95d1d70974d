#include "renderer/compile/touching.hpp"

#include "renderer/compile/leaves/leaves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace rt {
namespace {

double distance_apart(const Surface& from, const Surface& to) {
  return std::abs(dot(to.position - from.position, to.normal));
}

// By the refined points: whether the ray crosses `a` before `b`, however their distances along the ray were rounded.
bool is_before(const Surface& a, const Surface& b, const Vec3& direction) {
  const Vec3& n = a.normal;
  return dot(a.position - b.position, n) * dot(direction, n) < 0;
}

bool is_met_from_front(const MetSurface& m, const Ray& ray) {
  return dot(m.surface.normal, ray.direction) < 0;
}

// Keeps only those that touch the one that is crossed first.
void keep_first_place(const Ray& ray, std::vector<MetSurface>& surfaces) {
  const MetSurface* first = &surfaces.front();
  for (const MetSurface& m : surfaces)
    if (!touch(m.surface, first->surface) && is_before(m.surface, first->surface, ray.direction)) first = &m;
  const Surface place = first->surface;
  std::erase_if(surfaces, [&](const MetSurface& m) { return !touch(m.surface, place); });
}

void start_beyond_all(std::vector<MetSurface>& surfaces) {
  for (MetSurface& m : surfaces)
    for (const MetSurface& other : surfaces)
      m.surface.error = std::max(m.surface.error, distance_apart(m.surface, other.surface) + other.error);
}

// Moves the surfaces that count to the front and returns their number.
std::size_t select(const Ray& ray, std::vector<MetSurface>& surfaces) {
  std::stable_sort(surfaces.begin(), surfaces.end(), [&](const MetSurface& a, const MetSurface& b) {
    return std::tuple(!a.is_opaque, a.surface.order) < std::tuple(!b.is_opaque, b.surface.order);
  });
  if (surfaces.front().is_opaque) return 1;
  std::vector<MetSurface> kept, rest;
  for (auto begin = surfaces.begin(); begin != surfaces.end();) {
    const std::uint64_t order = begin->surface.order;
    const auto end = std::find_if(begin, surfaces.end(), [&](const MetSurface& m) { return m.surface.order != order; });
    // Of an odd number of crossings of one solid the first represents all.
    const bool counts = (end - begin) % 2 == 1;
    if (counts) kept.push_back(*begin);
    rest.insert(rest.end(), begin + counts, end);
    begin = end;
  }
  std::stable_partition(kept.begin(), kept.end(), [&](const MetSurface& m) { return is_met_from_front(m, ray); });
  surfaces = kept;
  surfaces.insert(surfaces.end(), rest.begin(), rest.end());
  return kept.size();
}

} // namespace

double TouchingSurfaces::end() const {
  double last = 0;
  for (const MetSurface& m : surfaces) last = std::max(last, m.hit.t);
  return last;
}

void find_touching(const CompiledScene& scene, const Ray& ray, const Interval& range, const RayHit& nearest,
                   TraceScratch& scratch, TouchingSurfaces& found, Touching which) {
  found.surfaces.clear();
  for (const RayHit& hit : scene.hits_near(ray, range, nearest, scratch)) {
    if (which == Touching::casting && !scene.casts_shadow(hit)) continue;
    MetSurface& met = found.surfaces.emplace_back(MetSurface{hit, scene.surface(ray, hit)});
    MaterialValues values;
    met.error = met.surface.error;
    met.is_opaque = scene.values(met.surface, values).refract == 0;
  }
  keep_first_place(ray, found.surfaces);
  start_beyond_all(found.surfaces);
  found.count = select(ray, found.surfaces);
}

std::optional<MetSurface> first_surface(const CompiledScene& scene, const Ray& ray, const Interval& range,
                                        TraceScratch& scratch) {
  TouchingSurfaces found;
  for (Interval rest = range;;) {
    const RayHit hit = scene.nearest(ray, rest, scratch);
    if (!hit) return std::nullopt;
    if (!hit.is_contested) return MetSurface{hit, scene.surface(ray, hit)};
    find_touching(scene, ray, rest, hit, scratch, found);
    if (found.count > 0) return found.surfaces.front();
    rest.lower = found.end();
  }
}

void sort_inside_out(const CompiledScene& scene, const Ray& ray, std::span<MetSurface> entered) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Surface& at = entered.front().surface;
  const Vec3& normal = at.normal;
  const Vec3 into = dot(normal, ray.direction) < 0 ? -normal : normal;
  const Vec3 u = normalize(cross(normal, std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(normal, u), start = at.position + into * at.error;

  struct Entered {
    MetSurface met;
    std::vector<double> reach{}; ///< how far it goes on from the place, in each direction
  };
  std::vector<Entered> solids;
  for (const MetSurface& m : entered) solids.push_back({m});
  for (const Vec3& direction : {into, u, -u, v, -v}) {
    const Ray probe{start, direction};
    const std::vector<RayHit> hits = scene.all_hits(probe, {});
    for (Entered& solid : solids) {
      const auto end =
          std::ranges::find_if(hits, [&](const RayHit& hit) { return scene.order(hit) == solid.met.surface.order; });
      solid.reach.push_back(end == hits.end() ? infinity : end->t);
    }
  }
  const auto is_inside = [](const Entered& a, const Entered& b) {
    constexpr double least = 1 - 1e-9; // of a difference between reaches that rounding does not make
    bool is_shorter = false, is_longer = false;
    for (std::size_t i = 0; i < a.reach.size(); ++i) {
      is_shorter |= a.reach[i] < b.reach[i] * least;
      is_longer |= b.reach[i] < a.reach[i] * least;
    }
    if (is_shorter != is_longer) return is_shorter;
    return std::tuple(a.met.surface.ior, a.met.surface.order) > std::tuple(b.met.surface.ior, b.met.surface.order);
  };
  // Insertion sort: near equality is not transitive.
  for (std::size_t i = 1; i < solids.size(); ++i)
    for (std::size_t k = i; k > 0 && is_inside(solids[k], solids[k - 1]); --k) std::swap(solids[k], solids[k - 1]);
  std::ranges::transform(solids, entered.begin(), &Entered::met);
}

} // namespace rt
