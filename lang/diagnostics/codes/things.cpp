#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> things() {
  static const std::vector<Code> table = {
      {"E0401", "An open shape cannot be combined",
       "`|`, `&` and `-` need solids, things with an inside. A disc, a triangle, a quad, a polygon and an open "
       "cylinder or cone "
       "have none. A thin box serves as a plate with an inside, and a cylinder without `open: true` is a solid.",
       "box {} - cylinder { radius: 0.2, height: 2, open: true }", "box {} - cylinder { radius: 0.2, height: 2 }"},
      {"E0402", "A light cannot be combined",
       "Combinations are made of solids. A light that is to move with them stands beside them in a `group`.",
       "union { sphere {}\n light { at: [0, 2, 0] } }", "group { sphere {}\n light { at: [0, 2, 0] } }"},
      {"E0403", "A camera is inside a thing",
       "The camera belongs to the scene as a whole: it stands at the top level, and moves with no group.",
       "group { sphere {}\n camera { at: [0, 0, 5] } }", "sphere {}\ncamera { at: [0, 0, 5] }"},
      {"E0404", "There is a second camera",
       "A picture is taken from one place. Keep the other views under names, `above = camera { … }`, and place one.",
       "sphere {}\ncamera { at: [0, 0, 5] }\ncamera { at: [5, 0, 0] }",
       "sphere {}\nfront = camera { at: [0, 0, 5] }\nside = camera { at: [5, 0, 0] }\nfront"},
      {"E0405", "A thing is put into one that cannot contain things",
       "`group`, `union`, `intersection` and `difference` hold things. The block of anything else holds its "
       "properties; "
       "what a `def` makes is filled by its body alone.",
       "sphere { radius: 2\n box {} }", "group { sphere { radius: 2 }\n box {} }"},
      {"E0406", "A thing is flattened",
       "A scale of 0, or a matrix whose determinant is 0, leaves nothing that could be seen from all sides and cannot "
       "be "
       "undone. Use a small factor, or a flat shape such as `disc` or `quad`.",
       "sphere { scale: [1, 0, 1] }", "sphere { scale: [1, 0.01, 1] }"},
      {"E0407", "The properties of a thing are inconsistent",
       "Each property by itself is fine, but together they describe nothing: two ends of a cylinder at one point, the "
       "points of a polygon not in one plane, a difference without anything to take away from.",
       "cylinder { from: [0, 1, 0], to: [0, 1, 0] }", "cylinder { from: [0, 0, 0], to: [0, 1, 0] }"},
      {"E0408", "The parts of a solid refract differently",
       "What is combined becomes one solid, and one solid is one medium with one index of refraction. Give the whole a "
       "material, or "
       "its parts the same `ior`. Solids of two media, one inside the other, are placed beside each other, uncombined.",
       "sphere { material: glass } | box { material: water }", "(sphere {} | box {}) { material: glass }"},
      {"E0409", "This cannot be moved with a chain",
       "Shapes, lights and patterns take `.move(…)`, `.rotate(…)` and so on. A camera stands where its properties say, "
       "and a "
       "material stands nowhere.",
       "sphere {}\ncamera { at: [0, 0, 5] }.move(x: 2)", "sphere {}\ncamera { at: [2, 0, 5] }"},
      {"E0410", "A material or pattern is placed without a shape",
       "A surface is seen on a shape: keep the material under a name and write it after `material:`.",
       "material { color: red }\nsphere {}", "paint = material { color: red }\nsphere { material: paint }"},
      {"E0411", "There is nothing to see",
       "A picture is made of things that are placed: a thing on a line of its own, or its name. What follows a `=` is "
       "kept "
       "for later. One line is a whole scene: `sphere {}`.",
       "", ""},
      {"E0412", "There is a second sky",
       "The background has one colour in each direction. Keep the other skies under names, `dusk = sky { … }`, and "
       "place one.",
       "sphere {}\nsky { zenith: skyblue }\nsky { horizon: orange }",
       "sphere {}\nday = sky { zenith: skyblue }\ndusk = sky { horizon: orange }\ndusk"},
  };
  return table;
}

} // namespace rt::lang::codes
