#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> imports() {
  static const std::vector<Code> table = {
      {"E0801", "A line of another program's scene is malformed",
       "The file's format says how many fields the element on this line has, what each of them holds, and within which "
       "bounds. Every field that does not keep to that is reported, and nothing is drawn.",
       "", ""},
      {"E0802", "An element that another program's format does not have",
       "The word at the beginning of the line names no element of the format, or one of another version of it. With "
       "`--lenient` the common ones among them are taken, and lines with others are left out.",
       "", ""},
      {"E0803", "An element of another program's scene is missing or duplicated",
       "The format says how many elements of this kind a file has.", "", ""},
      {"N0801", "Part of another program's scene is interpreted differently",
       "The format allows this, but it cannot be represented exactly, or other programs interpret it differently. The "
       "message says how it was interpreted.",
       "", ""},
  };
  return table;
}

} // namespace rt::lang::codes
