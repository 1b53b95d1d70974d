#pragma once

#include "renderer/integrators/batching.hpp"
#include "renderer/integrators/rules.hpp"

#include <cmath>
#include <type_traits>

namespace rt {

/// Whitted's recursive ray tracing (An Improved Illumination Model for Shaded Display, 1980), in the form defined in
/// the language reference under "Shading": what happens to one ray. `BatchTracer` drives it.
template <class RulesUsed, class RecorderUsed>
class WhittedModel {
public:
  using Rules = RulesUsed;
  using Recorder = RecorderUsed;
  static constexpr bool is_recorded = !std::is_same_v<Recorder, NoRecorder>;

  WhittedModel(const CompiledScene& scene, Recorder& recorder) : scene_(scene), recorder_(recorder) {}

  void begin(const PathState& path, int depth) { recorder_.begin_ray(path.kind, path.ray, depth, path.weight); }
  void end(const PathState& path) { recorder_.end_ray(path.sum); }

  /// The path is not followed any further.
  void cut_off(PathState& path) {
    stop_following(path);
    recorder_.too_deep();
  }
  /// So much of what the path brings ends here: it is absorbed, escapes, or would be too deep.
  static void stop_following(PathState& path, const Color& share = white) {
    path.tree->pruning.end(path.weight * path.passed * share);
  }
  /// Whether a branch is left out for its weight. Then the light that it may bring is estimated.
  bool prune(const Scattering& s, const Color& share, int depth) {
    if (depth >= scene_.max_depth()) return false; // what would be too deep is black, and costs nothing
    PathState& path = *s.at->path;
    Pruning& pruning = path.tree->pruning;
    const double weight = max_component(path.weight * path.passed * share);
    if (!pruning.leave_out_branch(weight)) return false;
    const Color estimate = pruning.estimate();
    path.sum += path.passed * share * estimate;
    recorder_.too_weak(weight, estimate);
    return true;
  }

  void escape(PathState& path) {
    const Color seen = scene_.environment(path.ray.direction);
    recorder_.miss(seen);
    gather(path, seen);
    stop_following(path);
  }

  /// Light arrives along the path.
  void gather(PathState& path, const Color& light) const {
    const Color passed = path.passed * light;
    path.sum += passed;
    path.tree->pruning.add_light(path.weight * passed);
  }

  /// The path has hit `at.surface`, where the material has these values.
  [[gnu::always_inline]] void arrive(Interaction& at, const RayHit& hit, const MaterialValues& values) {
    at.bsdf = WhittedBsdf(values);
    const Vec3& direction = at.path->ray.direction;
    at.normal = Rules::turned_normal(at.surface, direction);
    at.cosine = -dot(at.normal, direction);
    if (at.cosine < 0) [[unlikely]]
      at.cosine = -dot(bent_normal(at), direction);
    recorder_.contact(at.path->tree->contacts, at.path->contact);
    recorder_.surface(hit, at.surface, values, at.normal);
  }

  /// The path has reached a place where surfaces touch.
  void touch(const Contacts& contacts) { recorder_.touching(contacts.met()); }

  /// The path has travelled this far through its medium.
  void absorb(PathState& path, double length) {
    const Medium* medium = path.tree->media.top(path.inside);
    if (!medium || scene_.absorption(*medium).is_clear()) return;
    const Color left = scene_.absorption(*medium).left_after(length);
    stop_following(path, white - left);
    recorder_.absorption(left, length);
    path.passed *= left;
  }

  void add_own_light(Interaction& at) {
    const MaterialValues& v = at.bsdf.values();
    const Color ambient = at.bsdf.body() * v.ambient * scene_.ambient(), emission = at.bsdf.body() * v.emission;
    recorder_.own_light(ambient, emission);
    at.light = ambient + emission;
  }

  /// Adds the light's contribution, once its visibility is known.
  void add_direct_light(Interaction& at, const DirectLight& direct, std::uint32_t index) {
    LightRecord record;
    record.light = index;
    record.sample = direct.sample;
    record.cos_light = direct.cos_light;
    record.filter = direct.transmittance;
    record.left_out = direct.left_out;
    if (direct.is_facing() && direct.transmittance != black)
      record.reflected = reflected(at, direct, scene_.lights()[index].shadows);
    recorder_.light(record, at.surface);
    at.light += record.reflected.sum();
  }

  /// What is reflected of a light that faces the surface, after shadows.
  [[gnu::always_inline]] static ReflectedLight reflected(const Interaction& at, const DirectLight& direct,
                                                         bool has_highlight) {
    return at.bsdf.evaluate(direct.sample.color * direct.transmittance, at.path->ray.direction, at.normal,
                            direct.sample.to_light, direct.cos_light, has_highlight);
  }

  static bool is_scattering(const Interaction& at) { return at.bsdf.is_mirror() || at.bsdf.is_transparent(); }

