#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// What all lamps share.
struct LightCommon {
  Color color = white;
  double intensity = 1;
  bool shadows = true; ///< false: nothing blocks it, and it gives diffuse light only
};

/// The rows of the field table that several kinds of light share.
template <class L>
inline constexpr Field color_field = field<&L::color>("color", {"white", "colour of the light", not_negative});
template <class L>
inline constexpr Field intensity_field = field<&L::intensity>("intensity", {"1", "factor on the colour", not_negative});
template <class L>
inline constexpr Field
    shadows_field = field<&L::shadows>("shadows", {"true", "false: it casts no shadows and makes no highlights"});
template <class L>
inline constexpr Field fade_field =
    field<&L::fade>("fade", {"none", "attenuation with distance: linear(d), quadratic(d) or inverse_square"});
template <class L>
inline constexpr Field radius_field = field<&L::radius>(
    "radius", {"0", "in path mode: radius of the lamp as a sphere; softens shadows without changing the brightness",
               not_negative});

} // namespace rt::scene

namespace rt {

/// A light as one point of the scene sees it, before shadows.
struct LightSample {
  Vec3 to_light;   ///< unit
  double distance; ///< to the light; infinite for a sun
  double fade = 1; ///< the attenuation with distance
  double spot = 1; ///< 0 outside a spot's cone, 1 in its full light and for all other lights
  Color color{};   ///< of the light that arrives if nothing is in the way: color · intensity · fade · spot
};

/// Where a light is, and how large in path mode. Each emitter has an overload of `extent`.
struct LightExtent {
  bool is_infinitely_far;
  Vec3 place;      ///< its middle; of one infinitely far away the direction to it (unit)
  double size = 0; ///< the radius of the ball that it is, or 1 − cos of half the angle that it is seen at; 0: none
};

/// What is left of light at a distance.
double fade_at(const scene::Fade& fade, double distance);

/// For a light at `at`, seen from `p`. If both are the same point, `distance` is 0 and the rest is
/// meaningless.
inline LightSample sample_from(const Vec3& at, const scene::Fade& fade, const Vec3& p) {
  const Vec3 way = at - p;
  const double distance = length(way);
  return {way / distance, distance, fade.law == scene::Fade::Law::none ? 1 : fade_at(fade, distance)};
}

} // namespace rt
