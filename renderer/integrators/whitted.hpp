#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/recorder.hpp"
#include "renderer/math/static_vector.hpp"
#include "renderer/shading/media.hpp"
#include "renderer/shading/optics.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace rt {

inline constexpr double unlimited = std::numeric_limits<double>::max();

/// How far from its origin a ray may find something. Ours: anywhere, because origins are moved off their surface by the
/// bound of their own rounding.
struct OwnTolerances {
  static constexpr bool moves_origins = true;
  static constexpr double nearest = 0;          ///< least distance of a camera, mirrored or refracted ray's hit
  static constexpr double farthest = unlimited; ///< and the greatest
  /// The part of a shadow ray, from the surface to the light, in which something blocks it. It ends a rounding before
  /// the light, so that a light lying in a surface shines.
  static double shadow_begin() { return 0; }
  static double shadow_end(double distance) { return std::min(distance * (1 - 0x1p-40), unlimited); }
};

/// POV-Ray's, for explaining where its pictures differ from ours: in lengths of the scene. With them, ratios of indices
/// of refraction are rounded as POV-Ray does, too.
struct PovrayTolerances {
  static constexpr bool moves_origins = false;
  static constexpr double nearest = 1e-4, farthest = 1e7;
  static double shadow_begin() { return 1e-3; }
  static double shadow_end(double distance) { return std::min(distance - 1e-3, unlimited); }
};

/// Whitted's recursive ray tracing (An Improved Illumination Model for Shaded Display, 1980), in the form that the
/// language's reference gives under "Shading". One object traces for one thread.
///
/// Rays that run close together are traced in groups: all find what they hit, then all look for the lights, then all
/// are mirrored, and so on, as long as they stay together. What one of them sees does not depend on its company.
template <class Tolerances = OwnTolerances, class Recorder = NoRecorder>
class Whitted {
public:
  /// All must outlive the integrator. Once `stop` is set, every ray ends at once, and results mean nothing any more.
  Whitted(const CompiledScene& scene, Recorder& recorder, const std::atomic<bool>* stop = nullptr)
      : scene_(scene), recorder_(recorder), stop_(stop) {}

  /// The light that comes in along `ray` (unit direction), which starts inside of these solids:
  /// `CompiledScene::around`.
  Color radiance(const Ray& ray, const std::vector<Medium>& inside) {
    StaticVector<Path, 1> path;
    start(path, ray, inside);
    trace<1>(path, 0);
    return path[0].sum;
  }

  /// The same for rays that run close together, `bvh::packet_size` at most: sooner, with the same results. Recorders
  /// hear of it as of one ray after the other.
  void radiance(std::span<const Ray> rays, const std::vector<Medium>& inside, std::span<Color> results) {
    if constexpr (is_recorded) {
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = radiance(rays[i], inside);
    } else {
      StaticVector<Path, group_size> paths;
      for (const Ray& ray : rays) start(paths, ray, inside);
      trace<group_size>(paths, 0);
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = paths[i].sum;
    }
  }

  const RayCounts& counts() const { return counts_; }

  /// The ray that looks for what blocks a light, and the part of it in which something does: what a recorder needs to
  /// ask the scene which object it is (`CompiledScene::all_hits`).
  static Ray shadow_ray(const Surface& surface, const LightSample& sample) { return leaving(surface, sample.to_light); }
  static Interval shadow_range(const LightSample& sample) {
    return {Tolerances::shadow_begin(), Tolerances::shadow_end(sample.distance)};
  }

private:
  using List = MediumStacks::List;

  static constexpr bool is_recorded = !std::is_same_v<Recorder, NoRecorder>;
  static constexpr std::size_t group_size = bvh::packet_size;
  // Fewer rays go one by one, and so do those that are deeper: a group's levels take room on the stack.
  static constexpr std::size_t least_group = 4;
  static constexpr int deepest_group = 8;
  // Rays that pass a surface unbent are no deeper than before; where nothing but they are left this many end one.
  static constexpr int max_crossings = 1 << 20;

