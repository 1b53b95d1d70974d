#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> names() {
  static const std::vector<Code> table = {
      {"E0201", "An unknown name",
       "There is no such name: none bound with `=` before this line, no `def` or `fn` in this block or an enclosing "
       "one, no thing, function or colour of the language. Names are case-sensitive.",
       "wood = material { color: peru }\nsphere { material: wod }",
       "wood = material { color: peru }\nsphere { material: wood }"},
      {"E0202", "A name is bound twice",
       "A name never changes its value, so one block binds it once. Choose another name for the second value. (An "
       "inner "
       "block may bind the name again for itself.)",
       "r = 1\nr = 2\nsphere { radius: r }", "small = 1\nlarge = 2\nsphere { radius: large }"},
      {"E0203", "A name has no value yet",
       "A name bound with `=` is known after its line, and its own right side does not see it. A function may be "
       "called only after the lines that give the names in it their values.",
       "sphere { radius: r }\nr = 2", "r = 2\nsphere { radius: r }"},
      {"E0204", "A thing has no such property",
       "Each kind of thing has its own properties; the note lists them. A colour, for instance, belongs to the "
       "material, "
       "and a value to be kept for later is bound with `=`, not `:`.",
       "sphere { raduis: 2 }", "sphere { radius: 2 }"},
      {"E0205", "A property is set twice", "A block says each property once. Leave out the one that is not meant.",
       "sphere { radius: 1, radius: 2 }", "sphere { radius: 2 }"},
      {"E0206", "A thing is described in two alternative ways at once",
       "Some things can be written in more than one form: a plane by `normal` and `offset`, or by `y`. One block uses "
       "one "
       "form. (A copy with changes may use another one than its original: that drops what the other form said.)",
       "plane { y: 0, normal: [0, 1, 0] }", "plane { y: 0 }"},
      {"E0207", "A name was bound where a property was meant",
       "`name = value` binds a name and changes nothing else; `name: value` sets a property. Here a name is bound that "
       "is "
       "called like a property of the thing, and nothing ever reads it.",
       "sphere { radius = 2 }", "sphere { radius: 2 }"},
      {"E0208", "The arguments do not fit the function",
       "A call gives each parameter a value at most once, by position or by name, and all those that have no default.",
       "fn double(x) = 2 * x\nsphere { radius: double(1, 2) }", "fn double(x) = 2 * x\nsphere { radius: double(1) }"},
      {"E0209", "A thing is written with parentheses",
       "Braces describe a thing, parentheses compute. A thing is copied with changes by the properties in its block, "
       "and that holds for what a `def` makes too.",
       "sphere(2)", "sphere { radius: 2 }"},
      {"E0210", "A function is not a thing",
       "Only a thing can be followed by a block. A function takes its arguments in parentheses, and a chain method "
       "such "
       "as `rotate` stands behind a thing, after a dot.",
       "rotate(y: 30)\nbox {}", "box {}.rotate(y: 30)"},
      {"E0211", "A parameter has the name of a common property",
       "`at`, `rotate`, `scale`, `material`, `name`, `visible` and `casts_shadow` say where and how the thing stands "
       "that a "
       "`def` makes. A parameter of that name would hide them.",
       "def post(scale) { cylinder { height: scale } }\npost { scale: 2 }",
       "def post(length) { cylinder { height: length } }\npost { length: 2 }"},
      {"E0212", "There is no such part",
       "After a dot stands a field of a record, a name of a file read with `use`, `x`, `y` or `z` of a vector, a "
       "property "
       "that was written for a thing, or a chain method such as `.move(…)`.",
       "p = [1, 2, 3]\nsphere { radius: p.w }", "p = [1, 2, 3]\nsphere { radius: p.z }"},
      {"E0213", "A property is set where there is no thing",
       "`name: value` sets a property of the thing whose block it stands in. In a function there is no such thing; a "
       "name is bound with `=`.",
       "fn area(r) {\n  square: r * r\n  pi * square\n}\nsphere { radius: area(1) }",
       "fn area(r) {\n  square = r * r\n  pi * square\n}\nsphere { radius: area(1) }"},
      {"E0214", "A property is not a name",
       "What is written as a property cannot be read back in the same block. Bind the value to a name before the block "
       "and use "
       "that in both places.",
       "sphere { radius: 2, at: [0, radius, 0] }", "r = 2\nsphere { radius: r, at: [0, r, 0] }"},
      {"E0215", "A name is known only inside its block",
       "A name bound inside the block of an `if` or a `for` ends with it. To choose between two values, use the `if` "
       "itself "
       "as a value.",
       "if 1 < 2 { r = 1 }\nsphere { radius: r }", "r = if 1 < 2 { 1 } else { 2 }\nsphere { radius: r }"},
      {"E0216", "A `param` is inside a block",
       "`param` declares what the command line may set with `-D name=value`; it stands at the top level of the scene.",
       "def post() { param length = 2\n  cylinder { height: length } }\npost {}",
       "param length = 2\ndef post() { cylinder { height: length } }\npost {}"},
      {"E0217", "An `expect` is inside a thing",
       "`expect` says something about the scene as a whole, so it stands at the top level, or in a `for` or `if` "
       "there: not in "
       "a thing, a `def` or a function.",
       "group { sphere {}\n  expect 1 + 1 == 2 }", "group { sphere {} }\nexpect 1 + 1 == 2"},
      {"E0218", "Only a ray hits or misses",
       "Before `hits` and `misses` stands the ray: `pixel(x, y)`, `image_point(x, y)`, or `ray(origin, direction)`, "
       "which may "
       "name a thing after that to be tested alone.",
       "ball = sphere {}\nball\nexpect [400, 300] hits ball",
       "ball = sphere {}\nball\nexpect pixel(400, 300) hits ball"},
  };
  return table;
}

} // namespace rt::lang::codes
