#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/whitted.hpp"
#include "renderer/scene/scene.hpp"

#include <utility>

/// Scenes in a few words, for tests.
namespace rt::kit {

/// An object of the shape, at a place, with a material.
class Thing {
public:
  explicit Thing(scene::ShapeRef shape) { object_.shape = shape; }
  Thing at(const Vec3& p) && { return object_.at = p, std::move(*this); }
  Thing transformed(scene::TransformId transform) && { return object_.transform = transform, std::move(*this); }
  Thing with(scene::MaterialId material) && { return object_.material = material, std::move(*this); }
  Thing without_shadow() && { return object_.casts_shadow = false, std::move(*this); }
  Thing invisible() && { return object_.is_visible = false, std::move(*this); }
  operator scene::Object() const { return object_; }

private:
  scene::Object object_;
};

/// A scene that grows by what is asked of it.
struct Kit {
  scene::Scene scene;

  Kit() { scene.ambient = black; }

  template <class S>
  Thing shape(S s) {
    return Thing(scene.shapes.add(std::move(s)));
  }
  Thing sphere(double radius = 1) { return shape(scene::Sphere{radius}); }
  Thing box(const Vec3& from, const Vec3& to) {
    scene::Box b;
    b.from = from, b.to = to;
    return shape(b);
  }
  Thing plane(const Vec3& normal, double offset) {
    scene::Plane p;
    p.normal = normal, p.offset = offset;
    return shape(p);
  }
  Thing group(std::vector<scene::Object> members) { return shape(scene::Group{std::move(members)}); }
  Thing combination(scene::Combination::Operation operation, std::vector<scene::Object> operands) {
    return shape(scene::Combination{operation, std::move(operands)});
  }
  Thing unite(std::vector<scene::Object> o) { return combination(scene::Combination::Operation::unite, std::move(o)); }
  Thing intersect(std::vector<scene::Object> o) {
    return combination(scene::Combination::Operation::intersect, std::move(o));
  }
  Thing subtract(std::vector<scene::Object> o) {
    return combination(scene::Combination::Operation::subtract, std::move(o));
  }

  void add(const scene::Object& object) { scene.objects.push_back(object); }

  scene::MaterialId material(const scene::Material& m) {
    scene.materials.push_back(m);
    return scene::MaterialId{static_cast<std::uint32_t>(scene.materials.size() - 1)};
  }
  /// Gives off its colour, and nothing else happens to light there.
  scene::MaterialId glow(const Color& color) {
    scene::Material m;
    m.color = color, m.emission = grey(1), m.ambient = m.diffuse = grey(0);
    return material(m);
  }
  scene::MaterialId glow(double value) { return glow(grey(value)); }
  /// Lets all light by, with this ior.
  scene::MaterialId clear(double ior, double refract = 1) {
    scene::Material m;
    m.refract = refract, m.ior = ior, m.ambient = m.diffuse = grey(0);
    return material(m);
  }
  scene::PatternId checker(const Color& a, const Color& b, const scene::Placement& placement = {}) {
    scene::Pattern p;
    p.a = a, p.b = b, p.placement = placement;
    scene.patterns.push_back(p);
    return scene::PatternId{static_cast<std::uint32_t>(scene.patterns.size() - 1)};
  }
  scene::TransformId transform(scene::Placement placement) {
    scene.transforms.push_back(std::move(placement));
    return scene::TransformId{static_cast<std::uint32_t>(scene.transforms.size() - 1)};
  }
  scene::TransformId scaled(const Vec3& factors) {
    scene::Placement p;
    p.scale = factors;
    return transform(p);
  }
  scene::TransformId rotated(const Vec3& degrees) {
    scene::Placement p;
    p.rotate = degrees;
    return transform(p);
  }
  scene::TransformId chained(std::vector<scene::Step> chain) {
    scene::Placement p;
    p.chain = std::move(chain);
    return transform(p);
  }

  template <class L>
  void light(const L& source) {
    scene::Light light;
    light.source = source;
    scene.lights.push_back(light);
  }
  void point_light(const Vec3& at, const Color& color = white) {
    scene::PointLight l;
    l.at = at, l.color = color;
    light(l);
  }
  void sun(const Vec3& direction, const Color& color = white) {
    scene::SunLight l;
    l.direction = direction, l.color = color;
    light(l);
  }
};

/// A scene that was compiled, to be asked by rays. Directions need not be unit vectors.
class Asked {
public:
  explicit Asked(const scene::Scene& scene) : compiled(scene, 1) {}
  explicit Asked(const Kit& k) : Asked(k.scene) {}

  RayHit nearest(const Vec3& origin, const Vec3& direction) {
    return compiled.nearest({origin, direction}, {}, scratch_);
  }
  Surface surface(const Vec3& origin, const Vec3& direction) {
    return compiled.surface({origin, direction}, nearest(origin, direction));
  }
  Color radiance(const Vec3& origin, const Vec3& direction) {
    NoRecorder recorder;
    return Whitted<>(compiled, recorder).radiance({origin, normalize(direction)}, compiled.around(origin));
  }
  Color transmittance(const Vec3& from, const Vec3& to) {
    return compiled.transmittance({from, to - from}, {0, 1}, scratch_);
  }
  /// The values of t of all hits.
  std::vector<double> all(const Vec3& origin, const Vec3& direction) {
    std::vector<double> ts;
    for (const RayHit& hit : compiled.all_hits({origin, direction}, {})) ts.push_back(hit.t);
    return ts;
  }

  CompiledScene compiled;

private:
  TraceScratch scratch_;
};

} // namespace rt::kit
