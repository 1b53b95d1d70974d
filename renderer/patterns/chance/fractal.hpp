#pragma once

#include "renderer/patterns/graded/graded.hpp"

#include <cstddef>
#include <iterator>
#include <utility>

namespace rt::scene {

/// What all patterns share that are made of noise, summed up in octaves, each of which is `lacunarity` times finer and
/// `gain` times as strong as the one before (the terms are F. K. Musgrave's, in D. S. Ebert et al., Texturing and
/// Modeling: A Procedural Approach).
struct Fractal : Graded {
  int seed = 0;
  int octaves = 4;
  double lacunarity = 2, gain = 0.5;
};

/// The rows of such a pattern's table that all have.
inline constexpr Field fractal_fields[] = {
    field<&Fractal::seed>("seed", {"0", "another number: another noise", {.is_whole = true}}),
    field<&Fractal::octaves>("octaves",
                             {"4", "noises, each finer than the one before", {.min = 1, .max = 32, .is_whole = true}}),
    field<&Fractal::lacunarity>("lacunarity", {"2", "how much finer", positive}),
    field<&Fractal::gain>("gain", {"0.5", "and how much weaker", not_negative}),
};

/// A table of own rows and those that all have.
template <std::size_t N>
constexpr auto with_fractal(const Field (&own)[N]) {
  constexpr std::size_t shared = std::size(fractal_fields);
  return [&]<std::size_t... I, std::size_t... J>(std::index_sequence<I...>, std::index_sequence<J...>) {
    const Field rows[] = {own[I]..., fractal_fields[J]...};
    return with_graded(rows);
  }
  (std::make_index_sequence<N>(), std::make_index_sequence<shared>());
}

} // namespace rt::scene

namespace rt {

/// Σ gainⁱ n(lacunarityⁱ p) / Σ gainⁱ over the octaves i, n being `gradient_noise`: from −1 to 1. The seed of an octave
/// is `mixed_seed` of the pattern's, the channel's and its own number: channels have nothing to do with each other.
double fractal_noise(const scene::Fractal& pattern, const Vec3& p, int channel = 0);
/// The same of |n|: from 0 to 1 (K. Perlin, An Image Synthesizer, SIGGRAPH 1985).
double turbulence(const scene::Fractal& pattern, const Vec3& p);

} // namespace rt
