#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace rt::tools::bench {

/// What a tumbler of water costs by depth, and POV-Ray with its own pruning; `row` prints what it is told. Works in
/// `folder`, which must exist.
void measure_glass(const std::string& program, const std::string& folder,
                   const std::function<void(std::string_view what, std::string_view value)>& row);

} // namespace rt::tools::bench
