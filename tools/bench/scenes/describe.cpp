#include "tools/bench/scenes/describe.hpp"

#include "renderer/scene/builder.hpp"

namespace rt::tools::bench {
namespace {

scene::Material material(const Finish& f) {
  scene::Material m;
  m.color = f.color;
  m.ambient = grey(f.ambient);
  m.diffuse = grey(f.diffuse);
  m.specular = f.specular;
  m.shininess = f.shininess;
  m.reflect = grey(f.reflect);
  m.refract = f.refract;
  m.ior = f.ior;
  return m;
}

} // namespace

scene::Scene describe(const Layout& layout) {
  scene::Builder build;
  scene::Scene& scene = build.scene;
  scene.size = {picture_size, picture_size};
  scene.background = layout.background;
  scene.ambient = white;
  scene.max_depth = mirror_depth;
  scene.camera = {.at = layout.eye, .look_at = layout.target, .fov = layout.fov};
  for (const BenchLight& light : layout.lights) {
    scene::PointLight source;
    source.at = light.at;
    source.color = light.color;
    build.add(source);
  }
  std::vector<scene::MaterialId> materials;
  for (const Finish& f : layout.finishes) materials.push_back(build.material(material(f)));
  const auto add = [&](auto shape, std::uint32_t finish, const Vec3& at = {}) {
    build.add({.at = at, .shape = build.shape(std::move(shape)), .material = materials[finish]});
  };
  for (const FloorShape& s : layout.floors) {
    scene::Plane floor;
    floor.y = s.height;
    add(floor, s.finish);
  }
  for (const BallShape& s : layout.balls) add(scene::Sphere{s.radius}, s.finish, s.center);
  for (const TubeShape& s : layout.tubes) {
    scene::Cylinder tube;
    tube.from = s.from;
    tube.to = s.to;
    tube.radius = s.radius;
    tube.open = true;
    add(tube, s.finish);
  }
  for (const TriangleShape& s : layout.triangles) add(scene::Triangle{s.points, {}}, s.finish);
  return std::move(scene);
}

} // namespace rt::tools::bench
