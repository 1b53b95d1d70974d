#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

namespace {

/// The material of the only object.
scene::Material material(const std::string& text, const std::string& before = {}) {
  Loaded loaded = load(before + "\nsphere { material: " + text + " }");
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  return loaded.scene->materials.at(static_cast<std::size_t>(loaded.scene->objects.back().material));
}

/// What is said of a material that is wrong.
std::string mistake(const std::string& text) {
  const Loaded loaded = load("sphere { material: material { " + text + " } }");
  REQUIRE_FALSE(loaded.diagnostics.empty());
  return loaded.diagnostics.front().message + ": " + loaded.diagnostics.front().label;
}

constexpr scene::Metal gold{{0.131, 0.4919, 1.4829}, {4.0624, 2.2399, 1.7805}};

} // namespace

TEST_CASE("materials: a metal is a record of n and k, or a material that has one") {
  CHECK(material("material { metal: { n: linear_rgb(0.131, 0.4919, 1.4829), k: linear_rgb(4.0624, 2.2399, 1.7805) } }")
            .metal == gold);
  CHECK(material("material { metal: gold }").metal == gold);
  CHECK(material("material { metal: { k: 3, n: 0.5 } }").metal == scene::Metal{grey(0.5), grey(3)});
  CHECK(material("material { metal: own }", "own = material { metal: gold }").metal == gold);
  CHECK(material("{ metal: gold }").metal == gold);
  CHECK_FALSE(material("material { reflect: 0.5 }").metal);
  CHECK(number("gold.metal.k.r") == Approx(4.0624));
}

TEST_CASE("materials: a medium's absorption is a record of a colour and a distance") {
  CHECK(material("glass { absorb: { color: linear_rgb(0.5, 0.25, 1), distance: 2 } }").absorb ==
        scene::Absorb{{0.5, 0.25, 1}, 2});
  CHECK(material("glass { absorb: { color: 0.5, distance: 2 } }").absorb == scene::Absorb{grey(0.5), 2});
}

TEST_CASE("materials: what is not written is known as such, and has its usual value") {
  const scene::Material plain = material("material { roughness: 0.5 }");
  CHECK_FALSE(plain.shininess.is_written());
  CHECK(std::get<double>(plain.shininess.value()) == 32);
  CHECK(std::get<double>(with_implied(plain).shininess.value()) == Approx(30));
  CHECK(material("material { roughness: 0.5, shininess: 32 }").shininess.is_written());
  CHECK(material("chrome").reflect.is_written());
  CHECK_FALSE(material("iron").reflect.is_written());
}

TEST_CASE("materials: mistakes in records are named") {
  CHECK(mistake("metal: glass") ==
        "`metal` takes a metal such as gold, or { n: …, k: … }, not a material: this material "
        "is no metal");
  CHECK(mistake("metal: { n: 1 }") ==
        "`metal` takes a metal such as gold, or { n: …, k: … }, not a record: this record "
        "has other fields, or other values in them");
  CHECK(mistake("metal: { n: 0, k: 1 }") == "`metal` must be greater than 0: this is 0");
  CHECK(mistake("absorb: { color: red, length: 2 }") == "`absorb` takes { color: …, distance: … }, not a record: this "
                                                        "record has other fields, or other values in them");
  CHECK(mistake("absorb: { color: red, distance: 0 }") == "`absorb` must be greater than 0: this is 0");
  CHECK(mistake("absorb: 3") == "`absorb` takes { color: …, distance: … }, not a number: this is a number");
  CHECK(mistake("roughness: 1.5") == "`roughness` must be from 0 to 1: this is 1.5");
}
