#pragma once

#include <string>

namespace rt {

/// The shortest text that reads back as the same number; "infinity", "not a number" and so on for what is none.
std::string format_number(double number);

} // namespace rt