  // A ray on its way, and what it has gathered.
  struct Path {
    RayKind kind;
    Ray ray;
    List inside; // where the ray is
    MediumStacks* media;
    std::uint32_t owned_from = 0; // lists from there on are this ray's own
    Color sum = black,
          passed = white; // what was gathered before surfaces that were crossed unbent, and what they let by
    Color weight = white; // for the recorder
  };

  // One ray has met one surface.
  struct Meeting {
    Path* path;
    double t;
    Surface surface;
    const MaterialValues* values = nullptr;
    Vec3 normal{};     // to the viewer
    double cosine = 0; // between the ray and the normal, positive
    Color body{};      // the share of the colour that is not transparent
    Color light{};     // that leaves the surface towards the viewer by itself
  };

  // How a light reaches a surface.
  struct Arrival {
    LightSample sample;
    double cos_light = 0;
    Color filter = white;
    bool is_facing() const { return cos_light > 0 && sample.color != black; }
  };

  // Where the ray goes from there.
  struct Ways {
    const Meeting* meeting;
    Medium medium;
    Color rho = black, tau = black;
    MediumTransition transition{};
    double eta = 1, cos_behind = 1;
    bool is_total = false, is_transparent = false, is_bent = false;
  };

  // Those that go the same way from a group's surfaces, and where each left the group.
  template <std::size_t Size>
  struct Branch {
    StaticVector<Path, Size> paths;
    std::array<const Ways*, Size> from;
  };

  template <std::size_t Size>
  void start(StaticVector<Path, Size>& paths, const Ray& ray, const std::vector<Medium>& inside) {
    MediumStacks& media = stacks_[paths.size()];
    media.release(0);
    paths.add([&] { return Path{RayKind::camera, ray, media.make(inside), &media}; });
  }

  // Gathers what comes in along the paths, which are of one depth.
  template <std::size_t Size>
  void trace(std::span<Path> paths, int depth) {
    for (Path& path : paths) {
      recorder_.begin_ray(path.kind, path.ray, depth, path.weight);
      path.owned_from = path.media->mark();
    }
    if (depth > scene_.max_depth())
      for (std::size_t i = 0; i < paths.size(); ++i) recorder_.too_deep();
    else
      follow<Size>(paths, depth);
    for (Path& path : paths) {
      path.media->release(path.owned_from);
      recorder_.end_ray(path.sum);
    }
  }

  template <std::size_t Size>
  void follow(std::span<Path> paths, int depth) {
    std::array<Path*, Size> going; // at first all, then those that cross surfaces unbent
    std::size_t count = paths.size();
    for (std::size_t i = 0; i < count; ++i) going[i] = &paths[i];
    for (int crossings = 0; count > 0 && crossings < max_crossings && !is_stopped(); ++crossings) {
      StaticVector<Meeting, Size> meetings;
      meet(std::span(going).first(count), meetings);
      const bool is_together = stays_together(meetings);
      shade(meetings, is_together);
      count = go_on(meetings, is_together, depth, going);
    }
  }

  bool is_stopped() const { return stop_ && stop_->load(std::memory_order_relaxed); }

  // Finds what the paths meet; those that meet nothing see the background.
  template <std::size_t Size>
  void meet(std::span<Path* const> paths, StaticVector<Meeting, Size>& meetings) {
    constexpr Interval range{Tolerances::nearest, Tolerances::farthest};
    StaticVector<RayHit, Size> hits;
    if (Size > 1 && paths.size() >= least_group) {
      StaticVector<Ray, Size> rays;
      for (const Path* path : paths) rays.add([&] { return path->ray; }), hits.add([] { return RayHit{}; });
      scene_.nearest(rays, range, hits, scratch_[0]);
    } else {
      for (const Path* path : paths) hits.add([&] { return scene_.nearest(path->ray, range, scratch_[0]); });
    }
    for (std::size_t i = 0; i < paths.size(); ++i) {
      Path& path = *paths[i];
      if (hits[i]) {
        meet(path, hits[i], meetings);
      } else {
        recorder_.miss(scene_.background());
        path.sum += path.passed * scene_.background();
      }
    }
  }

