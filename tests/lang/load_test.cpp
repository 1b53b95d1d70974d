#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

TEST_CASE("load: a sphere on a plane, with a colour") {
  const Loaded loaded = load("sphere { at: [0, 1, 0], radius: 2, material: red }\nplane { y: 0 }\n");
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  const scene::Scene& scene = *loaded.scene;
  REQUIRE(scene.objects.size() == 2);
  CHECK(scene.objects[0].at == Vec3{0, 1, 0});
  CHECK(scene.objects[0].origin == scene::Origin{0, 1});
  CHECK(scene.objects[1].origin == scene::Origin{0, 2});
  REQUIRE(scene.objects[0].shape.kind == scene::kind_of<scene::Sphere>);
  CHECK(scene.shapes.get<scene::Sphere>(scene.objects[0].shape).radius == 2);
  CHECK(scene.shapes.get<scene::Plane>(scene.objects[1].shape).y == 0);
  REQUIRE(scene.materials.size() == 1);
  CHECK(std::get<Color>(scene.materials[0].color) == Color{1, 0, 0});
}

TEST_CASE("load: mistakes of all stages are reported in the order of their places") {
  const Loaded loaded = load("sphere { radius: \"a\" }\nsphere { raduis: 2 }\nsphere { radius: -1 }\nsphere { radius: "
                             "}\nsphere { radius: r }");
  CHECK(errors(loaded) == std::vector<std::string>{"E0301", "E0204", "E0302", "E0101", "E0201"});
  CHECK_FALSE(loaded.scene);
}

TEST_CASE("load: the design's own example loads without a word") {
  const Loaded loaded = load(R"(
// Still life: glass over a checkered floor
background: #9cc4e8
ambient: 0.1

camera { at: [4, 3, 7], look_at: [0, 1, 0], fov: 40 }
sun    { direction: [-1, -2, -1], color: #fff2d8 }

wood  = material { color: peru, specular: 0.3, shininess: 30 }
glass = material { refract: 0.9, ior: 1.5, reflect: 0.1 }
green = glass { color: #8fd3a0 }

plane { y: 0, material: checker { a: white, b: #333 } }

fn wave(a) = 0.3 * sin(3 * a)

def table(width = 2, height = 1) {
  box { size: [width, 0.1, width], at: [0, height, 0] }
  for x in [-1, 1] {
    for z in [-1, 1] {
      cylinder { radius: 0.05, from: [x, 0, z] * width / 2.2, to: [x * width / 2.2, height, z * width / 2.2] }
    }
  }
}

table { width: 3, material: wood }.rotate(y: 30)

for i, a in 0..<360 by 30 {
  sphere {
    at: [2 * cos(a), 1.3 + wave(a), 2 * sin(a)]
    radius: 0.2
    material: if i % 2 == 0 { green } else { wood }
  }
}

(box { size: 0.8, at: [0, 1.5, 0] } - sphere { radius: 0.5, at: [0, 1.5, 0] }) { material: glass }
)");
  INFO(report(loaded));
  CHECK(loaded.diagnostics.empty());
  REQUIRE(loaded.scene);
  CHECK(loaded.scene->objects.size() == 1 + 1 + 12 + 1);
  CHECK(count_primitives(*loaded.scene) == 1 + 5 + 12 + 2);
}
