#include "renderer/render/ray_query.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

TEST_CASE("tracer: a report says where, what and of which material") {
  SceneBuilder k;
  scene::Material m;
  m.color = Color{0.5, 0.25, 1};
  m.ior = 1.5, m.fresnel = true;
  k.add(k.plane({0, 1, 0}, -5));
  k.add(k.group({k.sphere(2).at({0, 0, -10})}).with(k.material(m)));
  const RayQuery query(k.scene);
  const auto hit = query.nearest({{0, 0, 0}, {0, 0, -4}});
  REQUIRE(hit);
  CHECK(hit->t == 2);
  CHECK(hit->distance == 8);
  CHECK(hit->position == Vec3{0, 0, -8});
  CHECK(hit->normal == Vec3{0, 0, 1});
  CHECK(hit->enters);
  CHECK(hit->order == 1);
  CHECK(hit->path == std::vector<std::uint32_t>{1, 0});
  CHECK(hit->material.color == Color{0.5, 0.25, 1});
  CHECK(hit->ior == 1.5);

  const auto hits = query.all_hits({{0, 0, 0}, {0, 0, -4}});
  REQUIRE(hits.size() == 2);
  CHECK(hits[1].t == 3);
  CHECK_FALSE(hits[1].enters);
  CHECK_FALSE(query.nearest({{0, 0, 0}, {0, 0, 1}}));
}

TEST_CASE("tracer: POV-Ray's limits hide what is nearer than 1e-4") {
  SceneBuilder k;
  k.add(k.plane({0, 0, 1}, -0.5e-4).with(k.glow(1)));
  k.add(k.plane({0, 0, 1}, -5).with(k.glow(0.25)));
  const RayQuery query(k.scene);
  const Ray ray{{0, 0, 0}, {0, 0, -3}};
  CHECK(query.radiance(ray) == white);
  CHECK(query.radiance(ray, IntegratorKind::whitted_povray) == grey(0.25));
}

TEST_CASE("tracer: POV-Ray's shadows begin 1e-3 from the surface and end as far from the lamp") {
  using enum IntegratorKind;
  for (const auto& [height, is_shadow_of_povray] : {std::pair{0.8e-3, false}, {2e-3, true}, {0.9985, false}}) {
    SceneBuilder k;
    k.add(k.plane({0, 1, 0}, 0));
    scene::Disc disc;
    disc.radius = 1e-4;
    k.add(k.shape(disc).at({0, height, 0}));
    k.point_light({0, 0.9992, 0});
    const RayQuery query(k.scene);
    const Ray slanted{{0.3, 0.3, 0}, {-0.3, -0.3, 0}};
    // Ours is in shadow in every case: diffuse 0.8 is left where POV-Ray sees light.
    CHECK(query.radiance(slanted, whitted).r == 0);
    CHECK(query.radiance(slanted, whitted_povray).r == Approx(is_shadow_of_povray ? 0 : 0.8));
  }
}
