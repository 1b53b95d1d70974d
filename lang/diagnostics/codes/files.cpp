#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> files() {
  static const std::vector<Code> table = {
      {"E0601", "A file cannot be read",
       "`include` and `use` resolve a path relative to the file that contains them. The message says where this one "
       "was looked for, the system's error, and which file there has a similar name.",
       "include \"no_such_file.rtl\"\nsphere {}", "sphere {}"},
      {"E0602", "A file includes itself",
       "This file is being read already, directly or by way of another one. Put what both need into a third file.", "",
       ""},
      {"E0603", "A file is outside the scene's folder",
       "A scene reads files of its own folder and of the folders in it, so that a scene from elsewhere cannot look "
       "around. "
       "`--include-root FOLDER` allows another folder.",
       "include \"/etc/passwd\"\nsphere {}", "sphere {}"},
      {"E0604", "The command line sets a parameter that the scene does not have",
       "`-D name=value` sets a `param` of the scene. There is none of that name.", "", ""},
      {"E0605", "The command line gives a value of the wrong kind",
       "The value of `-D name=value` is of the kind of the `param`'s default. A string stands in quotes, which the "
       "shell must leave alone: -D 'title=\"north\"'.",
       "", ""},
      {"E0606", "A parameter is out of range",
       "`param n = 3 in 0..6` says what values make sense; the default and what the command line gives must lie there.",
       "param n = 9 in 0..6\nsphere { radius: n }", "param n = 3 in 0..6\nsphere { radius: n }"},
  };
  return table;
}

} // namespace rt::lang::codes
