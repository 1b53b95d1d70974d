#pragma once

#include "tools/import/import.hpp"

namespace rt::tools::import {

/// A scene of the miniRT project of the 42 schools, in the form of 2021 and later or in the one before, which an `R`
/// line or small letters for camera and lamps tell. The older form's further cameras become comments.
Imported read_mini_rt(std::string text, const std::string& name, const Options& options);

} // namespace rt::tools::import
