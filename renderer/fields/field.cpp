#include "renderer/fields/field.hpp"

#include "renderer/math/format_number.hpp"

namespace rt::scene {

FunctionRef constant_function(double value) {
  return std::make_shared<const Function>(Function{3, {value}, {}, {}, {3}});
}

std::optional<Violation> detail::check_function(const FunctionRef& function) {
  if (function && function->input_count == 3 && is_well_formed(*function)) return std::nullopt;
  return Violation{Violation::Kind::not_finite, "must be a function of a point", "this is none"};
}

std::optional<Violation> detail::check_stops(const Stops& stops) {
  if (stops.empty()) return Violation{Violation::Kind::count, "must have a stop", "there is none"};
  const Constraint in_map{.min = 0, .max = 1};
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (const auto violation = check(in_map, stops[i].place))
      return Violation{violation->kind, "must have its places between 0 and 1", violation->found};
    if (i > 0 && stops[i].place < stops[i - 1].place)
      return Violation{Violation::Kind::out_of_bounds, "must have its stops in the order of their places",
                       format_number(stops[i].place) + " stands behind " + format_number(stops[i - 1].place)};
    const Color* color = std::get_if<Color>(&stops[i].shown);
    if (color)
      if (auto violation = check(not_negative, *color)) return violation;
  }
  return std::nullopt;
}

} // namespace rt::scene
