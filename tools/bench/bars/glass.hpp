#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace rt::tools::bench {

/// Measures the cost of a glass of water by depth, and POV-Ray's with its own pruning; `row` prints a row. Works in
/// `folder`, which must exist.
void measure_glass(const std::string& program, const std::string& folder,
                   const std::function<void(std::string_view what, std::string_view value)>& row);

} // namespace rt::tools::bench
