#pragma once

#include "renderer/fields/field.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

namespace rt::scene {

/// How a number from 0 to 1 runs through the stops: as it is; up and down again; the same along a sine; half a sine;
/// slowly off and slowly on. POV-Ray's ramp_wave, triangle_wave, sine_wave, scallop_wave and cubic_wave.
enum class Wave : std::uint8_t { ramp, triangle, sine, scallop, cubic };

/// What all patterns share that make a number of the point, which stops make a colour of, or a number.
struct Graded {
  Stops stops{{0, black}, {1, white}};
  bool stepped = false;
  double frequency = 1, phase = 0;
  Wave wave = Wave::ramp;
  double exponent = 1;
};

template <class P>
concept IsGraded = std::derived_from<P, Graded>;

inline constexpr std::string_view wave_names[] = {"ramp", "triangle", "sine", "scallop", "cubic"};

/// The rows of a graded pattern's table that all have.
inline constexpr std::array graded_fields{
    field<&Graded::stops>("stops", {"[[0, black], [1, white]]", "[place, what is shown there], by places from 0 to 1"}),
    field<&Graded::stepped>("stepped", {"false", "true: what a stop shows holds up to the next"}),
    field<&Graded::frequency>("frequency", {"1", "how often the pattern runs through its stops"}),
    field<&Graded::phase>("phase", {"0", "moved along the stops, 1 is once through all"}),
    field<&Graded::wave>("wave", {.default_text = "ramp", .help = "how it runs through them", .choices = wave_names}),
    field<&Graded::exponent>("exponent", {"1", "the place in them is raised to it", positive}),
};

/// A table of own rows and those that all have.
template <std::size_t N>
constexpr std::array<Field, N + graded_fields.size()> with_graded(const Field (&own)[N]) {
  return [&]<std::size_t... I, std::size_t... J>(std::index_sequence<I...>, std::index_sequence<J...>) {
    return std::array{own[I]..., graded_fields[J]...};
  }
  (std::make_index_sequence<N>(), std::make_index_sequence<graded_fields.size()>());
}

} // namespace rt::scene

namespace rt {

/// What a pattern shows between two paints: (1 − share) of the first and `share` of the second.
struct PaintBlend {
  scene::Paint first, second;
  double share = 0;
};

/// Within one period, from 0 to 1. What is beyond begins anew; a period ends with 1, and 0 is where the first begins.
double within_period(double x);

/// Where in the stops a pattern's value, from 0 to 1, is: frequency and phase, wave form, exponent.
double place_in_stops(const scene::Graded& pattern, double value);
/// What the stops show at a place, which is held between the first and the last.
PaintBlend blend_at(const scene::Graded& pattern, double place);

/// What it shows at `p`, a point of its own space, by its `value_at`, which gives 0 to 1.
template <scene::IsGraded P>
PaintBlend paint_at(const P& pattern, const Vec3& p) {
  return blend_at(pattern, place_in_stops(pattern, value_at(pattern, p)));
}

} // namespace rt
