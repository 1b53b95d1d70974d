#include "lang/builtins/builtins.hpp"

#include <numbers>

namespace rt::lang {

std::span<const BuiltinGroup> builtin_groups() {
  static const BuiltinGroup groups[] = {
      {"Numbers", builtins::maths()},
      {"Vectors", builtins::vectors()},
      {"Geometry and matrices", builtins::geometry()},
      {"Lists and text", builtins::lists()},
      {"Colours", builtins::colors()},
      {"Chance", builtins::randoms()},
      {"Fades of light", builtins::fades()},
  };
  return groups;
}

std::span<const Constant> constants() {
  static constexpr Constant table[] = {
      {"pi", "3.141592653589793", "half the circumference of the unit circle", [] { return Value(std::numbers::pi); }},
      {"tau", "6.283185307179586", "the circumference of the unit circle", [] { return Value(2 * std::numbers::pi); }},
      {"e", "2.718281828459045", "the base of natural logarithms", [] { return Value(std::numbers::e); }},
      {"inverse_square", "", "for `fade`: 1 / D^2 at distance D",
       [] {
         return Value(scene::Fade{scene::Fade::Law::inverse_square, 1});
       }},
  };
  return table;
}

std::span<const Builtin* const> all_builtins() {
  static const std::vector<const Builtin*> all = [] {
    std::vector<const Builtin*> rows;
    for (const BuiltinGroup& group : builtin_groups()) {
      for (const Builtin& row : group.rows) rows.push_back(&row);
    }
    return rows;
  }();
  return all;
}

std::optional<std::size_t> find_builtin(std::string_view name) {
  const auto all = all_builtins();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i]->name == name) return i;
  }
  return std::nullopt;
}

const Constant* find_constant(std::string_view name) {
  for (const Constant& row : constants()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

} // namespace rt::lang
