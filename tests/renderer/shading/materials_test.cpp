#include "renderer/shading/materials.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace rt;

namespace {

std::span<const scene::Field> table() {
  return fields(static_cast<const scene::Material*>(nullptr));
}

/// A material with one of its properties changed.
scene::Material with(const scene::Field& field, const scene::FieldValue& value) {
  scene::Material material;
  field.set(&material, value);
  return material;
}

} // namespace

TEST_CASE("materials: where a pattern gives a property, it is what the pattern shows there") {
  int textured = 0;
  for (const scene::Field& field : table()) {
    if (!field.is_textured) continue;
    INFO(std::string(field.name));
    ++textured;
    scene::Scene scene;
    scene.patterns.push_back({scene::Checker{grey(0.25), grey(0.75)}, {}});
    scene.materials = {with(field, scene::PatternId{0}), with(field, grey(0.25)), with(field, grey(0.75))};
    const Materials materials(scene);
    CHECK(materials.has_patterns(1));
    CHECK_FALSE(materials.has_patterns(2));
    CHECK(materials.at(1, {0.5, 0.5, 0.5}) == materials.constant(2));
    CHECK(materials.at(1, {0.5, 1.5, 0.5}) == materials.constant(3));
    CHECK_FALSE(materials.constant(2) == materials.constant(3));
  }
  // color, ambient, diffuse, emission, specular, shininess, metallic, reflect, refract, roughness, coat, bump
  CHECK(textured == 12);
}

TEST_CASE("materials: a pattern in a pattern, each in its own place, and several properties at once") {
  scene::Scene scene;
  // Cells of 4, in whose first stand cells of 1.
  scene.patterns.push_back({scene::Checker{grey(0.1), grey(0.2)}, {}});
  scene.patterns.push_back({scene::Checker{scene::PatternId{0}, grey(0.9)}, {.scale = {4, 4, 4}}});
  scene::Material m;
  m.refract = scene::PatternId{1}, m.reflect = scene::PatternId{0}, m.specular = 0.5;
  scene.materials = {m};
  const Materials materials(scene);
  const auto at = [&](const Vec3& p) { return materials.at(1, p); };
  CHECK(at({0.5, 0.5, 0.5}).refract == 0.1);
  CHECK(at({1.5, 0.5, 0.5}).refract == 0.2);
  CHECK(at({4.5, 0.5, 0.5}).refract == 0.9);
  CHECK(at({4.5, 0.5, 0.5}).reflect == grey(0.1));
  CHECK(at({5.5, 0.5, 0.5}).reflect == grey(0.2));
  CHECK(at({4.5, 0.5, 0.5}).specular == 0.5);
}

TEST_CASE("materials: one that a pattern may open somewhere is not opaque") {
  scene::Material m;
  CHECK(is_opaque(m));
  m.refract = 0.5;
  CHECK_FALSE(is_opaque(m));
  m.refract = scene::PatternId{0};
  CHECK_FALSE(is_opaque(m));
}
