// What POV-Ray is told of a pattern.

#include "tools/povray/export/export_pattern.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tools::povray;

namespace {

PatternText text_of(const scene::PatternLayout& layout) {
  std::vector<std::string> inexact;
  PatternText text = pattern_text(layout, inexact);
  CHECK(inexact.empty());
  return text;
}
std::vector<double> places_of(const PatternText& text) {
  std::vector<double> places;
  for (const PatternText::Part& part : text.parts) places.push_back(part.place);
  return places;
}

} // namespace

TEST_CASE("export: POV-Ray's own patterns and wave forms are written where they are the same") {
  scene::Onion onion;
  CHECK(text_of(onion).head == "onion");
  onion.wave = scene::Wave::scallop;
  CHECK(text_of(onion).head == "onion scallop_wave");
  CHECK(text_of(scene::Leopard{}).head == "leopard");
  CHECK(text_of(scene::Brick{}).tail == "brick_size <0.6, 0.2, 0.3> mortar 0.03");
}

TEST_CASE("export: what begins anew after 1.00001 in POV-Ray is written as a function that begins anew after 1") {
  scene::Onion onion;
  onion.frequency = 3, onion.phase = 0.5, onion.wave = scene::Wave::sine;
  const PatternText text = text_of(onion);
  REQUIRE(text.declared.size() == 2);
  CHECK(text.declared[0] == "within_period = function(u) { select(u, u - floor(u), 0, u - ceil(u) + 1) }");
  CHECK(text.declared[1] == "pattern_1 = function { pattern { onion } }");
  CHECK(text.head == "function { within_period(3 * (pattern_1(x, y, z)) + 0.5) } sine_wave");
}

TEST_CASE("export: steps are two entries of a map in one place") {
  scene::Rings rings;
  rings.stops = {{0.25, black}, {0.5, grey(0.5)}, {1, white}};
  CHECK(places_of(text_of(rings)) == std::vector<double>{0.25, 0.5, 1});
  CHECK(text_of(rings).is_mixed);
  rings.stepped = true;
  CHECK(places_of(text_of(rings)) == std::vector<double>{0.25, 0.5, 0.5, 1, 1});
  CHECK_FALSE(text_of(rings).is_mixed);
}

TEST_CASE("export: values by chance and more than 256 entries are told to be otherwise in POV-Ray") {
  std::vector<std::string> inexact;
  pattern_text(scene::Cells{}, inexact);
  CHECK(inexact.size() == 1);
  scene::Onion onion;
  onion.stops.assign(300, {0.5, white});
  CHECK(pattern_text(onion, inexact).parts.size() == 256);
  CHECK(inexact.size() == 2);
}
