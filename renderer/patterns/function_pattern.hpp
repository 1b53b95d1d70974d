#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Colours, or numbers as grey, computed from the point.
struct FunctionPattern {
  static constexpr std::string_view noun = "pattern";
  static constexpr std::string_view help = "what a function of the point gives: a colour, or a number as grey";
  FunctionRef function = constant_function(1);
};

std::span<const Field> fields(const FunctionPattern*);

} // namespace rt::scene

namespace rt {

/// What it shows at `p`, a point of its own space. Where the function has no value, a negative or an infinite one, that
/// is 0.
scene::Paint paint_at(const scene::FunctionPattern& pattern, const Vec3& p);

} // namespace rt
