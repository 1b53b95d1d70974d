#pragma once

#include "renderer/scene/builder.hpp"

#include <utility>
#include <vector>

/// Scenes in a few words.
namespace rt::tests {

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

/// A scene that grows by what is asked of it. There is no ambient light, and every ray is followed.
class SceneBuilder : public scene::Builder {
public:
  using Operation = scene::Combination::Operation;

  SceneBuilder() { scene.ambient = black, scene.min_weight = 0; }

  template <class S>
  Thing shape(S s) {
    return Thing(Builder::shape(std::move(s)));
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
  Thing group(std::vector<scene::Object> members) { return Thing(Builder::group(std::move(members))); }
  Thing combination(Operation operation, std::vector<scene::Object> operands) {
    return Thing(Builder::combination(operation, std::move(operands)));
  }
  Thing unite(std::vector<scene::Object> o) { return combination(Operation::unite, std::move(o)); }
  Thing intersect(std::vector<scene::Object> o) { return combination(Operation::intersect, std::move(o)); }
  Thing subtract(std::vector<scene::Object> o) { return combination(Operation::subtract, std::move(o)); }

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
    p.layout = scene::Checker{a, b}, p.placement = placement;
    return pattern(p);
  }

  scene::TransformId transform(scene::Placement placement) { return Builder::transform(std::move(placement)).value(); }
  scene::TransformId scaled(const Vec3& factors) { return transform({factors, {}, {}, {}}); }
  scene::TransformId rotated(const Vec3& degrees) { return transform({{1, 1, 1}, degrees, {}, {}}); }
  scene::TransformId chained(std::vector<scene::Step> chain) {
    return transform({{1, 1, 1}, {}, {}, std::move(chain)});
  }

  void point_light(const Vec3& at, const Color& color = white) {
    scene::PointLight l;
    l.at = at, l.color = color;
    add(l);
  }
  void sun(const Vec3& direction, const Color& color = white) {
    scene::SunLight l;
    l.direction = direction, l.color = color;
    add(l);
  }
};

/// A scene as if it were read from a file, each thing on a line of its own.
class WrittenScene : public scene::Builder {
public:
  WrittenScene() {
    scene.size = {64, 48};
    scene.files = {"test.rtl"};
    scene.camera = {.at = {1.3, 2.1, 7.2}, .look_at = {0.1, 0.2, 0}, .fov = 45};
  }

  template <class S>
  scene::Object object(S s, scene::MaterialId material = scene::no_material, const Vec3& at = {}) {
    return {.at = at, .shape = shape(std::move(s)), .material = material, .origin = {0, ++line_}};
  }
  template <class S>
  scene::Object& place(S s, scene::MaterialId material = scene::no_material, const Vec3& at = {}) {
    return add(object(std::move(s), material, at));
  }
  void light(const scene::LightSource& source) { add(source).origin = {0, ++line_}; }

private:
  std::uint32_t line_ = 0;
};

} // namespace rt::tests
