#pragma once

#include "renderer/scene/pattern.hpp"

#include <string>
#include <vector>

/// Patterns in POV-Ray's words.
namespace rt::tools::povray {

/// A pattern of POV-Ray's: a list of pigments or textures, or a number from 0 to 1 and a map from it to them.
struct PatternText {
  struct Part {
    double place = 0; ///< in the map
    scene::FieldValue shown;
  };
  std::vector<std::string> declared = {}; ///< functions that the head calls: `f1 = function(u) { … }`
  std::string head = {};                  ///< what kind it is
  bool is_list = false;
  std::vector<Part> parts = {};
  std::string tail = {}; ///< what POV-Ray wants to read behind a list
  bool is_mixed = false; ///< the map gives mixtures of its parts
};

/// Of one that is no function; `inexact` gets what POV-Ray has otherwise.
PatternText pattern_text(const scene::PatternLayout& layout, std::vector<std::string>& inexact);

} // namespace rt::tools::povray
