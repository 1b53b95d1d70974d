#include "tests/oracle/live.hpp"

#include <algorithm>

// The check must fail on a scene that is not the one POV-Ray got. Each test changes one thing by as much as a mistake
// would.
using namespace rt;
using namespace rt::tests;
namespace povray = rt::tools::povray;
using Catch::Contains;

namespace {

const std::string text = R"(size: [80, 60]
camera { at: [1.3, 1.6, 4.2], look_at: [0, 0.1, 0], fov: 42 }
light { at: [3, 4, 3] }
plane { y: -1, material: khaki }
sphere { radius: 0.9, at: [-0.7, 0, 0], material: material { color: peru, specular: 0.4 } }
box { size: 1, at: [0.9, -0.3, 0.2], rotate: [10, 30, 20], material: tomato }
sphere { radius: 0.4, at: [0.1, -0.5, 1.1], material: material { color: white, refract: 0.9, ior: 1.5 } }
triangle { points: [[-1, 0.9, -1], [1, 0.9, -1], [0, 2.1, -1]], normals: [[-0.4, 0, 1], [0.4, 0, 1], [0, 0.4, 1]], material: skyblue }
)";

std::string failing_for(const scene::Scene& changed) {
  return failing(povray::compare(changed, film_of(changed), povray::shoot(scene_of(text))));
}
template <class S>
S& shape(scene::Scene& scene, std::size_t object) {
  return scene.shapes.all<S>()[scene.objects[object].shape.index];
}

} // namespace

TEST_CASE("red: the scene itself passes") {
  CHECK(failing_for(scene_of(text)) == "");
}

TEST_CASE("red: a radius times (1 + 1e-7) fails by its distance") {
  scene::Scene scene = scene_of(text);
  shape<scene::Sphere>(scene, 1).radius *= 1 + 1e-7;
  CHECK_THAT(failing_for(scene), Contains("depth depth_p999"));
}

TEST_CASE("red: a flipped normal fails by the normals, at a corner of a triangle by the colour too") {
  scene::Scene scene = scene_of(text);
  Film film = film_of(scene);
  const auto at = std::find(film.object_id.begin(), film.object_id.end(), 3u) - film.object_id.begin();
  Xyz32& n = film.normal[static_cast<std::size_t>(at)];
  n = {-n.x, -n.y, -n.z};
  CHECK(failing(povray::compare(scene, film, povray::shoot(scene))) == "normals");
  shape<scene::Triangle>(scene, 4).normals[1] = {-0.4, 0, -1};
  CHECK_THAT(failing_for(scene), Contains("normals") && Contains("color_unexplained"));
}

TEST_CASE("red: an index of refraction of 1.501 for 1.5 fails by the colour") {
  scene::Scene scene = scene_of(text);
  for (scene::Material& m : scene.materials)
    if (m.ior == 1.5) m.ior = 1.501;
  CHECK_THAT(failing_for(scene), Contains("color_unexplained"));
}

TEST_CASE("red: one object removed fails by the ids") {
  scene::Scene scene = scene_of(text);
  scene.objects.erase(scene.objects.begin() + 3);
  CHECK_THAT(failing_for(scene), Contains("ids"));
}

TEST_CASE("red: two objects swapped fail by the ids") {
  scene::Scene scene = scene_of(text);
  std::swap(scene.objects[1], scene.objects[2]);
  CHECK_THAT(failing_for(scene), Contains("ids") && !Contains("color"));
}

TEST_CASE("red: rotations in the reversed order fail") {
  scene::Scene scene = scene_of(text);
  scene::Placement& turn = scene.transforms[static_cast<std::size_t>(scene.objects[2].transform)];
  const Vec3 r = turn.rotate, at = scene.objects[2].at;
  turn.rotate = {};
  turn.chain = {scene::MoveStep{-at}, scene::RotateStep{{0, 0, r.z}, {}}, scene::RotateStep{{0, r.y, 0}, {}},
                scene::RotateStep{{r.x, 0, 0}, {}}, scene::MoveStep{at}};
  CHECK_THAT(failing_for(scene), Contains("depth") && Contains("normals") && Contains("color_unexplained"));
}

TEST_CASE("red: an exporter that leaves out a light fails") {
  const scene::Scene scene = scene_of(text);
  scene::Scene other = scene;
  other.lights.clear();
  CHECK_THAT(failing(povray::compare(scene, film_of(scene), povray::shoot(other))),
             Contains("color_share color_unexplained"));
}
