#pragma once

#include "tools/povray/compare/compare.hpp"

#include <map>
#include <string>

/// Small pictures that POV-Ray rendered once, kept with the tests, so that ours are compared with them even without
/// POV-Ray.
namespace rt::tools::oracle {

/// Of the input given to POV-Ray: a different one means that a golden is out of date. 16 hexadecimal digits.
std::string export_hash(const scene::Scene& scene);

/// A picture's shots as one PNG file of 16 linear bits: the colours, below them the object ids, below them the
/// distances, both as POV-Ray packs them (`povray::decode_id`, `povray::decode_depth`). Throws std::runtime_error.
std::string encode_golden(const povray::Shots& shots);
/// Normals are not kept. `name` is for messages. Throws std::runtime_error if it is not such a file.
povray::Shots decode_golden(const std::string& bytes, const std::string& name);

/// The export hash of each golden by name, a line each: `name hash`.
using GoldenIndex = std::map<std::string, std::string>;
GoldenIndex read_index(const std::string& text);
std::string write_index(const GoldenIndex& index);

/// Distances to 1e-9, colours to one count of 16 bits, every other pixel explained. How many pixels must be equal
/// applies to all pictures together: 99.99 %.
povray::Gates golden_gates();
/// Renders the scene at the golden's size and compares it with the golden.
povray::Comparison compare_with_golden(const scene::Scene& scene, const povray::Shots& golden);

} // namespace rt::tools::oracle
