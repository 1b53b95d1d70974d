#pragma once

#include "renderer/integrators/integrator.hpp"
#include "renderer/integrators/interaction.hpp"
#include "renderer/math/static_vector.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <vector>

namespace rt {

/// Traces rays through a `Model` of light, which defines what happens to a ray at a surface. Each thread has its
/// own.
///
/// Coherent rays are traced in batches: all find their hits, then all trace their shadow rays, then all are reflected,
/// and so on, as long as they stay together. A ray's result does not depend on the rest of its batch.
template <class Model>
class BatchTracer {
public:
  using Recorder = typename Model::Recorder;

  /// All must outlive the tracer. Once `stop` is set, every ray ends at once, and the results are meaningless.
  BatchTracer(const CompiledScene& scene, Recorder& recorder, const std::atomic<bool>* stop = nullptr)
      : scene_(scene), model_(scene, recorder), stop_(stop) {}

  /// The radiance along `ray` (unit direction), which starts inside these solids:
  /// `CompiledScene::around`.
  Color radiance(const Ray& ray, const std::vector<Medium>& inside) {
    StaticVector<PathState, 1> path;
    start(path, ray, inside);
    trace<1>(path, 0);
    return path[0].sum;
  }

  /// The same for coherent rays, `camera_batch_size` at most: faster, with the same results. Recorders see one ray
  /// after the other.
  void radiance(std::span<const Ray> rays, const std::vector<Medium>& inside, std::span<Color> results) {
    if (Model::is_recorded || rays.size() < least_batch) {
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = radiance(rays[i], inside);
    } else {
      StaticVector<PathState, camera_batch_size> paths;
      for (const Ray& ray : rays) start(paths, ray, inside);
      trace<camera_batch_size>(paths, 0);
      for (std::size_t i = 0; i < rays.size(); ++i) results[i] = paths[i].sum;
    }
  }

  const RayCounts& counts() const { return counts_; }

private:
  using Rules = typename Model::Rules;

  // Smaller sets are traced ray by ray, and so are deeper rays: each level of a batch takes stack space.
  static constexpr std::size_t least_batch = 4;
  static constexpr int deepest_batch = 8;
  // Rays that cross a surface unbent get no deeper; if nothing else stops one, this many crossings do.
  static constexpr int max_crossings = 1 << 20;
  // What a light gives to a ray of this weight is hardly ever so little: that is not worked out twice.
  static constexpr double least_strong = 1.0 / 512;

  // Rays that leave a batch's surfaces in the same way, and the path each comes from.
  template <std::size_t Size>
  struct RayBatch {
    StaticVector<PathState, Size> paths;
    std::array<const Scattering*, Size> from;
  };

  template <std::size_t Size>
  void start(StaticVector<PathState, Size>& paths, const Ray& ray, const std::vector<Medium>& inside) {
    ++counts_.camera;
    RayTree& tree = trees_[paths.size()];
    tree.media.release(0);
    tree.pruning = Pruning(Rules::min_weight(scene_));
    paths.add([&] { return PathState{RayKind::camera, ray, tree.media.make(inside), &tree}; });
  }

  // Accumulates the light along the paths, which are all at the same depth.
  template <std::size_t Size>
  void trace(std::span<PathState> paths, int depth) {
    for (PathState& path : paths) {
      model_.begin(path, depth);
      path.owned_from = path.tree->media.mark();
    }
    if (depth > scene_.max_depth())
      for (PathState& path : paths) model_.cut_off(path);
    else
      follow<Size>(paths, depth);
    for (PathState& path : paths) {
      path.tree->media.release(path.owned_from);
      model_.end(path);
    }
  }

  template <std::size_t Size>
  void follow(std::span<PathState> paths, int depth) {
    std::array<PathState*, Size> going; // all at first, then those that cross surfaces unbent
    std::size_t count = paths.size();
    for (std::size_t i = 0; i < count; ++i) going[i] = &paths[i];
    for (int crossings = 0; count > 0 && crossings < max_crossings && !is_stopped(); ++crossings) {
      StaticVector<Interaction, Size> interactions;
      intersect(std::span(going).first(count), interactions);
      const bool is_together = stays_together(interactions);
      shade(interactions, is_together);
      count = continue_batch(interactions, is_together, depth, going);
    }
  }

