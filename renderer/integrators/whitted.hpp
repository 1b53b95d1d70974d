#pragma once

#include "renderer/integrators/interiors.hpp"
#include "renderer/integrators/optics.hpp"
#include "renderer/integrators/recorder.hpp"
#include "renderer/traceable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace rt {

inline constexpr double unlimited = std::numeric_limits<double>::max();

/// How far from its origin a ray may find something. Ours: anywhere, because origins are moved off their surface by the
/// bound of their own rounding.
struct OwnTolerances {
  static constexpr bool moves_origins = true;
  static constexpr double nearest = 0; ///< least distance of a camera, mirrored or refracted ray's hit
  static constexpr double farthest = unlimited; ///< and the greatest
  /// The part of a shadow ray, from the surface to the lamp, in which something blocks it. It ends a rounding before
  /// the lamp, so that a lamp lying in a surface shines.
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
/// language's reference gives under "Shading". One object traces one ray at a time; each thread has its own.
template <class Tolerances = OwnTolerances, class Recorder = NoRecorder>
class Whitted {
public:
  /// Both must outlive the integrator.
  Whitted(const Traceable& scene, Recorder& recorder) : scene_(scene), recorder_(recorder) {}

  /// The light that comes in along `ray` (unit direction), which starts inside of these solids: `Traceable::around`.
  Color radiance(const Ray& ray, const std::vector<Interior>& inside) {
    interiors_.release(0);
    return trace(RayKind::camera, ray, 0, white, interiors_.make(inside));
  }

  /// The same for rays that run close together, `accel::packet_size` at most: sooner, with the same results. Recorders
  /// hear of it as if one ray came after the other.
  void radiance(std::span<const Ray> rays, const std::vector<Interior>& inside, std::span<Color> results) {
    std::array<RayHit, accel::packet_size> hits;
    scene_.nearest(rays, {Tolerances::nearest, Tolerances::farthest}, hits, scratch_);
    meet_all(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      interiors_.release(0);
      results[i] = trace(RayKind::camera, rays[i], 0, white, interiors_.make(inside), &first_[i]);
    }
  }

  const RayCounts& counts() const { return counts_; }

  /// The ray that looks for what blocks a lamp, and the part of it in which something does: what a recorder needs to
  /// ask the scene which object it is (`Traceable::all_hits`).
  static Ray shadow_ray(const Surface& surface, const Incidence& incidence) {
    return leaving(surface, incidence.to_light);
  }
  static Interval shadow_range(const Incidence& incidence) {
    return {Tolerances::shadow_begin(), Tolerances::shadow_end(incidence.distance)};
  }

private:
  using List = InteriorLists::List;

  // How a lamp's light comes to a surface.
  struct Arrival {
    Incidence incidence;
    double cos_light = 0;
    Color filter = white;
    bool is_facing() const { return cos_light > 0 && incidence.color != black; }
  };

  // What a ray finds first, where that is known beforehand.
  struct First {
    RayHit hit;
    Surface surface;
    Vec3 normal;
    std::vector<Arrival> arrivals; // one for each lamp
  };

  // One ray has met one surface.
  struct Meeting {
    Surface surface;
    const Arrival* arrivals = nullptr; // where they are known beforehand
    const MaterialValues* values;
    Vec3 direction;           // of the ray
    Vec3 normal;              // to the viewer
    double cosine;            // between the two, positive
    List inside;              // where the ray is
    std::uint32_t owned_from; // lists from there on are this ray's own
    int depth;
    Color weight; // of the ray, for the recorder
  };

  // Rays that pass a surface unbent are no deeper than before; where nothing but they are left this many end one.
  static constexpr int max_crossings = 1 << 20;

  Color trace(RayKind kind, Ray ray, int depth, const Color& weight, List inside, const First* first = nullptr) {
    recorder_.begin_ray(kind, ray, depth, weight);
    const std::uint32_t mark = interiors_.mark();
    const Color result = depth > scene_.max_depth() ? too_deep() : follow(ray, depth, weight, inside, first);
    interiors_.release(mark);
    recorder_.end_ray(result);
    return result;
  }

  Color too_deep() {
    recorder_.too_deep();
    return black;
  }

