#include "tools/preview/window.hpp"

namespace rt::tools::preview {

void show_window(std::unique_ptr<live::Document>, const WindowHost&) {
  throw NoWindow("this build has no window: install libsdl2-dev and build again, or render with `rtlang SCENE -o "
                 "picture.png`");
}

} // namespace rt::tools::preview
