#pragma once

#include "renderer/render/film.hpp"

namespace rt::tools {

/// The colour of an error on a logarithmic scale: black at 0, dark blue from 1e-8, through purple, red and yellow to
/// white at 1 and above. Linear light.
Rgb32 heat(double error);

/// A picture of a field of errors.
Film heat_map(const std::vector<float>& errors, int width, int height);

/// A film of linear colours without layers.
Film film_of(std::vector<Rgb32> color, int width, int height);

} // namespace rt::tools