  /// For a scattering interaction.
  [[gnu::always_inline]] Scattering scatter(const Interaction& at) {
    const MaterialValues& v = at.bsdf.values();
    if (at.path->contact.is_inside() && !v.thin) [[unlikely]]
      return scatter_in_contact(at);
    const MediumStacks& media = at.path->tree->media;
    const MediumStacks::List inside = at.path->inside;
    const Medium medium = medium_of(at);
    const double ior = media.top_ior(inside);
    const MediumTransition transition =
        v.thin ? MediumTransition{MediumTransition::Kind::through_sheet, ior, ior} : media.transition(inside, medium);
    const bool has_void = touches_void(transition, inside);
    const double eta = v.thin || !at.bsdf.is_transparent() ? 1 : Rules::eta(transition.eta(), has_void);
    const double fresnel_eta =
        at.bsdf.is_mirror() && v.fresnel ? Rules::eta(media.fresnel_eta(inside, medium), has_void) : 1;
    return scattering(at, medium, transition, eta, fresnel_eta);
  }

  /// The reflected ray, if ρ is not black.
  Ray mirror(const Scattering& s) {
    const Interaction& at = *s.at;
    if (s.terms.is_total) recorder_.total_reflection(s.transition, at.cosine);
    return Rules::leave(at.surface, reflect(at.path->ray.direction, specular_normal(at)));
  }

  /// Whether light is transmitted: if so, the transmitted ray is the next to be traced.
  bool transmits(const Scattering& s) {
    const Interaction& at = *s.at;
    if (!s.terms.is_transparent) return false; // the surface's values may be overwritten by now
    recorder_.refraction(s.terms.tau, s.transition, at.cosine, s.terms.is_bent ? s.terms.cos_behind : at.cosine);
    return s.terms.tau != black;
  }

  [[gnu::always_inline]] static Ray refracted(const Scattering& s) {
    const Interaction& at = *s.at;
    return Rules::leave(at.surface,
                        refract(at.path->ray.direction, specular_normal(at), s.eta, at.cosine, s.terms.cos_behind));
  }

  /// The path continues unbent, inside `behind`. It gets no deeper, but there must be one level to spare: so POV-Ray
  /// counts. False: there is none.
  bool transmit_straight(const Scattering& s, MediumStacks::List behind, int depth) {
    PathState& path = *s.at->path;
    if (depth >= scene_.max_depth()) {
      stop_following(path, s.terms.tau);
      recorder_.too_deep();
      return false;
    }
    path.passed *= s.terms.tau;
    path.ray = Rules::leave(s.at->surface, path.ray.direction);
    path.inside = behind;
    return true;
  }

private:
  static Medium medium_of(const Interaction& at) {
    return {at.surface.order, at.surface.ior, at.surface.medium_material_id};
  }

  [[gnu::noinline]] Scattering scatter_in_contact(const Interaction& at) {
    const MediumTransition transition = at.path->tree->contacts.transition(at.path->contact, at.path->tree->media);
    return scattering(at, medium_of(at), transition, transition.eta(), 1 / transition.eta());
  }

  [[gnu::always_inline]] Scattering scattering(const Interaction& at, const Medium& medium,
                                               const MediumTransition& transition, double eta, double fresnel_eta) {
    const Scattering s{
        &at, medium, transition, eta, at.bsdf.specular(at.cosine, eta, fresnel_eta), at.bsdf.values().thin};
    const Color left = white - s.terms.rho - s.terms.tau;
    stop_following(*at.path, {std::max(left.r, 0.0), std::max(left.g, 0.0), std::max(left.b, 0.0)});
    if (at.bsdf.is_mirror() && !s.terms.is_total)
      recorder_.reflection(s.terms.rho, s.terms.reflectance, at.cosine, fresnel_eta);
    return s;
  }

  // The normal for what is mirrored and refracted.
  static Vec3 specular_normal(const Interaction& at) {
    if (dot(at.normal, at.path->ray.direction) <= 0) [[likely]]
      return at.normal;
    return bent_normal(at);
  }
  // A normal that faces away from the viewer reflects nothing: it is bent until the reflected ray just leaves the
  // surface (A. Keller et al., The Iray Light Transport Simulation and Rendering System, 2017, A.3).
  [[gnu::noinline]] static Vec3 bent_normal(const Interaction& at) {
    const Vec3 &n = at.surface.normal, &direction = at.path->ray.direction;
    const Vec3 mirrored = reflect(direction, at.normal);
    const Vec3 viewed = dot(n, direction) > 0 ? -n : n;
    const Vec3 along = mirrored + viewed * std::max(0.0, 0x1p-20 - dot(mirrored, viewed));
    const Vec3 bent = normalize(along) - direction;
    const double size = length(bent);
    return size > 0 ? bent / size : viewed;
  }

  static bool touches_void(const MediumTransition& transition, MediumStacks::List inside) {
    return inside.size == 0 || (transition.kind == MediumTransition::Kind::leaving && inside.size == 1);
  }

  const CompiledScene& scene_;
  Recorder& recorder_;
};

/// The integrator: `radiance` is the radiance along a ray.
template <class Rules = OwnRules, class Recorder = NoRecorder>
using Whitted = BatchTracer<WhittedModel<Rules, Recorder>>;

std::unique_ptr<const Integrator> make_whitted(const CompiledScene& scene);
std::unique_ptr<const Integrator> make_whitted_exported(const CompiledScene& scene);
std::unique_ptr<const Integrator> make_whitted_povray(const CompiledScene& scene);

} // namespace rt