  bool is_stopped() const { return stop_ && stop_->load(std::memory_order_relaxed); }

  // Finds the paths' hits; those that miss end.
  template <std::size_t Size>
  void intersect(std::span<PathState* const> paths, StaticVector<Interaction, Size>& interactions) {
    StaticVector<RayHit, Size> hits;
    if (Size > 1 && paths.size() >= least_batch && !are_in_contact(paths)) {
      StaticVector<Ray, Size> rays;
      for (const PathState* path : paths) rays.add([&] { return path->ray; }), hits.add([] { return RayHit{}; });
      scene_.nearest(rays, Rules::hit_range(), hits, scratch_[0]);
    } else {
      for (const PathState* path : paths)
        hits.add([&] {
          return is_in_contact(path) ? RayHit{} : scene_.nearest(path->ray, Rules::hit_range(), scratch_[0]);
        });
    }
    for (std::size_t i = 0; i < paths.size(); ++i) {
      PathState& path = *paths[i];
      if (Rules::joins_touching && (hits[i].is_contested || is_in_contact(&path))) [[unlikely]] {
        meet_touching(path, hits[i], interactions);
      } else if (hits[i]) {
        absorb(path, hits[i].t);
        arrive(
            path, hits[i], [&] { return scene_.surface(path.ray, hits[i]); }, interactions);
      } else {
        absorb(path, hits[i].t);
        model_.escape(path);
      }
    }
  }

  // The absorption of the medium along the path; a miss is infinitely far away.
  void absorb(PathState& path, double length) {
    if (scene_.absorbs()) [[unlikely]]
      model_.absorb(path, length);
  }

  // Few scenes have touching surfaces: until the first is hit, paths are not tested for them.
  bool are_in_contact(std::span<PathState* const> paths) const {
    return has_contacts_ && std::ranges::any_of(paths, [this](const PathState* path) { return is_in_contact(path); });
  }
  bool is_in_contact(const PathState* path) const { return has_contacts_ && path->contact.is_inside(); }

  template <std::size_t Size, class MakeSurface>
  void arrive(PathState& path, const RayHit& hit, MakeSurface&& surface,
              StaticVector<Interaction, Size>& interactions) {
    MaterialValues& values = values_[interactions.size()];
    Interaction& at = interactions.add([&] { return Interaction{&path, hit.t, surface()}; });
    model_.arrive(at, hit, scene_.values(at.surface, values));
  }

  // The next of the touching surfaces that the path is among; or what it hits where a hit is contested.
  template <std::size_t Size>
  [[gnu::noinline]] void meet_touching(PathState& path, RayHit hit, StaticVector<Interaction, Size>& interactions) {
    Contacts& contacts = path.tree->contacts;
    const bool has_come = !is_in_contact(&path);
    for (Interval rest = Rules::hit_range(); !is_in_contact(&path);) {
      if (!hit.is_contested) absorb(path, hit.t);
      if (!hit) return model_.escape(path);
      if (!hit.is_contested)
        return arrive(
            path, hit, [&] { return scene_.surface(path.ray, hit); }, interactions);
      has_contacts_ = true;
      path.contact = contacts.intersect(scene_, path.ray, rest, hit, path.inside, path.tree->media, path.contacts_from,
                                        scratch_[0]);
      if (is_in_contact(&path)) {
        model_.touch(contacts);
      } else {
        rest.lower = contacts.end();
        hit = scene_.nearest(path.ray, rest, scratch_[0]);
      }
    }
    const ContactSurface met = contacts.surface(path.contact);
    if (has_come) absorb(path, met.hit.t);
    if (path.contact.count == 1) path.contact = {};
    arrive(
        path, met.hit, [&] { return met.surface; }, interactions);
  }

  // Whether the rays of a batch are still coherent where they hit surfaces. Only speed depends on it.
  template <std::size_t Size>
  static bool stays_together(const StaticVector<Interaction, Size>& interactions) {
    if (interactions.size() < least_batch) return false;
    double least = interactions[0].t, most = least;
    for (const Interaction& at : interactions) least = std::min(least, at.t), most = std::max(most, at.t);
    return most - least < least * 0.05;
  }

