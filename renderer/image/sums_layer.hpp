#pragma once

#include "renderer/render/film.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// The sums of a film (`Film::sums`) as a layer of 32-bit integers, which any program can pass through.
namespace rt::image {

/// Per pixel: for each half its samples, and for each channel the four parts of a sum, the lowest first; then the
/// pixel's noise state.
using SumsWords = std::array<std::uint32_t, 2 * (1 + 3 * 4) + 1>;

/// The names of the words: "sums.A.samples", "sums.A.R0", …, "sums.noise".
const std::array<std::string, std::tuple_size_v<SumsWords>>& sums_channels();

std::vector<SumsWords> sums_words(const Film& film);
/// Sets a film's sums from its pixels' words.
void set_sums(Film& film, const std::vector<SumsWords>& words);

} // namespace rt::image
