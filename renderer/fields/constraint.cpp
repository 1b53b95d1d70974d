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

bool are_within(const Constraint& c, double a, double b, double d) {
  return is_within(c, a) && is_within(c, b) && is_within(c, d);
}

[[gnu::cold]] Violation broken(const Constraint& c, double number) {
  const std::string found = "this is " + format_number(number);
  if (!std::isfinite(number)) return {Violated::not_finite, "is not a finite number", found};
  Constraint bounds = c;
  bounds.is_whole = false;
  return {Violated::out_of_bounds, is_within(bounds, number) ? "must be a whole number" : bounds_text(c), found};
}

[[gnu::cold]] Violation first_broken(const Constraint& c, double a, double b, double d) {
  return broken(c, !is_within(c, a) ? a : !is_within(c, b) ? b : d);
}

} // namespace

Violation violation_of(const Constraint& constraint, double number) {
  if (!is_within(constraint, number)) return broken(constraint, number);
  return {Violated::out_of_bounds, "must not be 0", "this is 0"};
}

std::optional<Violation> check(const Constraint& constraint, const Vec3& vector) {
  if (!are_within(constraint, vector.x, vector.y, vector.z))
    return first_broken(constraint, vector.x, vector.y, vector.z);
  if (!constraint.is_nonzero || length(vector) != 0) return std::nullopt;
  return Violation{Violated::no_direction, "must have a direction", "this has length 0"};
}

std::optional<Violation> check_size(const Constraint& constraint, const Vec3& size) {
  if (!are_within(constraint, size.x, size.y, size.z)) return first_broken(constraint, size.x, size.y, size.z);
  if (!constraint.is_nonzero || (size.x != 0 && size.y != 0 && size.z != 0)) return std::nullopt;
  return Violation{Violated::flattens, "must not be 0: that would flatten the thing", "this is 0"};
}

std::optional<Violation> check(const Constraint& constraint, const Color& color) {
  if (are_within(constraint, color.r, color.g, color.b)) return std::nullopt;
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
