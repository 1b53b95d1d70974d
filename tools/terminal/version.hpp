#pragma once

#include <string_view>

namespace rt::tools {

/// The program's version, "0.1.0".
std::string_view version_number();

} // namespace rt::tools
