#include "tools/povray/export/export_pattern.hpp"

#include "tools/povray/export/sdl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

FieldValue shown(const Paint& paint) {
  return std::visit([](const auto& one) -> FieldValue { return one; }, paint);
}

PatternText list(std::string head, std::initializer_list<Paint> paints, std::string tail = {}) {
  PatternText text{.head = std::move(head), .is_list = true, .tail = std::move(tail)};
  for (const Paint& paint : paints) text.parts.push_back({0, shown(paint)});
  return text;
}

// `choice` is the number of a paint.
PatternText chosen(const std::string& choice, std::initializer_list<Paint> paints) {
  const double last = static_cast<double>(paints.size()) - 1;
  PatternText text{.head = fmt::format("function {{ ({}) / {} }}", choice, number(last))};
  double i = 0;
  for (const Paint& paint : paints) {
    for (const double place : {(i - 0.5) / last, (i + 0.5) / last})
      if (place > 0 && place < 1) text.parts.push_back({place, shown(paint)});
    ++i;
  }
  return text;
}

// A coordinate less the whole number below it, with the shift that keeps a surface at a whole number stable.
std::string fraction(char coordinate) {
  return fmt::format("({0} + 1e-10 - floor({0} + 1e-10))", coordinate);
}

PatternText text_of(const Checker& p) {
  return list("checker", {p.a, p.b});
}

PatternText text_of(const Stripes& p) {
  return chosen(fmt::format("select({} - {}, 0, 1)", fraction('x'), number(p.width)), {p.a, p.b});
}

PatternText text_of(const Tiles& p) {
  return chosen(fmt::format("select(max({}, {}, {}) - {}, abs(mod(floor(x + 1e-10) + floor(y + 1e-10) + "
                            "floor(z + 1e-10), 2)), 2)",
                            fraction('x'), fraction('y'), fraction('z'), number(1 - p.joint)),
                {p.a, p.b, p.mortar});
}

PatternText text_of(const Brick& p) {
  return list("brick", {p.mortar, p.color}, fmt::format("brick_size {} mortar {}", vector(p.size), number(p.joint)));
}

PatternText text_of(const Hexagon& p) {
  return list("hexagon", {p.a, p.b, p.c});
}

PatternText text_of(const Dots& p) {
  const auto way = [](char c) { return fmt::format("pow({0} - floor({0} + 0.5), 2)", c); };
  return chosen(fmt::format("select(sqrt({} + {} + {}) - {}, 1, 0)", way('x'), way('y'), way('z'), number(p.radius)),
                {p.ground, p.color});
}

// The value of a graded pattern: a pattern of POV-Ray's, or an expression.
struct GradedValue {
  std::string pattern, expression;
  bool moves_point = false; ///< the pattern does, and POV-Ray shows the moved point to its parts too
};
GradedValue own(std::string pattern) {
  return {std::move(pattern), {}, false};
}
GradedValue moving(std::string pattern) {
  return {std::move(pattern), {}, true};
}
GradedValue computed(std::string expression) {
  return {{}, std::move(expression), false};
}

// POV-Ray's patterns begin anew after 1.00001: what is to begin anew after 1 is held by this function.
constexpr std::string_view within_period = "function(u) { select(u, u - floor(u), 0, u - ceil(u) + 1) }";
constexpr std::string_view turns_from_x = "atan2(-z, x) / 6.283185307179586";

GradedValue value_of(const Gradient& p) {
  switch (p.kind) {
  case Gradient::Kind::linear: {
    const Vec3 d = normalize(p.direction);
    const std::string way = fmt::format("{} * x + {} * y + {} * z", number(d.x), number(d.y), number(d.z));
    return computed(fmt::format(fmt::runtime(p.repeat ? "within_period({})" : "min(1, max(0, {}))"), way));
  }
  case Gradient::Kind::radial:
    return computed(fmt::format("within_period({})", turns_from_x));
  case Gradient::Kind::spherical:
    return own("spherical");
  case Gradient::Kind::cylindrical:
    return own("cylindrical");
  case Gradient::Kind::angular:
    return computed("atan2(sqrt(x * x + z * z), y) / 3.141592653589793");
  case Gradient::Kind::box:
    return own("boxed");
  }
  return computed("0");
}
GradedValue value_of(const Onion&) {
  return own("onion");
}
GradedValue value_of(const Rings&) {
  return computed("mod(sqrt(x * x + z * z), 1)");
}
GradedValue value_of(const Leopard&) {
  return own("leopard");
}
GradedValue value_of(const Spiral& p) {
  return computed(fmt::format("within_period({} * {} + sqrt(x * x + z * z))", p.arms, turns_from_x));
}
// Those by chance look alike.
GradedValue value_of(const Cells&) {
  return own("cells");
}
GradedValue value_of(const Noise&) {
  return own("bozo");
}
GradedValue value_of(const Turbulence&) {
  return own("wrinkles");
}
GradedValue value_of(const Marble& p) {
  return moving(fmt::format("marble triangle_wave turbulence {}", number(p.wander)));
}
GradedValue value_of(const Wood& p) {
  return moving(fmt::format("wood rotate 90 * x turbulence {}", number(p.wander)));
}
GradedValue value_of(const Granite&) {
  return own("granite");
}
GradedValue value_of(const Agate& p) {
  return moving(fmt::format("agate agate_turb {} rotate 90 * x", number(p.wander)));
}
GradedValue value_of(const Crackle& p) {
  using Measure = Crackle::Measure;
  const char* const form = p.measure == Measure::first    ? "<1, 0, 0>"
                           : p.measure == Measure::second ? "<0, 1, 0>"
                                                          : "<-1, 1, 0>";
  return own(fmt::format("crackle form {}", form));
}
GradedValue value_of(const Ripples& p) {
  return own(p.spread == 0 ? "ripples" : "waves");
}