  template <std::size_t Size>
  void meet(Path& path, const RayHit& hit, StaticVector<Meeting, Size>& meetings) {
    MaterialValues& values = values_[meetings.size()];
    Meeting& m = meetings.add([&] { return Meeting{&path, hit.t, scene_.surface(path.ray, hit)}; });
    m.values = &scene_.values(m.surface, values);
    const double approach = dot(m.surface.shading_normal, path.ray.direction);
    m.normal = approach > 0 ? -m.surface.shading_normal : m.surface.shading_normal;
    m.cosine = std::abs(approach);
    recorder_.surface(hit, m.surface, *m.values, m.normal);
  }

  // Whether the rays of a group are still close to one another where they meet surfaces. It decides about speed alone.
  template <std::size_t Size>
  static bool stays_together(const StaticVector<Meeting, Size>& meetings) {
    if (meetings.size() < least_group) return false;
    double least = meetings[0].t, most = least;
    for (const Meeting& m : meetings) least = std::min(least, m.t), most = std::max(most, m.t);
    return most - least < least * 0.05;
  }

  // The surfaces' own light, and what the lights give.
  template <std::size_t Size>
  void shade(StaticVector<Meeting, Size>& meetings, bool is_together) {
    for (Meeting& m : meetings) {
      const MaterialValues& v = *m.values;
      m.body = v.color * (1 - v.refract);
      const Color ambient = m.body * v.ambient * scene_.ambient(), emission = m.body * v.emission;
      recorder_.own_light(ambient, emission);
      m.light = ambient + emission;
    }
    for (std::uint32_t index = 0; index < scene_.lights().size(); ++index) {
      const Light& light = scene_.lights()[index];
      StaticVector<Arrival, Size> arrivals;
      for (const Meeting& m : meetings) approach(light, m, arrivals);
      if (light.shadows) cast_shadows(meetings, arrivals, is_together);
      for (std::size_t i = 0; i < meetings.size(); ++i)
        meetings[i].light += reflected_light(meetings[i], arrivals[i], index);
    }
    for (const Meeting& m : meetings) m.path->sum += m.path->passed * m.light;
  }

  // Before shadows.
  template <std::size_t Size>
  static void approach(const Light& light, const Meeting& m, StaticVector<Arrival, Size>& arrivals) {
    Arrival& arrival = arrivals.add([&] { return Arrival{sample_light(light, m.surface.point)}; });
    arrival.cos_light = dot(m.normal, arrival.sample.to_light);
  }

  template <std::size_t Size>
  void cast_shadows(const StaticVector<Meeting, Size>& meetings, StaticVector<Arrival, Size>& arrivals,
                    bool is_together) {
    StaticVector<ShadowRay, Size> rays;
    for (std::size_t i = 0; i < meetings.size(); ++i) {
      Arrival& a = arrivals[i];
      if (a.is_facing())
        rays.add([&] {
          return ShadowRay{shadow_ray(meetings[i].surface, a.sample), shadow_range(a.sample), &a.filter};
        });
    }
    counts_.shadow += rays.size();
    if (Size > 1 && Tolerances::moves_origins && is_together && rays.size() >= least_group)
      scene_.transmittance(rays, scratch_);
    else
      for (const ShadowRay& ray : rays) *ray.transmittance = transmittance(ray.ray, ray.range);
  }

  Color transmittance(const Ray& ray, const Interval& range) {
    if constexpr (Tolerances::moves_origins) return scene_.transmittance(ray, range, scratch_[0]);
    return scene_.transmittance_by_steps(ray, range.upper, range.lower);
  }

