#pragma once

#include <string_view>

namespace rt::lang {

/// The standard library: `library/materials.rtl`, compiled in. Its names are in a scope around every scene.
std::string_view library_text();
inline constexpr std::string_view library_name = "standard library";

} // namespace rt::lang
