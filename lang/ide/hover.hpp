#pragma once

#include "lang/analyse.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace rt::lang {

/// What an editor shows about a name.
struct Hover {
  Span span;        ///< of the name
  std::string text; ///< its declaration and what is known about it, a few lines
};

/// For the name at a place (in it, or directly after it); nothing if there is none, or it refers to nothing. The
/// analysis must have kept its references.
std::optional<Hover> hover(const Analysis& analysis, FileId file, std::uint32_t place);

} // namespace rt::lang
