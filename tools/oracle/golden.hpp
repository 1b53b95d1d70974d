#pragma once

#include "tools/povray/compare/compare.hpp"

#include <map>
#include <string>

/// Small pictures that POV-Ray made once, kept with the tests, so that ours are compared with them also where there is
/// no POV-Ray.
namespace rt::tools::oracle {

/// Of the texts that POV-Ray gets: another one means that a kept picture is out of date. 16 hexadecimal digits.
std::string export_hash(const scene::Scene& scene);

/// A picture's shots as one PNG file of 16 linear bits: the colours, below them the objects' numbers, below them the
/// distances, as POV-Ray packs both (`povray::decode_id`, `povray::decode_depth`). Throws std::runtime_error.
std::string encode_golden(const povray::Shots& shots);
/// Normals are not kept. `name` is for messages. Throws std::runtime_error for what is no such file.
povray::Shots decode_golden(const std::string& bytes, const std::string& name);

/// The hashes of the kept pictures' exports by their names, a line each: `name hash`.
using GoldenIndex = std::map<std::string, std::string>;
GoldenIndex read_index(const std::string& text);
std::string write_index(const GoldenIndex& index);

/// Distances to 1e-9, colours to one count of 16 bits, every other pixel explained. How many pixels have to be equal is
/// a question to all pictures together: 99.99 %.
povray::Gates golden_gates();
/// Our picture of the scene, in the kept one's size, against the kept one.
povray::Comparison compare_with_golden(const scene::Scene& scene, const povray::Shots& golden);

} // namespace rt::tools::oracle
