#include "tools/terminal/version.hpp"

namespace rt::tools {

std::string_view version_number() {
  return RTLANG_VERSION;
}

} // namespace rt::tools
