#include "renderer/fields/constraint.hpp"

#include "renderer/math/format_number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::scene {
namespace {

using Violated = Violation::Kind;

std::string bounds_text(const Constraint& c) {
  const auto low = fmt::format("{} {}", c.min_is_excluded ? "greater than" : "at least", format_number(c.min));
  const auto high = fmt::format("{} {}", c.max_is_excluded ? "less than" : "at most", format_number(c.max));
  if (std::isinf(c.max)) return c.min == 0 && !c.min_is_excluded ? "must not be negative" : "must be " + low;
  if (std::isinf(c.min)) return "must be " + high;
  if (!c.min_is_excluded && !c.max_is_excluded)
    return fmt::format("must be from {} to {}", format_number(c.min), format_number(c.max));
  return fmt::format("must be {} and {}", low, high);
}

// The common case: a number strictly between its bounds is also finite.
bool is_inside(const Constraint& c, double number) {
  return number > c.min && number < c.max && !c.is_whole;
}

bool is_kept(const Constraint& c, double number) {
  if (is_inside(c, number)) return true;
  const bool is_low = c.min_is_excluded ? number <= c.min : number < c.min;
  const bool is_high = c.max_is_excluded ? number >= c.max : number > c.max;
  return std::isfinite(number) && !is_low && !is_high && (!c.is_whole || number == std::floor(number));
}

bool are_kept(const Constraint& c, double a, double b, double d) {
  return is_kept(c, a) && is_kept(c, b) && is_kept(c, d);
}

[[gnu::cold]] Violation broken(const Constraint& c, double number) {
  const std::string found = "this is " + format_number(number);
  if (!std::isfinite(number)) return {Violated::not_finite, "is not a finite number", found};
  Constraint bounds = c;
  bounds.is_whole = false;
  return {Violated::out_of_bounds, is_kept(bounds, number) ? "must be a whole number" : bounds_text(c), found};
}

[[gnu::cold]] Violation first_broken(const Constraint& c, double a, double b, double d) {
  return broken(c, !is_kept(c, a) ? a : !is_kept(c, b) ? b : d);
}

} // namespace

std::optional<Violation> check(const Constraint& constraint, double number) {
  if (!is_kept(constraint, number)) return broken(constraint, number);
  if (!constraint.is_nonzero || number != 0) return std::nullopt;
  return Violation{Violated::out_of_bounds, "must not be 0", "this is 0"};
}

std::optional<Violation> check(const Constraint& constraint, const Vec3& vector) {
  if (!are_kept(constraint, vector.x, vector.y, vector.z))
    return first_broken(constraint, vector.x, vector.y, vector.z);
  if (!constraint.is_nonzero || length(vector) != 0) return std::nullopt;
  return Violation{Violated::no_direction, "must have a direction", "this has length 0"};
}

std::optional<Violation> check_size(const Constraint& constraint, const Vec3& size) {
  if (!are_kept(constraint, size.x, size.y, size.z)) return first_broken(constraint, size.x, size.y, size.z);
  if (!constraint.is_nonzero || (size.x != 0 && size.y != 0 && size.z != 0)) return std::nullopt;
  return Violation{Violated::flattens, "must not be 0: that would flatten the thing", "this is 0"};
}

std::optional<Violation> check(const Constraint& constraint, const Color& color) {
  if (are_kept(constraint, color.r, color.g, color.b)) return std::nullopt;
  return first_broken(constraint, color.r, color.g, color.b);
}

std::optional<Violation> check_count(const Constraint& c, std::size_t count) {
  if (count >= static_cast<std::size_t>(c.min_count) && count <= static_cast<std::size_t>(c.max_count))
    return std::nullopt;
  return Violation{Violated::count,
                   c.min_count == c.max_count ? fmt::format("takes exactly {} points", c.min_count)
                                              : fmt::format("takes at least {} points", c.min_count),
                   fmt::format("this has {}", count)};
}

} // namespace rt::scene
