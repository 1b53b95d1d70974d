#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> limits() {
  static const std::vector<Code> table = {
      {"E0501", "The scene takes too many steps",
       "Each placed thing, each loop iteration and each call is a step, and their number is limited so that a mistake "
       "ends. If "
       "the scene is meant to be that large, `--max-steps` allows more.",
       "for i in 0..<1e12 { sphere { at: [i, 0, 0] } }", "for i in 0..<12 { sphere { at: [i, 0, 0] } }"},
      {"E0502", "Calls are nested too deeply",
       "A function or `def` that calls itself needs a condition under which it stops. The notes show the calls that "
       "led "
       "here. `--max-recursion` allows more of them.",
       "fn down(n) = down(n - 1)\nsphere { radius: down(3) }",
       "fn down(n) = if n > 0 { down(n - 1) } else { 1 }\nsphere { radius: down(3) }"},
      {"E0503", "The scene has too many objects",
       "Placed objects are counted, those of a group only once however often the group is placed. "
       "`--max-objects` allows more.",
       "", ""},
      {"E0504", "The scene takes too much memory",
       "Lists, strings and things that are kept take memory, and its amount is bounded. `--max-memory` allows more.",
       "", ""},
      {"E0505", "Reading the scene was stopped",
       "It was ended from outside, by Ctrl-C for instance, before the scene was complete.", "", ""},
      {"E0506", "Things are nested too deeply",
       "A thing within a thing within a thing, more than a thousand levels deep, is almost certainly a mistake. "
       "To put many things together, place them in one group, or keep them in one list.",
       "chain = fold(fn(inner, i) => group { inner }, sphere {}, 0..2000)\nchain",
       "group { for i in 0..2000 { sphere { at: [3 * i, 0, 0] } } }"},
      {"E0507", "A function of the point is too long",
       "A function that a pattern is made of is compiled for the renderer: calls are written out, and loops turn by "
       "turn. "
       "The result may have 65,536 instructions.",
       "ball = sphere {}\nball { material: fn(p) => sum([sin(i * p.x) for i in 0..40000]) }",
       "ball = sphere {}\nball { material: fn(p) => sum([sin(i * p.x) for i in 0..40]) }"},
  };
  return table;
}

} // namespace rt::lang::codes
