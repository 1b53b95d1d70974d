#include "tools/oracle/generate_functions.hpp"

#include "tools/oracle/scene_tree.hpp"

#include <fmt/format.h>

namespace rt::tools::oracle {
namespace {

std::string axis(Dice& dice) {
  return fmt::format("p.{}", "xyz"[dice.below(3)]);
}

// A few lengths across a shape, in the scene's unit.
std::string measure(Dice& dice) {
  const double scale = 1 / dice.length_unit;
  switch (dice.below(5)) {
  case 0: {
    const double sign = dice.sign(), factor = dice.between(0.7, 2.5), shift = dice.between(-1, 1);
    return fmt::format("({} * {} + {})", text(sign * factor * scale), axis(dice), text(shift));
  }
  case 1: {
    const Vec3 direction = dice.direction();
    return fmt::format("dot(p, {})", text(direction * (scale * dice.between(0.8, 2))));
  }
  case 2: {
    const Vec3 middle = dice.point(-0.6, 0.6);
    return fmt::format("({} * length(p - {}))", text(scale * dice.between(0.8, 2)), text(middle));
  }
  case 3: {
    const std::string first = axis(dice), second = axis(dice);
    return fmt::format("({0} * hypot({1}, {2}, {3}))", text(scale), first, second, text(dice.length(0.05, 0.5)));
  }
  default: {
    const std::string first = measure(dice), second = measure(dice);
    return fmt::format("({} {} {})", first, dice.chance(0.5) ? "+" : "-", second);
  }
  }
}

std::string share(Dice& dice, int depth);

// Of shares of 1, a share of 1.
std::string composition(Dice& dice, int depth) {
  const std::string a = share(dice, depth), b = share(dice, depth);
  switch (dice.below(9)) {
  case 0:
    return fmt::format("min({}, {})", a, b);
  case 1:
    return fmt::format("max({}, {})", a, b);
  case 2:
    return fmt::format("({} * {})", a, b);
  case 3:
    return fmt::format("mix({}, {}, {})", a, b, share(dice, depth));
  case 4:
    return fmt::format("sqrt({})", a);
  case 5:
    return fmt::format("({} ^ {})", a, text(dice.between(1, 3)));
  case 6: {
    const char* condition = dice.chance(0.5) ? "not ({} <= {})" : "({} < {} or p.x == 7)";
    return fmt::format("(if {} {{ {} }} else {{ {} }})", fmt::format(fmt::runtime(condition), measure(dice), "0.3"), a,
                       b);
  }
  case 7:
    return fmt::format("(sum([abs(cos(i * 70 * {})) * {} for i in 1..3]) / 3)", measure(dice), a);
  default:
    return fmt::format("(1 - abs({} - {}))", a, b);
  }
}

// A number between 0 and 1 that changes gently, but for a few edges.
std::string share(Dice& dice, int depth) {
  if (depth > 0 && dice.chance(0.5)) return composition(dice, depth - 1);
  const std::string u = measure(dice);
  switch (dice.below(9)) {
  case 0:
    return fmt::format("(0.5 + 0.5 * sin({} * {}))", text(dice.between(60, 300)), u);
  case 1: {
    const double low = dice.between(-0.5, 0), high = dice.between(0.3, 1);
    return fmt::format("smoothstep({}, {}, {})", text(low), text(high), u);
  }
  case 2:
    return fmt::format("clamp({})", u);
  case 3:
    return fmt::format("({} % 1)", u);
  case 4:
    return fmt::format("(1 / (1 + {} ^ 2))", u);
  case 5:
    return fmt::format("exp(-abs({}))", u);
  case 6:
    return fmt::format("(0.5 + atan2({}, {}) / 360)", u, measure(dice));
  case 7:
    return fmt::format("(acos(cos(100 * {})) / 180)", u);
  default:
    return fmt::format("clamp(log(1 + abs({})))", u);
  }
}

} // namespace

std::string random_number_function(Dice& dice, double low, double high) {
  return fmt::format("fn(p) => {} + {} * {}", text(low), text(high - low), share(dice, 2));
}

std::string random_color_function(Dice& dice) {
  const std::string a = share(dice, 2), b = share(dice, 1), c = share(dice, 1);
  switch (dice.below(5)) {
  case 0:
    return fmt::format("fn(p) => hsv(360 * {}, {}, {})", a, b, c);
  case 1:
    return fmt::format("fn(p) => rgb({}, {}, {})", a, b, c);
  case 2:
    return fmt::format("fn(p) => mix(teal, khaki, {}) * {}", a, b);
  case 3:
    return fmt::format("fn(p) => linear_rgb({}, {}, 2 * {})", a, b, c);
  default:
    return "fn(p) => " + a;
  }
}

} // namespace rt::tools::oracle
