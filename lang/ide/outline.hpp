#pragma once

#include "lang/analyse.hpp"

#include <string>
#include <vector>

namespace rt::lang {

/// An item of a text, as an editor lists it.
struct OutlineEntry {
  enum class What : std::uint8_t { value, function, noun, module, parameter, property, thing };
  What what = What::value;
  std::string name;
  std::string detail;                 ///< the item's first line
  Span whole;                         ///< of the item
  Span name_span;                     ///< within it
  std::vector<OutlineEntry> children; ///< what is declared in it
};

/// What a file declares and places, in order: bindings, functions, nouns, params (`parameter`), the scene's properties,
/// and things by the noun or name that they begin with. The analysis must have kept its references.
std::vector<OutlineEntry> outline(const Analysis& analysis, FileId file);

} // namespace rt::lang