  Color reflected_light(const Meeting& m, const Arrival& arrival, std::uint32_t index) {
    const Light& light = scene_.lights()[index];
    const MaterialValues& v = *m.values;
    LightRecord record;
    record.light = index;
    record.sample = arrival.sample;
    record.cos_light = arrival.cos_light;
    record.filter = arrival.filter;
    if (!arrival.is_facing() || arrival.filter == black) {
      recorder_.light(record, m.surface);
      return black;
    }
    const Vec3& l = record.sample.to_light;
    const Vec3& direction = m.path->ray.direction;
    const Color arriving = record.sample.color * record.filter;
    record.diffuse = arriving * m.body * v.diffuse * record.cos_light;
    if (light.shadows && v.specular > 0) {
      record.cos_highlight = v.highlight == scene::Highlight::blinn ? dot(m.normal, normalize(l - direction))
                                                                    : dot(reflect(direction, m.normal), l);
      if (record.cos_highlight > 0) {
        record.tint = metallic_tint(v.metallic, record.cos_light, v.color);
        record.highlight = arriving * record.tint * (v.specular * to_power(record.cos_highlight, v.shininess));
      }
    }
    recorder_.light(record, m.surface);
    return record.diffuse + record.highlight;
  }

  // Adds what comes in by mirrored rays, and by refracted ones where they are bent. `going` becomes the paths that go
  // on unbent, behind the surfaces; the result is their number.
  template <std::size_t Size>
  std::size_t go_on(const StaticVector<Meeting, Size>& meetings, bool is_together, int depth,
                    std::array<Path*, Size>& going) {
    StaticVector<Ways, Size> ways;
    for (const Meeting& m : meetings)
      if (m.values->reflect != black || m.values->refract > 0) find_ways(m, ways);
    if (ways.size() == 0) return 0;

    Branch<Size> mirrored;
    for (const Ways& w : ways)
      if (w.rho != black) mirror(w, mirrored);
    trace_branch(mirrored, is_together, depth + 1);
    for (std::size_t i = 0; i < mirrored.paths.size(); ++i) {
      const Ways& w = *mirrored.from[i];
      w.meeting->path->sum += w.meeting->path->passed * w.rho * mirrored.paths[i].sum;
    }

    Branch<Size> refracted;
    std::size_t count = 0;
    for (const Ways& w : ways)
      if (w.is_transparent && pass(w, depth, refracted)) going[count++] = w.meeting->path;
    trace_branch(refracted, is_together, depth + 1);
    for (std::size_t i = 0; i < refracted.paths.size(); ++i) {
      const Ways& w = *refracted.from[i];
      w.meeting->path->sum += w.meeting->path->passed * w.tau * refracted.paths[i].sum;
    }
    return count;
  }

  template <std::size_t Size>
  void trace_branch(Branch<Size>& branch, bool is_together, int depth) {
    const std::span<Path> paths(branch.paths);
    if (Size > 1 && is_together && paths.size() >= least_group && depth <= deepest_group && run_alike(paths))
      return trace<Size>(paths, depth);
    for (Path& path : paths) trace<1>(std::span(&path, 1), depth);
  }

  static bool run_alike(std::span<const Path> paths) {
    for (const Path& path : paths.subspan(1))
      if (dot(path.ray.direction, paths[0].ray.direction) < 0.9) return false;
    return true;
  }

  template <std::size_t Size>
  void find_ways(const Meeting& m, StaticVector<Ways, Size>& ways) {
    const MaterialValues& v = *m.values;
    Ways& w = ways.add([&] { return Ways{&m, {m.surface.order, m.surface.ior}}; });
    w.is_transparent = v.refract > 0;
    if (w.is_transparent) {
      w.transition = m.path->media->transition(m.path->inside, w.medium);
      w.eta = ratio(w.transition, m.path->inside);
      w.is_bent = std::abs(w.eta - 1) >= 1e-10;
      const double cos2_behind = w.is_bent ? cos2_refracted(m.cosine, w.eta) : 1;
      if (cos2_behind < 0) {
        // Total internal reflection takes the place of both branches.
        w.rho = white;
        w.is_total = true;
        w.is_transparent = false;
        return;
      }
      w.cos_behind = std::sqrt(cos2_behind);
    }
    if (v.reflect != black) w.rho = mirror_weight(m, w.medium);
    if (w.is_transparent) {
      w.tau = v.color * v.refract;
      if (v.fresnel) w.tau *= {std::min(1.0, 1 - w.rho.r), std::min(1.0, 1 - w.rho.g), std::min(1.0, 1 - w.rho.b)};
    }
  }

