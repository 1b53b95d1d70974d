#pragma once

#include "tools/import/import.hpp"

namespace rt::tools::import {

/// A scene of 42's miniRT project, in the format of 2021 and later or in the earlier one, recognised by an `R` line or
/// lower-case letters for camera and lamps. The earlier format's additional cameras become comments.
Imported read_mini_rt(std::string text, const std::string& name, const Options& options);

} // namespace rt::tools::import