  Color follow(Ray ray, int depth, const Color& ray_weight, List inside, const First* first) {
    const std::uint32_t owned_from = interiors_.mark();
    Color sum = black,
          passed = white; // what was gathered before surfaces that were crossed unbent, and what they let by
    for (int crossings = 0; crossings < max_crossings; ++crossings, first = nullptr) {
      const RayHit hit = first ? first->hit : scene_.nearest(ray, {Tolerances::nearest, Tolerances::farthest}, scratch_);
      if (!hit) {
        recorder_.miss(scene_.background());
        return sum + passed * scene_.background();
      }
      Meeting m;
      m.surface = first ? first->surface : scene_.surface(ray, hit);
      m.normal = first ? first->normal : towards_viewer(m.surface, ray);
      if (first) m.arrivals = first->arrivals.data();
      MaterialValues scratch;
      m.values = &scene_.values(m.surface, scratch);
      m.direction = ray.direction;
      m.cosine = -dot(m.normal, ray.direction);
      m.inside = inside;
      m.owned_from = owned_from;
      m.depth = depth;
      m.weight = ray_weight * passed;
      recorder_.surface(hit, m.surface, *m.values, m.normal);

      sum += passed * shade(m);
      if (!continue_ray(m, sum, passed, ray, inside)) return sum;
    }
    return sum;
  }

  // Its own light, and what the lamps give.
  Color shade(const Meeting& m) {
    const MaterialValues& v = *m.values;
    const Color body = v.color * (1 - v.refract);
    const Color ambient = body * v.ambient * scene_.ambient(), emission = body * v.emission;
    recorder_.own_light(ambient, emission);
    Color sum = ambient + emission;
    const std::vector<Lamp>& lamps = scene_.lamps();
    for (std::uint32_t i = 0; i < lamps.size(); ++i) sum += light(m, body, i);
    return sum;
  }

  Color light(const Meeting& m, const Color& body, std::uint32_t index) {
    const Lamp& lamp = scene_.lamps()[index];
    const MaterialValues& v = *m.values;
    const Arrival arrival = m.arrivals ? m.arrivals[index] : arrive(lamp, m.surface, m.normal);
    LightRecord record;
    record.lamp = index;
    record.incidence = arrival.incidence;
    record.cos_light = arrival.cos_light;
    record.filter = arrival.filter;
    if (!arrival.is_facing() || arrival.filter == black) {
      recorder_.light(record, m.surface);
      return black;
    }
    const Vec3& l = record.incidence.to_light;
    const Color arriving = record.incidence.color * record.filter;
    record.diffuse = arriving * body * v.diffuse * record.cos_light;
    if (lamp.shadows && v.specular > 0) {
      record.cos_highlight = v.highlight == scene::Highlight::blinn ? dot(m.normal, normalize(l - m.direction))
                                                                    : dot(reflect(m.direction, m.normal), l);
      if (record.cos_highlight > 0) {
        record.tint = metallic_tint(v.metallic, record.cos_light, v.color);
        record.highlight = arriving * record.tint * (v.specular * std::pow(record.cos_highlight, v.shininess));
      }
    }
    recorder_.light(record, m.surface);
    return record.diffuse + record.highlight;
  }

  // Before shadows.
  static Arrival approach(const Lamp& lamp, const Surface& surface, const Vec3& normal) {
    Arrival arrival;
    arrival.incidence = incidence(lamp, surface.point);
    arrival.cos_light = dot(normal, arrival.incidence.to_light);
    return arrival;
  }

  Arrival arrive(const Lamp& lamp, const Surface& surface, const Vec3& normal) {
    Arrival arrival = approach(lamp, surface, normal);
    if (lamp.shadows && arrival.is_facing()) {
      ++counts_.shadow;
      const Ray ray = shadow_ray(surface, arrival.incidence);
      const Interval range = shadow_range(arrival.incidence);
      if constexpr (Tolerances::moves_origins)
        arrival.filter = scene_.transmittance(ray, range, scratch_);
      else
        arrival.filter = scene_.transmittance_by_steps(ray, range.upper, range.lower);
    }
    return arrival;
  }

  static Vec3 towards_viewer(const Surface& surface, const Ray& ray) {
    return dot(surface.shading_normal, ray.direction) > 0 ? -surface.shading_normal : surface.shading_normal;
  }