template <class P>
constexpr bool is_by_chance = std::is_same_v<P, Cells> || std::is_same_v<P, Crackle> || std::is_same_v<P, Ripples> ||
                              std::is_base_of_v<Fractal, P>;

std::string_view keyword(Wave wave) {
  switch (wave) {
  case Wave::ramp:
    break;
  case Wave::triangle:
    return " triangle_wave";
  case Wave::sine:
    return " sine_wave";
  case Wave::scallop:
    return " scallop_wave";
  case Wave::cubic:
    return " cubic_wave";
  }
  return "";
}

std::vector<PatternText::Part> parts_of(const Graded& p) {
  std::vector<PatternText::Part> parts;
  for (const Stop& stop : p.stops) {
    if (p.stepped && !parts.empty()) parts.push_back({stop.place, parts.back().shown});
    parts.push_back({stop.place, shown(stop.shown)});
  }
  return parts;
}

template <IsGraded P>
PatternText text_of(const P& p) {
  PatternText text{.parts = parts_of(p), .is_mixed = !p.stepped && p.stops.size() > 1};
  GradedValue value = value_of(p);
  const auto called = [&](std::string pattern) { // as a part of an expression
    const std::string name = fmt::format("pattern_{}", text.declared.size() + 1);
    text.declared.push_back(fmt::format("{} = function {{ pattern {{ {} }} }}", name, pattern));
    return name + "(x, y, z)";
  };
  if (value.moves_point) value = computed(called(value.pattern)); // a function keeps that to itself
  if (p.frequency != 1 || p.phase != 0) {
    const std::string inner = value.pattern.empty() ? value.expression : called(value.pattern);
    value = computed(fmt::format("within_period({} * ({}) + {})", number(p.frequency), inner, number(p.phase)));
  }
  const std::string whole = value.pattern.empty() ? fmt::format("function {{ {} }}", value.expression) : value.pattern;
  text.head = whole + std::string(keyword(p.wave));
  if (p.exponent != 1) text.head = fmt::format("function {{ pow({}, {}) }}", called(text.head), number(p.exponent));
  const auto uses = [](const std::string& line) { return line.find("within_period") != std::string::npos; };
  if (uses(text.head) || std::any_of(text.declared.begin(), text.declared.end(), uses))
    text.declared.insert(text.declared.begin(), fmt::format("within_period = {}", within_period));
  return text;
}

} // namespace

PatternText pattern_text(const PatternLayout& layout, std::vector<std::string>& inexact) {
  constexpr std::size_t most_parts = 256; // POV-Ray's own limit
  PatternText text = std::visit(
      []<class P>(const P& pattern) {
        if constexpr (std::is_same_v<P, FunctionPattern>)
          return PatternText{};
        else
          return text_of(pattern);
      },
      layout);
  const auto shows_the_same = [&](const PatternText::Part& part) { return part.shown == text.parts[0].shown; };
  std::visit(
      [&]<class P>(const P&) {
        if (is_by_chance<P> && !std::all_of(text.parts.begin(), text.parts.end(), shows_the_same))
          inexact.push_back(fmt::format("POV-Ray has other random numbers: its `{}` only looks alike", P::noun));
      },
      layout);
  if (text.parts.size() > most_parts) {
    inexact.push_back("POV-Ray's maps have 256 entries: further stops are left out");
    text.parts.resize(most_parts);
  }
  return text;
}

} // namespace rt::tools::povray
