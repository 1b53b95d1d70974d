#pragma once

#include "renderer/scene/scene.hpp"

/// Scenes built by hand, for tests that must not depend on the language.
namespace rt::tests {

/// Adds things to a scene and hands out what the description refers to them by.
class SceneBuilder {
public:
  scene::Scene scene;

  SceneBuilder() {
    scene.size = {64, 48};
    scene.files = {"test.rtl"};
    scene.camera = {.at = {1.3, 2.1, 7.2}, .look_at = {0.1, 0.2, 0}, .fov = 45};
  }

  scene::MaterialId material(const scene::Material& m) {
    scene.materials.push_back(m);
    return static_cast<scene::MaterialId>(scene.materials.size() - 1);
  }
  scene::PatternId pattern(const scene::Pattern& p) {
    scene.patterns.push_back(p);
    return static_cast<scene::PatternId>(scene.patterns.size() - 1);
  }
  scene::TransformId transform(const scene::Placement& p) {
    scene.transforms.push_back(p);
    return static_cast<scene::TransformId>(scene.transforms.size() - 1);
  }
  template <class S>
  scene::Object object(S shape, scene::MaterialId material = scene::no_material, const Vec3& at = {}) {
    scene::Object o;
    o.shape = scene.shapes.add(std::move(shape));
    o.material = material;
    o.at = at;
    o.origin = {0, ++line_};
    return o;
  }
  template <class S>
  scene::Object& place(S shape, scene::MaterialId material = scene::no_material, const Vec3& at = {}) {
    scene.objects.push_back(object(std::move(shape), material, at));
    return scene.objects.back();
  }
  void light(const scene::LightSource& source) {
    scene.lights.push_back({source, {}, {}, scene::no_name, {0, ++line_}});
  }

private:
  std::uint32_t line_ = 0;
};

} // namespace rt::tests
