#include "tools/preview/window.hpp"

namespace rt::tools::preview {

std::string_view window_help() {
  return "arrows, left drag        orbit the camera around its target\n"
         "shift+arrows, right drag pan\n"
         "+, -, wheel              zoom in, out\n"
         "r                        back to the scene's camera\n"
         "c                        prints the camera as it would be written\n"
         "p, click                 prints what is under the pointer (`rtlang probe`)\n"
         "w                        explains its colour (`rtlang why`)\n"
         "s                        saves the picture\n"
         "h                        prints this\n"
         "Escape, q                closes the window\n";
}

} // namespace rt::tools::preview
