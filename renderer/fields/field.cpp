#include "renderer/fields/field.hpp"

namespace rt::scene {

FunctionRef constant_function(double value) {
  return std::make_shared<const Function>(Function{3, {value}, {}, {}, {3}});
}

std::optional<Violation> detail::check_function(const FunctionRef& function) {
  if (function && function->input_count == 3 && is_well_formed(*function)) return std::nullopt;
  return Violation{Violation::Kind::not_finite, "must be a function of a point", "this is none"};
}

} // namespace rt::scene
