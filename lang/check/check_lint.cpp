// What check has to say to the lint only: who reads which name, names that hide things, radians among degrees.

#include "lang/check/checker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rt::lang {
namespace {

constexpr double pi = std::numbers::pi;

/// Angles that are often written in radians, and the fewest decimals that give them away.
struct KnownAngle {
  double degrees;
  int decimals;
};
constexpr std::array known_angles{KnownAngle{30, 3},  KnownAngle{45, 3},  KnownAngle{60, 3},
                                  KnownAngle{90, 2},  KnownAngle{120, 3}, KnownAngle{135, 3},
                                  KnownAngle{180, 2}, KnownAngle{270, 2}, KnownAngle{360, 2}};

/// The angle that a number is in radians, rounded or cut off to some decimals; in degrees, 0 where it is none.
double as_radians(double number) {
  constexpr int most_decimals = 12;
  const double v = std::abs(number);
  for (const KnownAngle& angle : known_angles) {
    const double radians = angle.degrees * (pi / 180);
    for (int decimals = angle.decimals; decimals <= most_decimals; ++decimals) {
      const double scale = std::pow(10.0, decimals);
      const double rounded = std::round(radians * scale) / scale, cut = std::floor(radians * scale) / scale;
      if (std::abs(v - rounded) < 1e-13 || std::abs(v - cut) < 1e-13) return std::copysign(angle.degrees, number);
    }
    if (std::abs(v - radians) < 1e-12) return std::copysign(angle.degrees, number);
  }
  return 0;
}

NameUses::What what_is(const StaticType& known) {
  if (!known.is_thing()) return NameUses::What::value;
  return known.type->is_placeable() ? NameUses::What::thing : NameUses::What::material;
}

} // namespace

bool Checker::is_exported(const Unit& unit) const {
  return is_at_top_level() && (module_ != nullptr || &unit != program_.main || is_library_);
}

// A file that places nothing and says nothing of the scene is there for others to use.
bool Checker::places_nothing(const Unit& unit) const {
  return std::ranges::all_of(unit.ast.children(unit.ast.root), [&](NodeId item) {
    switch (unit.ast.kind(item)) {
    case Kind::bind:
    case Kind::def:
    case Kind::fn:
    case Kind::param:
    case Kind::use:
    case Kind::include:
    case Kind::error:
      return true;
    default:
      return false;
    }
  });
}

std::uint32_t Checker::declare_use(const Unit& unit, NodeId name_node, NameUses::What what) {
  if (!program_.uses) return NameUses::none;
  const Symbol symbol = unit.ast.symbol(name_node);
  const Span span = unit.ast.span(name_node);
  if (what != NameUses::What::parameter && program_.types.find(name(symbol))) {
    if (Diagnostic* d = report_.remark("W0105", span)) {
      d->message = fmt::format("the name `{0}` hides the thing `{0}`", name(symbol));
      d->label = fmt::format("from here on `{} {{ … }}` is a copy of this", name(symbol));
      d->notes.push_back({std::nullopt, "choose another name"});
    }
  }
  return program_.uses->declare(what, symbol, span, is_exported(unit));
}

void Checker::begin_use(std::uint32_t use) {
  if (use != NameUses::none) program_.uses->begin(use);
}

void Checker::end_use(std::uint32_t use) {
  if (use != NameUses::none) program_.uses->end();
}

void Checker::settle_use(std::uint32_t use, const StaticType& known) {
  if (use != NameUses::none) program_.uses->set_what(use, what_is(known));
}

