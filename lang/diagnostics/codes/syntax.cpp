#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> syntax() {
  static const std::vector<Code> table = {
      {"E0101", "Something else is expected here",
       "The text stops making sense at the marked place: an expression, a thing or a name should stand there. "
       "Most often a value is missing after `:`, `=` or an operator, or an operator has lost its partner.",
       "sphere { radius: }", "sphere { radius: 2 }"},
      {"E0102", "A separator is missing",
       "Properties, elements and arguments are separated by a comma, a semicolon or a new line. A property's "
       "name and its value are separated by a colon.",
       "sphere { radius 2 }", "sphere { radius: 2 }"},
      {"E0103", "A bracket is not closed",
       "Every `(`, `[` and `{` needs its partner. The message points at the bracket that was opened; for braces "
       "the indentation of the lines helps to tell which one was forgotten.",
       "sphere { at: [1, 2, 3 }", "sphere { at: [1, 2, 3] }"},
      {"E0104", "An unmatched closing bracket",
       "This bracket closes nothing, or a bracket of another kind is open. Look for a bracket too many, or for "
       "one of the wrong kind.",
       "sphere { at: [1, 2, 3) }", "sphere { at: [1, 2, 3] }"},
      {"E0105", "A string is not closed",
       "A string begins and ends with `\"` on the same line. A line break inside a string is written `\\n`.",
       "sphere { name: \"ball }", "sphere { name: \"ball\" }"},
      {"E0106", "A comment is not closed",
       "A comment that begins with `/*` ends with `*/`. For the rest of a line, `//` is simpler.",
       "sphere {} /* the ball", "sphere {} // the ball"},
      {"E0107", "An escape in a string has no meaning",
       "In a string, `\\n` is a line break, `\\t` a tabulator, `\\\"` a quotation mark, `\\\\` a backslash, and "
       "`\\u{e9}` the character with that hexadecimal number in Unicode. Nothing else may follow a backslash.",
       "sphere { name: \"a\\b\" }", "sphere { name: \"a\\\\b\" }"},
      {"E0108", "A number is not well formed",
       "A number has one decimal point at most, and digits after the `e` of an exponent: `0.5`, `.5`, `5.`, `2e-3`. "
       "`0..5` is a range.",
       "sphere { radius: 1.2.5 }", "sphere { radius: 1.25 }"},
      {"E0109", "There is no such unit",
       "Lengths have no unit. Angles are in degrees, and only they may say so: `30deg`, or converted from "
       "`0.5rad` and `0.25turn`. The unit touches the number.",
       "sphere { radius: 2cm }", "sphere { radius: 2 }"},
      {"E0110", "Numbers are written in decimal",
       "There are no hexadecimal, binary or octal numbers and no `_` between digits. A colour is written "
       "`#ff8800`.",
       "sphere { radius: 0x10 }", "sphere { radius: 16 }"},
      {"E0111", "A colour literal is not well formed",
       "After `#` stand three or six hexadecimal digits: `#f80` is short for `#ff8800`. They are red, green and "
       "blue in sRGB.",
       "background: #12345", "background: #123456"},
      {"E0112", "`#` does not begin a comment",
       "`#` begins a colour. A comment begins with `//` and goes to the end of its line, or stands between `/*` "
       "and `*/`.",
       "# the ball\n"
       "sphere {}",
       "// the ball\n"
       "sphere {}"},
      {"E0113", "Strings are written in double quotes", "Single quotes have no meaning in a scene.",
       "sphere { name: 'ball' }", "sphere { name: \"ball\" }"},
      {"E0114", "A line begins with an operator",
       "A new line begins a new item, so a line that begins with an operator has lost what stands on the "
       "operator's left. To continue an expression, end the line with the operator. A line may begin with `.`: "
       "it continues the thing before it.",
       "x = 1\n"
       "  + 2\n"
       "sphere { radius: x }",
       "x = 1 +\n"
       "  2\n"
       "sphere { radius: x }"},
      {"E0115", "A line begins with a brace",
       "The `{` of a block stands on the line of what it belongs to, because a new line begins a new item.",
       "sphere\n"
       "{\n"
       "  radius: 2\n"
       "}",
       "sphere {\n"
       "  radius: 2\n"
       "}"},
      {"E0116", "An `else` is not on the line of its `if` block's brace",
       "`else` stands on the line of the brace that closes the block before it, because a new line begins a new "
       "item.",
       "big = true\n"
       "if big { sphere { radius: 2 } }\n"
       "else { sphere {} }",
       "big = true\n"
       "if big { sphere { radius: 2 } } else { sphere {} }"},
      {"E0117", "Comparisons and ranges do not chain",
       "`a < b < c` compares the outcome of `a < b`, which is no number, with `c`. Join two comparisons with "
       "`and`. A range has two ends, and its step follows `by`.",
       "r = 2\n"
       "if 1 < r < 3 { sphere { radius: r } }",
       "r = 2\n"
       "if 1 < r and r < 3 { sphere { radius: r } }"},
      {"E0118", "`=` stands inside an expression",
       "`=` binds a name at the start of a line. Two values are compared with `==`.",
       "r = 2\n"
       "if r = 2 { sphere { radius: r } }",
       "r = 2\n"
       "if r == 2 { sphere { radius: r } }"},
      {"E0119", "An operator of another language",
       "The logical operators are `and`, `or` and `not`; a power is `a ^ b`; `if a { b } else { c }` chooses "
       "between two values. A name keeps its value, so nothing like `+=` or `++` exists.",
       "a = true\n"
       "b = false\n"
       "if a && b { sphere {} }",
       "a = true\n"
       "b = false\n"
       "if a and b { sphere {} }"},
      {"E0120", "A reserved word is used as a name",
       "These words belong to the language and cannot name anything: and, or, not, if, else, for, in, by, def, "
       "fn, use, as, include, param, true, false, none, expect.",
       "by = 3\n"
       "sphere { radius: by }",
       "step = 3\n"
       "sphere { radius: step }"},
      {"E0121", "A statement of another language",
       "A name is bound with `name = value`, a noun is declared with `def`, a function with `fn`, and `for x in "
       "xs { … }` goes through the elements of a list or a range. There are no other statements, and no "
       "directives.",
       "let r = 2\n"
       "sphere { radius: r }",
       "r = 2\n"
       "sphere { radius: r }"},
      {"E0122", "There is nothing between two separators",
       "One comma, semicolon or new line separates two items. A comma after the last one is fine.",
       "sphere { at: [1,, 2, 3] }", "sphere { at: [1, 2, 3] }"},
      {"E0123", "A character has no meaning",
       "Outside of strings and comments a scene is made of letters without accents, digits, `_`, brackets and "
       "operators. Text from a word processor may hold typographic quotes, dashes and spaces that look right and "
       "are not.",
       "sphere { radius: 3 × 2 }", "sphere { radius: 3 * 2 }"},
      {"E0124", "The file is not UTF-8",
       "A scene is a text in the encoding UTF-8. The message names the first byte that is not. Editors call the "
       "setting `encoding`.",
       "", ""},
      {"E0125", "Nested too deeply",
       "Brackets within brackets, or operators within operators, are limited in depth, because they are "
       "evaluated one within another. Give inner parts names; join many solids with `union { … }` in place of a "
       "long chain of `|`.",
       "", ""},
      {"E0126", "A block is missing",
       "`for`, `if`, `else` and `def` are followed by a block in braces, even if it holds one item only.",
       "for x in 0..3\n"
       "sphere {}",
       "for x in 0..3 { sphere { at: [x, 0, 0] } }"},
      {"E0127", "A name is missing",
       "A property, a binding, a declaration and the part after a dot are names: a letter or `_`, then letters, "
       "digits and `_`.",
       "def (width) { box { size: width } }",
       "def cube(width) { box { size: width } }\n"
       "cube { width: 2 }"},
      {"E0128", "`in` is missing",
       "`for x in xs { … }` goes through the elements of a list or a range; `for i, x in xs { … }` counts them "
       "as well.",
       "for x of [1, 2] { sphere { radius: x } }", "for x in [1, 2] { sphere { radius: x } }"},
      {"E0129", "`=>` cannot follow a function's name",
       "A function inside an expression has no name and an arrow: `fn (x) => x * x`. A declared function has a "
       "name and `=`, or a block: `fn square(x) = x * x`.",
       "square = (x) => x * x\n"
       "sphere { radius: square(2) }",
       "fn square(x) = x * x\n"
       "sphere { radius: square(2) }"},
      {"E0130", "The parameters are missing",
       "After the name of a `def` or `fn` stand its parameters in parentheses, `()` if there are none.",
       "def ball { sphere {} }\n"
       "ball {}",
       "def ball() { sphere {} }\n"
       "ball {}"},
      {"E0131", "`not` follows an operator of higher precedence",
       "`not` binds looser than comparisons and arithmetic, as in \"not equal to\": `not a == b` is `not (a == "
       "b)`. After such an operator it stands in parentheses.",
       "a = true\n"
       "if a == not false { sphere {} }",
       "a = true\n"
       "if a == (not false) { sphere {} }"},
      {"E0132", "A record contains properties only",
       "`{ name: value }` on its own is a record: names with values. A list is written in square brackets.",
       "point = { x: 1, 2 }\n"
       "sphere { radius: point.x }",
       "point = { x: 1, y: 2 }\n"
       "sphere { radius: point.x }"},
      {"E0133", "A function's value is missing",
       "After its parameters a function gives its value: `= value`, or a block of bindings whose last line is "
       "the value.",
       "fn square(x)\n"
       "sphere {}",
       "fn square(x) = x * x\n"
       "sphere { radius: square(2) }"},
      {"E0134", "An `include`, `use` or `param` is incomplete",
       "`include \"file.rtl\"` puts a file's items here, `use \"file.rtl\" as name` makes its names available as "
       "`name.something`, and `param name = value` declares a value that the command line may change.",
       "param radius\n"
       "sphere { radius: radius }",
       "param r = 2\n"
       "sphere { radius: r }"},
      {"E0135", "A vector is written in square brackets",
       "`[x, y, z]` is a vector. Parentheses hold one value, and angle brackets compare. What POV-Ray puts behind a "
       "brace, `sphere { <0, 1, 0>, 2 }` or `plane { y, 0 }`, has names here.",
       "sphere { at: (1, 2, 3) }", "sphere { at: [1, 2, 3] }"},
      {"E0136", "An `if` or `fn` inside an expression needs parentheses",
       "An `if` or a function stands alone as a value, `x = if a { 1 } else { 2 }`; beside an operator it stands "
       "in parentheses, so that it is plain where it ends.",
       "a = true\n"
       "r = 1 + if a { 1 } else { 2 }\n"
       "sphere { radius: r }",
       "a = true\n"
       "r = 1 + (if a { 1 } else { 2 })\n"
       "sphere { radius: r }"},
      {"E0137", "`=` and `:` are exchanged",
       "A parameter's default is written with `=`, because it is bound; an argument is named with `:`, as a "
       "property is.",
       "def ball(r: 1) { sphere { radius: r } }\n"
       "ball {}",
       "def ball(r = 1) { sphere { radius: r } }\n"
       "ball {}"},
      {"E0138", "`by` without a range", "`by` gives the step of a range: `0..10 by 2` is 0, 2, 4, 6, 8, 10.",
       "for x in [1, 2, 3] by 2 { sphere { radius: x } }", "for x in 1..3 by 2 { sphere { radius: x } }"},
      {"E0139", "An `expect` is malformed",
       "`expect query hits thing at t value within tolerance`, `expect query misses thing`, `expect value ~ value "
       "within "
       "tolerance` and `expect condition` are what can be expected; `at t`, `within` and what stands after `misses` "
       "may be left out.",
       "ball = sphere {}\n"
       "expect ray([0, 0, 5], [0, 0, -1], ball) hits ball at 4\n"
       "ball",
       "ball = sphere {}\n"
       "expect ray([0, 0, 5], [0, 0, -1], ball) hits ball at t 4\n"
       "ball"},
  };
  return table;
}

} // namespace rt::lang::codes