  template <std::size_t Size>
  void mirror(const Ways& w, Branch<Size>& branch) {
    const Meeting& m = *w.meeting;
    ++counts_.reflected;
    if (w.is_total) recorder_.total_reflection(w.transition, m.cosine);
    add(branch, w.is_total ? RayKind::total_reflection : RayKind::reflected, w,
        reflect(m.path->ray.direction, m.normal), w.rho, m.path->inside);
  }

  // True if the ray goes on unbent: then the path is the one behind the surface.
  template <std::size_t Size>
  bool pass(const Ways& w, int depth, Branch<Size>& branch) {
    const Meeting& m = *w.meeting;
    recorder_.refraction(w.tau, w.transition, m.cosine, w.is_bent ? w.cos_behind : m.cosine);
    if (w.tau == black) return false;
    ++counts_.refracted;
    Path& path = *m.path;
    const List behind = path.media->after(path.inside, w.medium, path.owned_from);
    if (w.is_bent) {
      add(branch, RayKind::refracted, w, refract(path.ray.direction, m.normal, w.eta, m.cosine, w.cos_behind), w.tau,
          behind);
      return false;
    }
    // What goes on unbent is no deeper than before, but there must be one step to spare: so does POV-Ray count.
    if (depth >= scene_.max_depth()) {
      recorder_.too_deep();
      return false;
    }
    path.passed *= w.tau;
    path.ray = leaving(m.surface, path.ray.direction);
    path.inside = behind;
    return true;
  }

  template <std::size_t Size>
  static void add(Branch<Size>& branch, RayKind kind, const Ways& w, const Vec3& direction, const Color& weight,
                  List inside) {
    const Path& from = *w.meeting->path;
    branch.from[branch.paths.size()] = &w;
    Path& path = branch.paths.add([&] {
      return Path{kind, leaving(w.meeting->surface, direction), inside, from.media};
    });
    if constexpr (is_recorded) path.weight = from.weight * from.passed * weight;
  }

  // POV-Ray divides the indices of two solids in 32 bits, and only with the void's in 64.
  static double ratio(const MediumTransition& transition, List inside) {
    if constexpr (Tolerances::moves_origins) return transition.eta();
    const bool has_void = inside.size == 0 || (transition.kind == MediumTransition::Kind::leaving && inside.size == 1);
    return has_void ? transition.eta() : static_cast<float>(transition.eta());
  }

  Color mirror_weight(const Meeting& m, const Medium& medium) {
    const MaterialValues& v = *m.values;
    double eta = 1, share = 1;
    if (v.fresnel) {
      eta = m.path->media->fresnel_eta(m.path->inside, medium);
      share = fresnel_reflectance(m.cosine, eta);
    }
    const Color rho = v.reflect * metallic_tint(v.metallic, m.cosine, v.color) * share;
    recorder_.reflection(rho, share, m.cosine, eta);
    return rho;
  }

  // A ray that starts at a surface, on the side it goes to.
  static Ray leaving(const Surface& surface, const Vec3& direction) {
    if constexpr (!Tolerances::moves_origins) return {surface.point, direction};
    const double side = dot(surface.geometric_normal, direction) < 0 ? -surface.offset : surface.offset;
    return {surface.point + surface.geometric_normal * side, direction};
  }

  const CompiledScene& scene_;
  Recorder& recorder_;
  const std::atomic<bool>* stop_;
  std::array<MediumStacks, group_size> stacks_; // by the place of the camera's ray in its group
  std::array<TraceScratch, group_size> scratch_;
  std::array<MaterialValues, group_size> values_; // where they are not constant; they serve until rays branch
  RayCounts counts_;
};

} // namespace rt
