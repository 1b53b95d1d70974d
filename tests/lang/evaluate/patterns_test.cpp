// Patterns by stops: a place in them, and what is shown there.

#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

namespace {

using Codes = std::vector<std::string>;

scene::Scene scene_with(const std::string& material) {
  Loaded loaded = load("sphere { material: " + material + " }");
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  return *std::move(loaded.scene);
}

Codes codes_of(const std::string& material) {
  return errors(load("sphere { material: " + material + " }"));
}

std::string report_of(const std::string& material) {
  return report(load("sphere { material: " + material + " }"));
}

} // namespace

TEST_CASE("stops: places with colours, numbers as grey, patterns and functions") {
  const scene::Scene scene =
      scene_with("onion { stops: [[0, red], [0.25, 0.5], [0.5, checker { scale: 2 }], [1, fn(p) => p.x]], stepped: "
                 "true, frequency: -2, phase: 0.5, wave: sine, exponent: 3 }");
  REQUIRE(scene.patterns.size() == 3);
  const scene::Onion& onion = std::get<scene::Onion>(scene.patterns[2].layout);
  REQUIRE(onion.stops.size() == 4);
  CHECK(onion.stops[0] == scene::Stop{0, Color{1, 0, 0}});
  CHECK(onion.stops[1] == scene::Stop{0.25, grey(0.5)});
  CHECK(onion.stops[2] == scene::Stop{0.5, scene::PatternId{0}});
  CHECK(std::holds_alternative<scene::Checker>(scene.patterns[0].layout));
  CHECK(onion.stops[3] == scene::Stop{1, scene::PatternId{1}});
  CHECK(std::holds_alternative<scene::FunctionPattern>(scene.patterns[1].layout));
  CHECK(onion.stepped);
  CHECK(onion.frequency == -2);
  CHECK(onion.phase == 0.5);
  CHECK(onion.wave == scene::Wave::sine);
  CHECK(onion.exponent == 3);
}

TEST_CASE("stops: pairs of numbers, made by a loop") {
  const scene::Scene scene = scene_with("{ specular: rings { stops: [[i / 4, i] for i in 0..4] } }");
  const scene::Stops& stops = std::get<scene::Rings>(scene.patterns.at(0).layout).stops;
  REQUIRE(stops.size() == 5);
  CHECK(stops[3] == scene::Stop{0.75, grey(3)});
}

TEST_CASE("gradient: kinds that are nouns or functions as well are words there") {
  const auto kind_of = [](const std::string& word) {
    const scene::Scene scene = scene_with("gradient { kind: " + word + " }");
    return std::get<scene::Gradient>(scene.patterns.at(0).layout).kind;
  };
  CHECK(kind_of("box") == scene::Gradient::Kind::box);
  CHECK(kind_of("spherical") == scene::Gradient::Kind::spherical);
  CHECK(kind_of("cylindrical") == scene::Gradient::Kind::cylindrical);
  CHECK(kind_of("radial") == scene::Gradient::Kind::radial);
  CHECK(codes_of("gradient { kind: sin }") == Codes{"E0301"});
}

TEST_CASE("stops: what is no stop, or out of order, is said with its number") {
  CHECK(codes_of("onion { stops: 3 }") == Codes{"E0301"});
  CHECK(codes_of("onion { stops: 0..1 }") == Codes{"E0301"});
  CHECK(codes_of("onion { stops: [red, blue] }") == Codes{"E0301"});
  CHECK(codes_of("onion { stops: [[0, red], [1, red, 2]] }") == Codes{"E0301"});
  CHECK(codes_of("onion { stops: [[0, \"red\"]] }") == Codes{"E0301"});
  CHECK(codes_of("onion { stops: [] }") == Codes{"E0302"});
  CHECK(codes_of("onion { stops: [[0, red], [1.5, blue]] }") == Codes{"E0302"});
  CHECK(codes_of("onion { stops: [[0.5, red], [0.25, blue]] }") == Codes{"E0302"});
  CHECK(codes_of("onion { stops: [[0, red], [1 / 0, blue]] }") == codes_of("onion { phase: 1 / 0 }"));
  CHECK(codes_of("onion { stops: [[0, -1]] }") == Codes{"E0302"});
  CHECK(codes_of("onion { stops: [[0, nowhere]] }") == codes_of("nowhere"));
  CHECK(codes_of("onion { stops: [[0, fn(p) => \"x\"]] }") == Codes{"E0301"});
  CHECK_THAT(report_of("onion { stops: [red, blue] }"),
             Catch::Contains("a list of stops such as [[0, navy], [1, white]]") && Catch::Contains("stop 0 is a"));
  CHECK_THAT(report_of("onion { stops: [[0.5, red], [0.25, blue]] }"), Catch::Contains("0.25 stands behind 0.5"));
  CHECK_THAT(report_of("onion { stops: [[0, red], [1, [1, 0, 0]]] }"), Catch::Contains("rgb(1, 0, 0)"));
}

TEST_CASE("stops: where a number is asked for, each must be one that the property takes") {
  CHECK(codes_of("{ specular: onion { stops: [[0, 0.1], [1, 0.9]] } }").empty());
  CHECK(codes_of("{ refract: onion {} }").empty());
  CHECK(codes_of("{ specular: onion { stops: [[0, 0.1], [1, red]] } }") == Codes{"E0301"});
  CHECK(codes_of("{ specular: onion { stops: [[0, fn(p) => red * p.x]] } }") == Codes{"E0301"});
  CHECK(codes_of("{ specular: onion { stops: [[0, checker { a: red, b: 0 }]] } }") == Codes{"E0301"});
  CHECK(codes_of("{ refract: onion { stops: [[0, 0.1], [1, 2]] } }") == Codes{"E0302"});
  CHECK_THAT(report_of("{ shininess: onion {} }"), Catch::Contains("a stop of this onion is 0"));
}
