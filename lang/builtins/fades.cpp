#include "lang/builtins/builtins.hpp"

namespace rt::lang::builtins {
namespace {

template <scene::Fade::Law law>
Value fade(BuiltinCall& c) {
  const double d = c.number(0);
  if (check(scene::positive, d))
    return c.fail(0, "the distance of a fade must be greater than 0", "this is " + format_number(d));
  return scene::Fade{law, d};
}

} // namespace

std::span<const Builtin> fades() {
  using Law = scene::Fade::Law;
  static constexpr Builtin table[] = {
      {"linear", "d: number", "for `fade`: 1 / (1 + D/d) at distance D", fade<Law::linear>},
      {"quadratic", "d: number", "for `fade`: 1 / (1 + (D/d)^2) at distance D", fade<Law::quadratic>},
  };
  return table;
}

} // namespace rt::lang::builtins