  // Fills in `first_`: the surfaces at the hits, and how the lamps' light comes to them.
  void meet_all(std::span<const Ray> rays, std::span<const RayHit> hits) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      First& first = first_[i];
      first.hit = hits[i];
      first.arrivals.clear();
      if (!first.hit) continue;
      first.surface = scene_.surface(rays[i], first.hit);
      first.normal = towards_viewer(first.surface, rays[i]);
      for (const Lamp& lamp : scene_.lamps()) first.arrivals.push_back(approach(lamp, first.surface, first.normal));
    }
    for (std::size_t lamp = 0; lamp < scene_.lamps().size(); ++lamp)
      if (scene_.lamps()[lamp].shadows) cast_shadows(rays.size(), lamp);
  }

  // Of one lamp, on the first `count` of `first_`.
  void cast_shadows(std::size_t count, std::size_t lamp) {
    std::array<Arrival*, accel::packet_size> arrivals;
    std::array<Ray, accel::packet_size> rays;
    std::array<Interval, accel::packet_size> ranges;
    std::array<Color, accel::packet_size> filters;
    std::size_t n = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (!first_[i].hit || !first_[i].arrivals[lamp].is_facing()) continue;
      arrivals[n] = &first_[i].arrivals[lamp];
      rays[n] = shadow_ray(first_[i].surface, arrivals[n]->incidence);
      ranges[n] = shadow_range(arrivals[n]->incidence);
      ++n;
    }
    counts_.shadow += n;
    scene_.transmittance(std::span(rays).first(n), std::span(ranges).first(n), filters, packet_scratch_);
    for (std::size_t i = 0; i < n; ++i) arrivals[i]->filter = filters[i];
  }

  // Adds the mirrored ray, and the refracted one if it is bent. True if the ray goes on unbent: then `ray`, `inside`
  // and `passed` are those behind the surface.
  bool continue_ray(const Meeting& m, Color& sum, Color& passed, Ray& ray, List& inside) {
    const MaterialValues& v = *m.values;
    const bool is_transparent = v.refract > 0;
    const Interior interior{m.surface.order, m.surface.ior};
    Passage passage;
    double eta = 1, cos2_behind = 1;
    bool is_bent = false;
    if (is_transparent) {
      passage = interiors_.passage(m.inside, interior);
      eta = ratio(passage, m.inside);
      is_bent = std::abs(eta - 1) >= 1e-10;
      if (is_bent) cos2_behind = cos2_refracted(m.cosine, eta);
      if (cos2_behind < 0) {
        // Total internal reflection takes the place of both branches.
        ++counts_.reflected;
        recorder_.total_reflection(passage, m.cosine);
        sum += passed * branch(RayKind::total_reflection, m, reflect(m.direction, m.normal), white, m.inside);
        return false;
      }
    }
    Color rho = v.reflect;
    if (rho != black) rho = mirror_weight(m, interior);
    if (rho != black) {
      ++counts_.reflected;
      sum += passed * rho * branch(RayKind::reflected, m, reflect(m.direction, m.normal), rho, m.inside);
    }
    if (!is_transparent) return false;

    Color tau = v.color * v.refract;
    if (v.fresnel) tau *= {std::min(1.0, 1 - rho.r), std::min(1.0, 1 - rho.g), std::min(1.0, 1 - rho.b)};
    const double cos_behind = std::sqrt(cos2_behind);
    recorder_.refraction(tau, passage, m.cosine, is_bent ? cos_behind : m.cosine);
    if (tau == black) return false;
    ++counts_.refracted;
    const List behind = interiors_.after(m.inside, interior, m.owned_from);
    if (is_bent) {
      const Vec3 direction = refract(m.direction, m.normal, eta, m.cosine, cos_behind);
      sum += passed * tau * branch(RayKind::refracted, m, direction, tau, behind);
      return false;
    }
    // What goes on unbent is no deeper than before, but there must be one step to spare: so does POV-Ray count.
    if (m.depth >= scene_.max_depth()) {
      recorder_.too_deep();
      return false;
    }
    passed *= tau;
    ray = leaving(m.surface, m.direction);
    inside = behind;
    return true;
  }

  // POV-Ray divides the indices of two solids in 32 bits, and only with the void's in 64.
  static double ratio(const Passage& passage, List inside) {
    if constexpr (Tolerances::moves_origins) return passage.eta();
    const bool has_void = inside.size == 0 || (passage.kind == Passage::Kind::leaving && inside.size == 1);
    return has_void ? passage.eta() : static_cast<float>(passage.eta());
  }

  Color mirror_weight(const Meeting& m, const Interior& interior) {
    const MaterialValues& v = *m.values;
    double eta = 1, share = 1;
    if (v.fresnel) {
      eta = interiors_.fresnel_eta(m.inside, interior);
      share = fresnel_reflectance(m.cosine, eta);
    }
    const Color rho = v.reflect * metallic_tint(v.metallic, m.cosine, v.color) * share;
    recorder_.reflection(rho, share, m.cosine, eta);
    return rho;
  }

  Color branch(RayKind kind, const Meeting& m, const Vec3& direction, const Color& weight, List inside) {
    return trace(kind, leaving(m.surface, direction), m.depth + 1, m.weight * weight, inside);
  }

  // A ray that starts at a surface, on the side it goes to.
  static Ray leaving(const Surface& surface, const Vec3& direction) {
    if constexpr (!Tolerances::moves_origins) return {surface.point, direction};
    const double side = dot(surface.geometric_normal, direction) < 0 ? -surface.offset : surface.offset;
    return {surface.point + surface.geometric_normal * side, direction};
  }

  const Traceable& scene_;
  Recorder& recorder_;
  InteriorLists interiors_;
  TraceScratch scratch_;
  std::array<TraceScratch, accel::packet_size> packet_scratch_;
  std::array<First, accel::packet_size> first_; // of the packet under way
  RayCounts counts_;
};

} // namespace rt
