#include "lang/load.hpp"
#include "tools/explain/naming.hpp"
#include "tools/explain/probe.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <string>

using namespace rt;
using namespace rt::tools;

namespace {

scene::Scene scene_of(const std::string& text) {
  auto loaded = lang::load_text(text, "test.rtl", ".", {});
  REQUIRE(loaded.scene);
  return std::move(*loaded.scene);
}

const char* const two_balls = "camera { at: [0, 0, 10], look_at: [0, 0, 0] }\n"
                              "size: [5, 5]\n"
                              "sphere { radius: 1, name: \"near\" }\n"
                              "sphere { radius: 1, at: [0, 0, -5], material: checker { a: red, b: blue } }\n";

} // namespace

TEST_CASE("probe: hits in one place are told") {
  const scene::Scene scene = scene_of("box { from: [-1, 0, -1], to: [1, 1, 1], material: glass }\nplane { y: 0 }\n");
  const explain::NamedRay ray{{{0.3, 5, 0.2}, {0, -1, 0}}, "ray"};
  const auto hits = explain::find_hits(RayQuery(scene), ray.ray, true);
  REQUIRE(hits.size() == 3);
  CHECK(hits[0].place == 0);
  CHECK(hits[1].place == 1);
  CHECK(hits[2].place == 1);
  const std::string text = explain::probe_text(scene, ray, hits, true);
  CHECK(text.find("hit 2 of 3\n") != std::string::npos);
  CHECK(text.find("hit 3 of 3, coincides with hit 2\n") != std::string::npos);
  CHECK(explain::probe_json(scene, ray, hits)["hits"][2]["place"] == 1);
}

TEST_CASE("probe: t counts lengths of the direction, the distance is Euclidean") {
  const scene::Scene scene = scene_of(two_balls);
  const RayQuery query(scene);
  const auto hits = explain::find_hits(query, {{0, 0, 5}, {0, 0, -2}}, true);
  REQUIRE(hits.size() == 4);
  CHECK(hits[0].t == 2); // z = 1, four lengths away
  CHECK(hits[0].distance == 4);
  CHECK(hits[0].enters);
  CHECK_FALSE(hits[1].enters);
  CHECK(hits[3].distance == 11); // z = -6
  CHECK(hits[0].normal == Vec3{0, 0, 1});
}

TEST_CASE("probe: a hit names the object, its line and the pattern's colour there; a miss is an answer") {
  const scene::Scene scene = scene_of(two_balls);
  const RayQuery query(scene);
  const explain::NamedRay through{{{0.5, 0.25, 9}, {0, 0, -1}}, "ray"};
  const auto hits = explain::find_hits(query, through.ray, true);
  REQUIRE(hits.size() == 4);
  CHECK(explain::Namer(scene).whole(hits[0].path) == "`near` (test.rtl:3)");
  CHECK(explain::Namer(scene).whole(hits[2].path) == "sphere (test.rtl:4)");
  // The far ball's own z there is sqrt(1 - 0.25 - 0.0625) = 0.83: the cell (0, 0, 0), even, is a.
  const auto j = explain::probe_json(scene, through, hits);
  CHECK(j["hits"][2]["material"]["color"] == nlohmann::ordered_json({1.0, 0.0, 0.0}));
  CHECK(j["hits"][2]["objects"][0]["line"] == 4);
  const explain::NamedRay away{{{0, 0, 9}, {0, 1, 0}}, "ray"};
  CHECK(explain::probe_text(scene, away, explain::find_hits(query, away.ray, false), false).find("hits nothing") !=
        std::string::npos);
}

TEST_CASE("probe: a pixel means its centre, a point counts from the corner, and both agree") {
  const scene::Scene scene = scene_of(two_balls);
  const RayQuery query(scene);
  explain::Question pixel, point;
  pixel.pixel = {2, 2};
  point.at = {2.5, 2.5};
  const Ray a = explain::resolve(pixel, scene, query.camera()).ray,
            b = explain::resolve(point, scene, query.camera()).ray;
  CHECK(a.direction == b.direction);
  CHECK(a.direction.z == Approx(-1)); // the middle of five pixels
  CHECK(a.direction.x == Approx(0).margin(1e-15));
}

TEST_CASE("probe: what is no question about the picture is a usage error") {
  const scene::Scene scene = scene_of(two_balls);
  const RayQuery query(scene);
  explain::Question q;
  CHECK_THROWS_AS(explain::resolve(q, scene, query.camera()), explain::QuestionError);
  q.pixel = {5, 0};
  CHECK_THROWS_AS(explain::resolve(q, scene, query.camera()), explain::QuestionError);
  q.pixel = {4, 0};
  q.sample = 1; // there is one only, number 0
  CHECK_THROWS_AS(explain::resolve(q, scene, query.camera()), explain::QuestionError);
  CHECK_THROWS_AS(explain::parse({.pixel = "1,x"}), explain::QuestionError);
  CHECK_THROWS_AS(explain::parse({.ray = {"1,2", "0,0,1"}}), explain::QuestionError);
}
