#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> values() {
  static const std::vector<Code> table = {
      {"E0301", "A property takes another kind of value",
       "The message says what the property takes and what it was given. A vector is a list of three numbers, an angle "
       "is "
       "a number of degrees, a colour is `#ff8800`, a name such as `peru`, or `rgb(1, 0.5, 0)`.",
       "sphere { radius: \"2\" }", "sphere { radius: 2 }"},
      {"E0302", "A value is outside the range that the property allows",
       "The kind of value is right, but it is out of range: a radius must be greater than 0, a fraction between 0 and "
       "1, a polygon must have at least three points.",
       "sphere { radius: -1 }", "sphere { radius: 1 }"},
      {"E0303", "A number is not finite",
       "Dividing by 0 gives infinity, and 0/0 is not a number at all. Neither can be the size or place of a thing. "
       "Look for "
       "the division, the power or the tangent that it came from.",
       "sphere { radius: 1 / 0 }", "sphere { radius: 1 / 2 }"},
      {"E0304", "An operator does not fit its operands",
       "Numbers are computed with numbers, vectors with vectors of the same size or with a factor, solids are combined "
       "with "
       "solids, and strings are joined with strings: `str(x)` turns a value into one.",
       "sphere { at: [1, 2, 3] + 1 }", "sphere { at: [1, 2, 3] + [1, 1, 1] }"},
      {"E0305", "A condition is neither true nor false",
       "`if`, `and`, `or` and `not` take truth values, which comparisons give: `n > 0`, `x == y`.",
       "n = 3\nif n { sphere {} }", "n = 3\nif n > 0 { sphere {} }"},
      {"E0306", "Something that is not a function is called",
       "Parentheses behind a value call it, and only a function can be called. An element of a list is written "
       "`list[0]`.",
       "sizes = [1, 2]\nsphere { radius: sizes(0) }", "sizes = [1, 2]\nsphere { radius: sizes[0] }"},
      {"E0307", "A loop iterates over something that is not a list",
       "`for x in …` takes a list or a range: `0..<10`, `[1, 3, 5]`, `range(10)`.",
       "for i in 3 { sphere { at: [i, 0, 0] } }", "for i in 0..<3 { sphere { at: [i, 0, 0] } }"},
      {"E0308", "A list has no such element",
       "Elements are counted from 0: a list of three has `l[0]`, `l[1]` and `l[2]`, and from its end `l[-1]`, `l[-2]` "
       "and "
       "`l[-3]`. `len(l)` says how many there are.",
       "sizes = [1, 2, 3]\nsphere { radius: sizes[3] }", "sizes = [1, 2, 3]\nsphere { radius: sizes[2] }"},
      {"E0309", "A function takes another kind of argument",
       "The message says what the parameter takes and what it was given.", "sphere { radius: sqrt(\"2\") }",
       "sphere { radius: sqrt(2) }"},
      {"E0310", "A function has no value for this argument",
       "The kind of the argument is right, but there is no answer: a negative number has no square root, a vector of "
       "length 0 no direction, an empty list no greatest element.",
       "sphere { radius: sqrt(-2) }", "sphere { radius: sqrt(2) }"},
      {"E0311", "The step of a range is 0",
       "The step of a range is what its elements differ by; it may be negative, but not 0.",
       "for x in 0..1 by 0 { sphere { at: [x, 0, 0] } }", "for x in 0..1 by 0.5 { sphere { at: [x, 0, 0] } }"},
      {"E0312", "A value is not used",
       "A line of its own holds a thing, a list of things or `none`; any other value would be lost there. Bind it to a "
       "name, "
       "or write it where it is needed.",
       "sphere {}\n2 + 3", "sphere { radius: 2 + 3 }"},
      {"E0313", "An `if` that is a value has no `else`",
       "Where a value is needed there must be one in either case. As a statement, between other statements, an `if` "
       "needs no `else`.",
       "n = 2\nsphere { radius: if n > 1 { 2 } }", "n = 2\nsphere { radius: if n > 1 { 2 } else { 1 } }"},
      {"E0314", "A block has no value",
       "The body of a function and the branches of an `if` that is a value hold names, bound with `=`, and then one "
       "expression: the value of it all.",
       "fn half(x) { y = x / 2 }\nsphere { radius: half(1) }",
       "fn half(x) {\n  y = x / 2\n  y\n}\nsphere { radius: half(1) }"},
      {"E0315", "A value is needed that is known only while the picture is made",
       "A function that a pattern is made of is compiled once, for all points. What depends on the point can be "
       "computed "
       "with, compared and chosen by, but it cannot be sorted, printed, be a seed, or decide between things.",
       "sphere { material: fn(p) => random(p.x) }", "sphere { material: fn(p) => noise_at(p) }"},
  };
  return table;
}

} // namespace rt::lang::codes
