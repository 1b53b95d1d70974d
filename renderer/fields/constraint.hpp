#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace rt::scene {

/// What a field's numbers must satisfy (every component of a vector), or how many points it takes.
struct Constraint {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_is_excluded = false;
  bool max_is_excluded = false;
  bool is_whole = false;   ///< whole numbers only
  bool is_nonzero = false; ///< a vector must have a direction, a number must not be 0
  int min_count = 0;       ///< points
  int max_count = std::numeric_limits<int>::max();
};

inline constexpr Constraint any_value{};
inline constexpr Constraint positive{.min = 0, .min_is_excluded = true};
inline constexpr Constraint not_negative{.min = 0};
inline constexpr Constraint zero_to_one{.min = 0, .max = 1};
inline constexpr Constraint nonzero{.is_nonzero = true};

/// How a value violates a constraint. No number may be infinite or NaN, whatever the constraint.
struct Violation {
  enum class Kind : std::uint8_t { not_finite, out_of_bounds, no_direction, flattens, count };
  Kind kind;
  std::string rule;  ///< a sentence behind the field's name: "must be greater than 0"
  std::string found; ///< "this is -1"
};

/// Whether a number is finite, within the bounds, and whole where it must be.
inline bool is_within(const Constraint& c, double number) {
  if (number > c.min && number < c.max && !c.is_whole) return true; // the common case: it is also finite
  const bool is_low = c.min_is_excluded ? number <= c.min : number < c.min;
  const bool is_high = c.max_is_excluded ? number >= c.max : number > c.max;
  return std::isfinite(number) && !is_low && !is_high && (!c.is_whole || number == std::floor(number));
}

/// How a number that violates it does.
Violation violation_of(const Constraint& constraint, double number);

inline std::optional<Violation> check(const Constraint& constraint, double number) {
  if (is_within(constraint, number) && (!constraint.is_nonzero || number != 0)) return std::nullopt;
  return violation_of(constraint, number);
}
std::optional<Violation> check(const Constraint& constraint, const Vec3& vector);
std::optional<Violation> check(const Constraint& constraint, const Color& color);
/// For a vector with a factor for each axis.
std::optional<Violation> check_size(const Constraint& constraint, const Vec3& size);
/// For a list of points: their number.
std::optional<Violation> check_count(const Constraint& constraint, std::size_t count);

} // namespace rt::scene
