#pragma once

#include <string>

namespace rt {

/// The shortest text that reads back as the same number; "infinity", "not a number" and so on if it is not finite.
std::string format_number(double number);

} // namespace rt