  // Emission, and direct light.
  template <std::size_t Size>
  void shade(StaticVector<Interaction, Size>& interactions, bool is_together) {
    for (Interaction& at : interactions) model_.add_own_light(at);
    for (std::uint32_t index = 0; index < scene_.lights().size(); ++index) {
      const Light& light = scene_.lights()[index];
      StaticVector<DirectLight, Size> direct;
      for (const Interaction& at : interactions) {
        DirectLight& d = direct.add([&] { return DirectLight{sample_light(light, at.surface.position)}; });
        d.cos_light = dot(at.normal, d.sample.to_light);
        if (light.shadows && at.path->kind != RayKind::camera) leave_out_weak(at, d);
      }
      if (light.shadows) cast_shadows(interactions, direct, is_together);
      for (std::size_t i = 0; i < interactions.size(); ++i) model_.add_direct_light(interactions[i], direct[i], index);
    }
    for (const Interaction& at : interactions) model_.gather(*at.path, at.light);
  }

  // No shadow ray is traced for a light all of whose contribution may be neglected.
  static void leave_out_weak(const Interaction& at, DirectLight& direct) {
    const PathState& path = *at.path;
    if (!path.tree->pruning.is_on() || max_component(path.weight * path.passed) > least_strong) return;
    if (direct.is_facing()) leave_out_if_weak(at, direct);
  }
  [[gnu::noinline]] static void leave_out_if_weak(const Interaction& at, DirectLight& direct) {
    const PathState& path = *at.path;
    const double most = max_component(path.weight * path.passed * Model::reflected(at, direct, true).sum());
    if (path.tree->pruning.leave_out(most)) direct.left_out = most;
  }

  template <std::size_t Size>
  void cast_shadows(const StaticVector<Interaction, Size>& interactions, StaticVector<DirectLight, Size>& direct,
                    bool is_together) {
    StaticVector<ShadowRay, Size> rays;
    for (std::size_t i = 0; i < interactions.size(); ++i) {
      DirectLight& d = direct[i];
      if (d.is_facing())
        rays.add([&] {
          return ShadowRay{Rules::leave(interactions[i].surface, d.sample.to_light),
                           Rules::shadow_range(d.sample.distance), &d.transmittance};
        });
    }
    counts_.shadow += rays.size();
    if (Size > 1 && is_together && rays.size() >= least_batch)
      Rules::transmit(scene_, rays, scratch_);
    else
      for (const ShadowRay& ray : rays) Rules::transmit(scene_, std::span(&ray, 1), scratch_);
    for (std::size_t i = 0; i < interactions.size(); ++i) {
      const PathState& path = *interactions[i].path;
      if (is_in_contact(&path)) [[unlikely]]
        direct[i].transmittance *= path.tree->contacts.transmittance(scene_, path.contact, direct[i].sample.to_light);
    }
  }

  // Adds the light along reflected rays, and along refracted ones that are bent. `going` becomes the paths that
  // continue unbent behind the surfaces; returns their number.
  template <std::size_t Size>
  std::size_t continue_batch(const StaticVector<Interaction, Size>& interactions, bool is_together, int depth,
                             std::array<PathState*, Size>& going) {
    StaticVector<Scattering, Size> scatterings;
    for (const Interaction& at : interactions)
      if (Model::is_scattering(at))
        scatterings.add([&] { return model_.scatter(at); });
      else
        Model::stop_following(*at.path);
    if (scatterings.size() == 0) return 0;

    RayBatch<Size> mirrored;
    for (const Scattering& s : scatterings)
      if (s.terms.rho != black && (s.terms.is_total || !model_.prune(s, s.terms.rho, depth))) mirror(s, mirrored);
    trace_batch(mirrored, is_together, depth + 1);
    for (std::size_t i = 0; i < mirrored.paths.size(); ++i) {
      const Scattering& s = *mirrored.from[i];
      s.at->path->sum += s.at->path->passed * s.terms.rho * mirrored.paths[i].sum;
    }

    RayBatch<Size> refracted;
    std::size_t count = 0;
    for (const Scattering& s : scatterings)
      if (model_.transmits(s) && !model_.prune(s, s.terms.tau, depth) && transmit(s, depth, refracted))
        going[count++] = s.at->path;
    trace_batch(refracted, is_together, depth + 1);
    for (std::size_t i = 0; i < refracted.paths.size(); ++i) {
      const Scattering& s = *refracted.from[i];
      s.at->path->sum += s.at->path->passed * s.terms.tau * refracted.paths[i].sum;
    }
    return count;
  }

