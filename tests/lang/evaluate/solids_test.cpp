#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

using Codes = std::vector<std::string>;
using Operation = scene::Combination::Operation;

namespace {

scene::Scene scene_of(const std::string& text) {
  Loaded loaded = load(text);
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  return *std::move(loaded.scene);
}

const scene::Combination& combination(const scene::Scene& scene, const scene::Object& object) {
  REQUIRE(object.shape.kind == scene::kind_of<scene::Combination>);
  return scene.shapes.get<scene::Combination>(object.shape);
}

} // namespace

TEST_CASE("solids: operators and nouns say the same") {
  const scene::Scene scene =
      scene_of("sphere {} | box {}\nunion { sphere {}, box {} }\nsphere {} & box {}\nintersection { [sphere {}, box "
               "{}] }\nbox {} - sphere {}\ndifference { box {}\n sphere {} }");
  REQUIRE(scene.objects.size() == 6);
  const Operation expected[] = {Operation::unite,     Operation::unite,    Operation::intersect,
                                Operation::intersect, Operation::subtract, Operation::subtract};
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(combination(scene, scene.objects[i]).operation == expected[i]);
    CHECK(combination(scene, scene.objects[i]).operands.size() == 2);
  }
}

TEST_CASE("solids: a row of equal operators is one combination; & binds before | and -") {
  const scene::Scene scene = scene_of("sphere {} | box {} | cone {} | sphere {} & box {}\nbox {} - sphere {} - cone "
                                      "{}\nbox {} - (sphere {} - cone {})");
  const scene::Combination& all = combination(scene, scene.objects[0]);
  REQUIRE(all.operands.size() == 4);
  CHECK(combination(scene, all.operands[3]).operation == Operation::intersect);
  CHECK(combination(scene, scene.objects[1]).operands.size() == 3);
  CHECK(combination(scene, scene.objects[2]).operands.size() == 2);
}

TEST_CASE("solids: keeping the left side of a row leaves it as it was") {
  const scene::Scene scene = scene_of("two = sphere {} | box {}\nthree = two | cone {}\ntwo\nthree\ntwo | plane {}");
  CHECK(combination(scene, scene.objects[0]).operands.size() == 2);
  CHECK(combination(scene, scene.objects[1]).operands.size() == 3);
  CHECK(combination(scene, scene.objects[2]).operands.size() == 3);
}

TEST_CASE("solids: what was moved or painted stays a combination of its own") {
  const scene::Scene scene =
      scene_of("((sphere {} | box {}) { material: red }) | cone {}\n(box {} - sphere {}).move(x: 1) - cone {}");
  CHECK(combination(scene, scene.objects[0]).operands.size() == 2);
  const scene::Combination& cut = combination(scene, scene.objects[1]);
  REQUIRE(cut.operands.size() == 2);
  CHECK(combination(scene, cut.operands[0]).operation == Operation::subtract);
}

TEST_CASE("solids: a list or group as an operand is the union of its solids") {
  const scene::Scene scene =
      scene_of("box {} - [sphere {}, cone {}]\npair = group { sphere {}, group { cone {} } }\nbox {} & pair\npair");
  const scene::Combination& cut = combination(scene, scene.objects[0]);
  REQUIRE(cut.operands.size() == 2);
  CHECK(combination(scene, cut.operands[1]).operation == Operation::unite);
  const scene::Combination& common = combination(scene, scene.objects[1]);
  const scene::Combination& pair = combination(scene, common.operands[1]);
  CHECK(pair.operation == Operation::unite);
  REQUIRE(pair.operands.size() == 2);
  CHECK(combination(scene, pair.operands[1]).operands.size() == 1);   // the inner group, too
  CHECK(scene.objects[2].shape.kind == scene::kind_of<scene::Group>); // as a thing it stays a group
}

TEST_CASE("solids: out of nothing comes nothing, and nothing takes nothing away") {
  const std::string nothing = "gone = sphere { visible: false }\nempty = union { [] }\n";
  CHECK(scene_of(nothing + "gone - box {}\nempty - box {}\nempty & box {}\nbox {} & gone\nplane {}").objects.size() ==
        1);
  const scene::Scene scene =
      scene_of(nothing + "box {} - gone\nbox {} - empty\nempty | box {}\n(gone - box {}) | cone {}");
  REQUIRE(scene.objects.size() == 4);
  for (const scene::Object& object : scene.objects) CHECK(combination(scene, object).operands.size() == 1);
  CHECK(errors("intersection {}") == Codes{"E0407"});
  CHECK(errors("cut = difference {}\ncut { box {}, sphere {} }").empty()); // filled later
}

TEST_CASE("solids: open shapes, lights and other values cannot take part") {
  CHECK(errors("box {} - disc {}") == Codes{"E0401"});
  CHECK(errors("box {} - group { sphere {}, group { quad {} } }") == Codes{"E0401"});
  CHECK(errors("box {} - cylinder { open: true }") == Codes{"E0401"});
  CHECK(errors("cone { open: true } | box {}") == Codes{"E0401"});
  CHECK(errors("box {} | polygon {}") == Codes{"E0401"});
  CHECK(errors("box {} - cylinder { infinite: true } - plane { y: 0 }").empty());
  CHECK(errors("union { light {}, box {} }") == Codes{"E0402"});
  CHECK(errors("box {} - 2") == Codes{"E0304"});
  CHECK(errors("box {} | material {}") == Codes{"E0304"});
}

TEST_CASE("solids: a def may be an operand and a combination may be a def's body") {
  const scene::Scene scene = scene_of("def ring(r) { material: red\n cylinder { radius: r } - cylinder { radius: r / "
                                      "2, height: 3 } }\nring { r: 2 } & box { size: 3 }\nring { r: 2 }");
  const scene::Combination& common = combination(scene, scene.objects[0]);
  REQUIRE(common.operands.size() == 2);
  CHECK(common.operands[0].material != scene::no_material); // the def's own default
  CHECK(combination(scene, common.operands[0]).operation == Operation::unite);
}

TEST_CASE("solids: one solid is one medium") {
  CHECK(errors("sphere { material: glass } | box { material: water }") == Codes{"E0408"});
  CHECK(errors("(sphere { material: glass } | box { material: water }) { material: diamond }").empty());
  CHECK(errors("sphere { material: glass } - box { material: red }").empty()); // opaque parts say nothing
  CHECK(errors("sphere { material: glass } - box {}").empty());
  CHECK(errors("group { material: water\n sphere { material: glass } - box {} }") ==
        Codes{"E0408"}); // the box is water
  CHECK(errors("group { material: red\n sphere { material: glass } - box {} }").empty());
  CHECK(errors("part = sphere { material: glass } - plane {}\npart | (box { material: water } & sphere {})") ==
        Codes{"E0408"});
  CHECK(errors("kept = sphere { material: glass } | box { material: water }\nsphere {}").empty()); // not in the scene
}

TEST_CASE("solids: hundreds of operands, one after the other") {
  const scene::Scene scene = scene_of("fold(fn(all, i) => all | sphere { at: [i, 0, 0] }, box {}, 1..3000)");
  CHECK(combination(scene, scene.objects[0]).operands.size() == 3001);
}
