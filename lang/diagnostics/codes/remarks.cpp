#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> remarks() {
  static const std::vector<Code> table = {
      {"N0001", "A camera was assumed",
       "The scene has no camera, so that one was framed on what can be seen, from three-quarters above. `rtlang scene` "
       "shows "
       "where it stands; written out, it is a good start for one of your own.",
       "sphere {}\nambient: 1", "sphere {}\nambient: 1\ncamera { at: [0, 1, 6] }"},
      {"N0002", "A light was assumed",
       "The scene has no light, and `ambient` is not written either, so that a sun was added. To have none, write "
       "`ambient`.",
       "sphere {}\ncamera { at: [0, 1, 6] }", "sphere {}\ncamera { at: [0, 1, 6] }\nsun { direction: [-1, -2, -1.5] }"},
      {"N0003", "A range is empty",
       "A range runs upwards unless its step is negative, so this one has no elements. If it is to count down, write "
       "`by -1`; if it may be empty, nothing is wrong.",
       "for i in 3..1 { sphere { at: [i, 0, 0] } }\nsphere {}",
       "for i in 3..1 by -1 { sphere { at: [i, 0, 0] } }\nsphere {}"},
      {"N0004", "Something is printed",
       "`print(x)` writes the value and the place to standard error each time it is evaluated, and places nothing. "
       "It is there for trying things out.",
       "print(2 + 3)\nsphere {}", "sphere {}"},
      {"N0005", "A comment that looks like a division",
       "`//` begins a comment, so that `7 // 2` is 7. `floor(a / b)` divides and rounds down.",
       "r = 7 // 2\nsphere { radius: r }", "r = floor(7 / 2)\nsphere { radius: r }"},
  };
  return table;
}

} // namespace rt::lang::codes
