#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> lint() {
  static const std::vector<Code> table = {
      {"W0001", "A malformed lint comment",
       "A comment `// lint: allow NAME` keeps the lint silent about one line: its own or, if it stands alone, the next "
       "one; with "
       "`in this file` behind the names, about the whole file. NAME is a rule's name or code; `rtlang lint --rules` "
       "lists them.",
       "// lint: allow hiden\nsphere {}", "// lint: allow hidden\nsphere {}"},
      {"W0101", "A thing is bound and never placed",
       "After `=` a thing is kept for later, and only a thing on a line of its own is in the scene. This one is bound "
       "to a name that "
       "nothing placed ever leads back to. Place it, or take it out.",
       "ball = sphere { radius: 2 }\nbox {}", "ball = sphere { radius: 2 }\nball\nbox { at: [4, 0, 0] }"},
      {"W0102", "A name is never used",
       "Nothing that is in the scene needs this value, `fn`, `def`, `param` or file. Often another name was meant "
       "where it should "
       "stand. In a file that places nothing, and in one that others include or use, names at the top are for others "
       "and are not "
       "warned of.",
       "def table(height = 1) { box { at: [0, height, 0] } }\nsphere {}",
       "def table(height = 1) { box { at: [0, height, 0] } }\ntable {}"},
      {"W0103", "A parameter is never used",
       "Whatever the caller passes changes nothing. If the parameter must be there for its place among others, begin "
       "its name with "
       "`_`.",
       "def post(height) { cylinder { height: 2 } }\npost { height: 3 }",
       "def post(height) { cylinder { height: height } }\npost { height: 3 }"},
      {"W0104", "Radians where degrees are expected",
       "Angles are degrees everywhere: in `rotate`, `fov`, the angles of a spot, and in `sin`, `cos` and `tan`. This "
       "one has pi in it, "
       "is a well-known angle in radians to some decimals, or is a fraction that opens a camera or spot by three "
       "degrees at most. A number in radians "
       "takes the suffix `rad`, as in `1.5rad`.",
       "box { rotate: [0, pi / 4, 0] }", "box { rotate: [0, 45, 0] }"},
      {"W0105", "A name hides a kind of thing",
       "Names may be chosen freely, but from here on the word no longer means what the language means by it, which a "
       "later reader will "
       "not expect.",
       "box = 2\nsphere { radius: box }", "half = 2\nsphere { radius: half }"},
      {"W0106", "A transparent solid that does not refract light",
       "`ior`, the index of refraction, is 1 unless it is written, so that light goes straight through a solid with "
       "`refract` and it "
       "looks like coloured air, not like glass. Where that is meant, write `ior: 1`.",
       "sphere { material: material { refract: 0.9 } }", "sphere { material: material { refract: 0.9, ior: 1.5 } }"},
      {"W0201", "The camera is inside a solid",
       "The camera is inside a transparent solid, or inside an opaque one and sees nothing else. A room is "
       "no mistake: an "
       "opaque solid with things or a light in it. Planes do not count.",
       "sphere { radius: 5 }\ncamera { at: [0, 0, 3] }\nsun {}",
       "sphere { radius: 2 }\ncamera { at: [0, 0, 6] }\nsun {}"},
      {"W0202", "A light is inside an opaque solid",
       "No light leaves an opaque solid that casts a shadow. For a lamp that can be seen, give the solid "
       "`casts_shadow: false`, and "
       "`emission` so that it is bright itself. A room that the camera is in, too, is no mistake.",
       "sphere {}\nsphere { at: [3, 4, 3], radius: 0.3 }\nlight { at: [3, 4, 3] }",
       "sphere {}\nsphere { at: [3, 4, 3], radius: 0.3, casts_shadow: false, material: material { emission: 1 } "
       "}\nlight { at: [3, 4, 3] }"},
      {"W0203", "Nothing is in view",
       "No pixel of the picture shows anything. The note says where things are, as the camera sees it.",
       "sphere {}\ncamera { at: [0, 0, 6], look_at: [9, 0, 6] }\nsun {}",
       "sphere {}\ncamera { at: [0, 0, 6], look_at: [0, 0, 0] }\nsun {}"},
      {"W0204", "Everything is behind the camera",
       "No pixel shows anything, because all there is lies behind the camera. Often `at` and `look_at` were mistaken "
       "for each other, or "
       "`look_at` was left out, which is the origin then.",
       "sphere { at: [0, 0, 9] }\ncamera { at: [0, 0, 4], look_at: [0, 0, 0] }\nsun {}",
       "sphere { at: [0, 0, 0] }\ncamera { at: [0, 0, 4], look_at: [0, 0, 0] }\nsun {}"},
      {"W0205", "Two opaque surfaces coincide",
       "Two opaque surfaces coincide exactly, and look different. Only the one that is placed first is seen. Move one "
       "of them by a little, or place the one that is to be seen first.",
       "box { from: [-3, -1, -3], to: [3, 0, 3], material: green }\nbox { from: [-1, -1, -1], to: [1, 0, 1], material: "
       "red }\n"
       "camera { at: [0, 4, 6], look_at: [0, 0, 0] }\nsun {}",
       "box { from: [-3, -1, -3], to: [3, 0, 3], material: green }\nbox { from: [-1, -1, -1], to: [1, 0.01, 1], "
       "material: red }\n"
       "camera { at: [0, 4, 6], look_at: [0, 0, 0] }\nsun {}"},
      {"W0206", "A thing is smaller than a pixel",
       "What this line places is in view, but smaller than a pixel, and no pixel shows it: pixels see what lies at "
       "their centres. "
       "Often a `scale` or a unit is wrong.",
       "plane { y: -1 }\nsphere { radius: 0.0002 }\ncamera { at: [0, 1, 6], look_at: [0, 0, 0] }\nsun {}",
       "plane { y: -1 }\nsphere { radius: 0.2 }\ncamera { at: [0, 1, 6], look_at: [0, 0, 0] }\nsun {}"},
      {"W0207", "A thing is hidden by another",
       "What this line places is entirely inside an opaque solid, or entirely behind an infinite plane, so that no "
       "ray of the "
       "picture can reach it. What only stands behind something else is not warned of.",
       "plane { y: 0, material: peru }\nsphere { at: [0, -3, 0] }\nbox { at: [0, 1, 0] }\ncamera { at: [0, 2, 8], "
       "look_at: [0, 1, 0] }\nsun {}",
       "plane { y: 0, material: peru }\nsphere { at: [3, 1, 0] }\nbox { at: [0, 1, 0] }\ncamera { at: [0, 2, 8], "
       "look_at: [0, 1, 0] }\nsun {}"},
      {"W0208", "Transparent solids overlap",
       "Two transparent solids with different media overlap and neither contains the other. A ray in the overlap is in "
       "both, and refracts as if it were in the one entered last. Make one solid of them with `|`, cut one out of "
       "the other with "
       "`-`, or put one wholly into the other.",
       "sphere { material: glass }\nsphere { at: [1, 0, 0], material: water }\ncamera { at: [0, 0, 8] }\nsun {}",
       "sphere { material: glass }\nsphere { at: [3, 0, 0], material: water }\ncamera { at: [0, 0, 8] }\nsun {}"},
      {"W0209", "A scale of almost zero",
       "The transform shrinks the thing to less than a millionth of its size, overall or along one direction. Where "
       "that is meant, "
       "there are shapes for it: a `disc`, a `quad`.",
       "sphere { scale: [1, 0.0000001, 1] }", "sphere { scale: [1, 0.1, 1] }"},
      {"W0301", "A light that reaches nothing",
       "Nothing visible in the picture is lit by this light. The note says why: every ray to it is blocked, a spot "
       "points past everything, the surfaces face away, or it emits nothing.",
       "plane { y: 0 }\nsphere { at: [0, 1, 0] }\nlight { at: [0, -4, 0] }\ncamera { at: [0, 2, 8], look_at: [0, 1, 0] "
       "}",
       "plane { y: 0 }\nsphere { at: [0, 1, 0] }\nlight { at: [0, 9, 4] }\ncamera { at: [0, 2, 8], look_at: [0, 1, 0] "
       "}"},
      {"W0302", "Everything visible is black",
       "Every surface that the picture shows is black. Without a light, `ambient` or `emission` there is nothing to "
       "see them by.",
       "sphere {}\nambient: 0\ncamera { at: [0, 0, 6] }",
       "sphere {}\nambient: 0.1\ncamera { at: [0, 0, 6] }\nsun { direction: [-1, -1, -1] }"},
      {"W0303", "Most of the picture is overexposed",
       "More than half of the surfaces that are seen are brighter than a picture can show, so that their shading is "
       "lost. Lower the "
       "`intensity` of the lights, or their number.",
       "sphere {}\nsun { direction: [0, 0, -1], intensity: 9 }\ncamera { at: [0, 0, 6] }",
       "sphere {}\nsun { direction: [0, 0, -1], intensity: 0.9 }\ncamera { at: [0, 0, 6] }"},
      {"W0304", "Many rays end at max_depth",
       "In more than the given share of pixels (`--depth-share`) a reflection or refraction that counts for at least a "
       "tenth is black "
       "because the ray was mirrored or refracted as often as `max_depth` allows. Raise `max_depth`, unless the "
       "darkness is meant.",
       "max_depth: 1\nsphere { radius: 2, material: glass }\nplane { y: -2 }\ncamera { at: [0, 0, 6] }\nsun {}",
       "max_depth: 12\nsphere { radius: 2, material: glass }\nplane { y: -2 }\ncamera { at: [0, 0, 6] }\nsun {}"},
  };
  return table;
}

} // namespace rt::lang::codes