  template <std::size_t Size>
  void trace_batch(RayBatch<Size>& batch, bool is_together, int depth) {
    const std::span<PathState> paths(batch.paths);
    if (Size > 1 && is_together && paths.size() >= least_batch && depth <= deepest_batch && run_alike(paths))
      return trace<Size>(paths, depth);
    for (PathState& path : paths) trace<1>(std::span(&path, 1), depth);
  }

  static bool run_alike(std::span<const PathState> paths) {
    for (const PathState& path : paths.subspan(1))
      if (dot(path.ray.direction, paths[0].ray.direction) < 0.9) return false;
    return true;
  }

  template <std::size_t Size>
  void mirror(const Scattering& s, RayBatch<Size>& batch) {
    ++counts_.reflected;
    add(
        batch, s.terms.is_total ? RayKind::total_reflection : RayKind::reflected, s, [&] { return model_.mirror(s); },
        s.terms.rho, s.at->path->inside);
  }

  // True if the ray continues unbent: then the path is the one behind the surface.
  template <std::size_t Size>
  bool transmit(const Scattering& s, int depth, RayBatch<Size>& batch) {
    ++counts_.refracted;
    PathState& path = *s.at->path;
    if (is_in_contact(&path)) [[unlikely]]
      return transmit_in_contact(s, depth, batch);
    const MediumStacks::List behind =
        s.is_thin ? path.inside : path.tree->media.after(path.inside, s.medium, path.owned_from);
    if (!s.terms.is_bent) return model_.transmit_straight(s, behind, depth);
    add(
        batch, RayKind::refracted, s, [&] { return Model::refracted(s); }, s.terms.tau, behind);
    return false;
  }

  template <std::size_t Size>
  [[gnu::noinline]] bool transmit_in_contact(const Scattering& s, int depth, RayBatch<Size>& batch) {
    PathState& path = *s.at->path;
    const MediumStacks::List behind = path.tree->contacts.behind(path.contact);
    if (s.terms.is_bent) {
      add(
          batch, RayKind::refracted, s, [&] { return Model::refracted(s); }, s.terms.tau, behind);
      return false;
    }
    if (!model_.transmit_straight(s, behind, depth)) return false;
    const Contacts::Position met = path.contact;
    path.contact = path.tree->contacts.after(met, path.ray.direction);
    if (!is_in_contact(&path)) path.inside = path.tree->contacts.leave(met, behind, path.tree->media, path.owned_from);
    return true;
  }

  // The ray is constructed in place, which is cheaper than copying it.
  template <std::size_t Size, class MakeRay>
  void add(RayBatch<Size>& batch, RayKind kind, const Scattering& s, MakeRay&& make_ray, const Color& weight,
           MediumStacks::List inside) {
    const PathState& from = *s.at->path;
    batch.from[batch.paths.size()] = &s;
    PathState& path = batch.paths.add([&] { return PathState{kind, make_ray(), inside, from.tree}; });
    path.contacts_from = from.contacts_from;
    if (is_in_contact(&from)) [[unlikely]] {
      path.contact = from.tree->contacts.after(from.contact, path.ray.direction);
      path.contacts_from = from.contact.begin + from.contact.count;
    }
    path.weight = from.weight * from.passed * weight;
  }

  const CompiledScene& scene_;
  Model model_;
  const std::atomic<bool>* stop_;
  std::array<RayTree, camera_batch_size> trees_; // by index of the camera ray in its batch
  std::array<TraceScratch, camera_batch_size> scratch_;
  std::array<MaterialValues, camera_batch_size> values_; // where they are not constant; valid until rays branch
  RayCounts counts_;
  bool has_contacts_ = false; // touching surfaces were hit
};

} // namespace rt