// By how many factors of pi an expression is more than it would be without them: `pi / 2` and `2 * pi * t` by one, `180
// / pi` by one less, a sum by what its greater part is.
int Checker::pi_power(const Unit& unit, NodeId node) {
  const Ast& ast = unit.ast;
  constexpr std::size_t most_elements = 64; // of a list that is bound to a name
  switch (ast.kind(node)) {
  case Kind::number:
    return as_radians(ast.number(node)) != 0 ? 1 : 0;
  case Kind::name: {
    if (const Binding* binding = find(ast.symbol(node))) return binding->pi_power;
    const std::string_view word = name(ast.symbol(node));
    return word == "pi" || word == "tau" ? 1 : 0;
  }
  case Kind::unary:
    return pi_power(unit, ast.operand(node));
  case Kind::binary: {
    const int left = pi_power(unit, ast.left(node)), right = pi_power(unit, ast.right(node));
    switch (ast.op(node)) {
    case Op::multiply:
      return left + right;
    case Op::divide:
      return left - right;
    case Op::add:
    case Op::subtract:
      return std::max(left, right);
    case Op::modulo:
      return left;
    default:
      return 0;
    }
  }
  case Kind::range: {
    const Range range = ast.range(node);
    const int ends = std::max(pi_power(unit, range.from), pi_power(unit, range.to));
    return range.step == no_node ? ends : std::max(ends, pi_power(unit, range.step));
  }
  case Kind::list: {
    int most = 0;
    for (const NodeId child : ast.children(node).first(std::min(most_elements, ast.children(node).size())))
      most = std::max(most, pi_power(unit, child));
    return most;
  }
  default:
    return 0;
  }
}

// A value that stands where degrees are meant.
void Checker::check_angle(const Unit& unit, NodeId node) {
  const Ast& ast = unit.ast;
  if (ast.kind(node) == Kind::list) {
    for (const NodeId child : ast.children(node)) check_angle(unit, child);
    return;
  }
  double degrees = 0;
  std::string text{program_.sources.text(ast.span(node))};
  if (ast.kind(node) == Kind::number) {
    degrees = as_radians(ast.number(node));
  } else if (ast.kind(node) == Kind::numbers) {
    for (const double number : ast.numbers(node)) {
      if (degrees == 0) degrees = as_radians(number), text = format_number(number);
    }
  }
  if (degrees == 0 && pi_power(unit, node) < 1) return;
  Diagnostic* d = report_.remark("W0104", ast.span(node));
  if (!d) return;
  d->message = "this looks like radians, and angles are in degrees";
  if (degrees != 0) {
    d->label = fmt::format("write `{}`, or `{}rad`", degrees, text);
    return;
  }
  d->label = "half a turn is 180 here, not pi";
  d->notes.push_back(
      {std::nullopt,
       "write 180 for `pi` and 360 for `tau`; a number in radians takes the suffix `rad`, as in `1.5rad`"});
}

void Checker::check_angle_property(const Unit& unit, NodeId item, const Property& property) {
  const bool is_angle = property.common == Common::rotate || property.help.ends_with("degrees");
  if (!is_angle) return;
  const NodeId value = unit.ast.named(item).value;
  check_angle(unit, value);
  const bool is_opening = property.name == "fov" || property.name == "angle";
  if (!is_opening || unit.ast.kind(value) != Kind::number) return;
  const double number = unit.ast.number(value);
  if (!(number > 0 && number <= pi) || number == std::floor(number)) return; // 1 degree may be a telescope's
  if (Diagnostic* d = report_.remark("W0104", unit.ast.span(value))) {
    d->message = "this looks like radians, and angles are in degrees";
    d->label = fmt::format("{0:g} degrees are hardly open at all; {0:g} radians would be `{1:.3g}`", number,
                           number * (180 / pi));
  }
}

void Checker::check_angle_arguments(const Unit& unit, NodeId node, const Signature& signature, bool is_rotation) {
  std::size_t position = 0;
  for (const NodeId argument : unit.ast.call(node).arguments) {
    const bool is_named = unit.ast.kind(argument) == Kind::argument;
    std::string_view parameter;
    if (is_named)
      parameter = name(unit.ast.named(argument).symbol);
    else if (position < signature.size())
      parameter = signature[position].name;
    ++position;
    const bool is_angle = parameter == "angle" || parameter == "degrees";
    const bool is_part = is_rotation && (parameter == "x" || parameter == "y" || parameter == "z");
    if (is_angle || is_part) check_angle(unit, is_named ? unit.ast.named(argument).value : argument);
  }
}

} // namespace rt::lang
