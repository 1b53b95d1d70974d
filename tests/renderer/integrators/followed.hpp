#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/math/random.hpp"
#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

/// Rays that are followed through clear things, and what the laws of optics say of them.
namespace rt::tests {

template <class T>
void shuffle(std::vector<T>& values, SplitMix64& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.bits() % i]);
}

/// Follows the ray that is never mirrored, and counts what any ray meets in one place.
struct Way : NoRecorder {
  Ray last{};
  Color weight = white;
  int bends = 0, surfaces = 0;
  std::size_t most_touching = 0;

  void begin_ray(RayKind kind, const Ray& ray, int, const Color& w) {
    open.push_back(kind == RayKind::camera || (kind == RayKind::refracted && open.back()));
    if (!open.back()) return;
    last = ray, weight = w;
    bends += kind == RayKind::refracted;
  }
  void end_ray(const Color&) { open.pop_back(); }
  void touching(const std::vector<MetSurface>& met) { most_touching = std::max(most_touching, met.size()); }
  void surface(const RayHit&, const Surface&, const MaterialValues&, const Vec3&) { surfaces += open.back(); }

private:
  std::vector<bool> open; // rays, by whether they are on the way
};

inline Way follow(const scene::Builder& k, const Ray& ray) {
  const CompiledScene compiled(k.scene, 1);
  Way way;
  Whitted<OwnRules, Way>(compiled, way).radiance(ray, compiled.around(ray.origin));
  return way;
}

inline Color seen(const scene::Builder& k, const Ray& ray) {
  return Asked(k).radiance(ray.origin, ray.direction);
}

/// Of unpolarised light, by Fresnel's sines and tangents (Born and Wolf, Principles of Optics, 1.5.2).
inline double reflectance(double ior, double ior_behind, double sine) {
  const double i = std::asin(sine), t = std::asin(sine * ior / ior_behind);
  if (i < 1e-6) return std::pow((ior_behind - ior) / (ior_behind + ior), 2);
  const double s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
  return (s * s + p * p) / 2;
}

inline scene::Material clear_material(double ior, bool fresnel) {
  scene::Material m;
  m.ambient = m.diffuse = grey(0), m.refract = 1.0, m.ior = ior;
  if (fresnel) m.fresnel = true, m.reflect = white;
  return m;
}

struct Plate {
  double ior, thickness;
};

/// One upon the other, the first on top at y = 0, each reaching `overlap` into the one below it.
inline std::vector<scene::Object> pile(SceneBuilder& k, const std::vector<Plate>& plates, bool fresnel,
                                       double overlap = 0) {
  std::vector<scene::Object> things;
  double y = 0;
  for (const Plate& p : plates) {
    const bool is_last = &p == &plates.back();
    const auto material = k.material(clear_material(p.ior, fresnel));
    things.push_back(k.box({-40, y - p.thickness - (is_last ? 0 : overlap), -40}, {40, y, 40}).with(material));
    y -= p.thickness;
  }
  return things;
}

} // namespace rt::tests
