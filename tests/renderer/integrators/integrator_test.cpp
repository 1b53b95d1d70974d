#include "renderer/integrators/integrator.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

TEST_CASE("integrator: every kind sees a lit plane, and counts its rays") {
  SceneBuilder k;
  k.scene.ambient = grey(0.1);
  k.add(k.plane({0, 0, 1}, 0));
  k.sun({0, 0, -1});
  const CompiledScene compiled(k.scene, 1);
  for (const IntegratorKind kind : {IntegratorKind::whitted, IntegratorKind::whitted_povray}) {
    const auto integrator = make_integrator(kind, compiled);
    const auto worker = integrator->make_worker();
    const std::array rays{Ray{{0, 0, 3}, {0, 0, -1}}, Ray{{0, 0, 3}, {0, 0, 1}}};
    std::array<Color, 2> seen;
    worker->radiance(rays, {}, {}, seen);
    CHECK(seen[0].g == Approx(0.9)); // ambient 0.1, diffuse 0.8
    CHECK(seen[1] == black);
    CHECK(worker->counts().camera == 2);
    CHECK(worker->counts().shadow == 1);
    CHECK(worker->counts().total() == 3);
  }
}

TEST_CASE("integrator: under POV-Ray's rules what is nearer than 1e-4 is not hit") {
  SceneBuilder k;
  k.scene.ambient = white;
  k.add(k.plane({0, 0, 1}, 0));
  const CompiledScene compiled(k.scene, 1);
  const auto seen_from = [&](IntegratorKind kind, double height) {
    const Ray ray{{0, 0, height}, {0, 0, -1}};
    Color seen;
    make_integrator(kind, compiled)->make_worker()->radiance({&ray, 1}, {}, {}, {&seen, 1});
    return seen;
  };
  CHECK(seen_from(IntegratorKind::whitted, 0.9e-4) == white);
  CHECK(seen_from(IntegratorKind::whitted_povray, 0.9e-4) == black);
  CHECK(seen_from(IntegratorKind::whitted_povray, 1.1e-4) == white);
}
