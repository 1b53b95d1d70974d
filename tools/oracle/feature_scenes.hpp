#pragma once

#include <string>
#include <vector>

namespace rt::tools::oracle {

/// A small scene that shows one feature of the language.
struct FeatureScene {
  std::string name; ///< also a file's name
  std::string text;
};

/// Each shape in each form, each solid operation, each term of a material alone and some together, each light and fade,
/// nested media, transforms, both cameras.
std::vector<FeatureScene> feature_scenes();

} // namespace rt::tools::oracle
