// Angles written in radians.

#include "lang/check/lint/lint_warnings.hpp"
#include "lang/check/lint/text_lint.hpp"
#include "lang/values/value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace rt::lang {
namespace {

constexpr double pi = std::numbers::pi;

/// Angles that are often written in radians, and the number of decimals from which they are recognisable.
struct KnownAngle {
  double degrees;
  int decimals;
};
constexpr std::array known_angles{KnownAngle{30, 3},  KnownAngle{45, 3},  KnownAngle{60, 3},
                                  KnownAngle{90, 2},  KnownAngle{120, 3}, KnownAngle{135, 3},
                                  KnownAngle{180, 2}, KnownAngle{270, 2}, KnownAngle{360, 2}};

/// The well-known angle that a number is in radians, rounded or truncated to some decimals; in degrees, 0 if none.
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

class AngleLint {
public:
  AngleLint(const Program& program, Report& report) : program_(program), report_(report) {}

  void run();

private:
  int pi_power(const Ast& ast, NodeId node) const;
  int pi_power_of_name(const Ast& ast, NodeId name) const;
  int pi_power_of_operation(const Ast& ast, NodeId node) const;
  void find_powers();
  void check_value(const Ast& ast, NodeId node);
  void check_property(const Ast& ast, NodeId item);
  void check_call(const Ast& ast, NodeId node);
  void check_arguments(const Ast& ast, NodeId call, const Signature& signature, bool is_rotation);
  template <class T>
  T target_at(Span span) const {
    const Reference* reference = program_.references.find(span);
    const T* target = reference ? std::get_if<T>(&reference->referent) : nullptr;
    return target ? *target : T{};
  }

  const Program& program_;
  Report& report_;
  std::vector<int> powers_; // by declaration: pi_power of its value
};

void AngleLint::run() {
  find_powers();
  for (const Unit& unit : program_.units) {
    for (std::uint32_t i = 0; i < unit.ast.nodes.size(); ++i) {
      if (unit.ast.nodes[i].kind == Kind::property) check_property(unit.ast, NodeId{i});
      if (unit.ast.nodes[i].kind == Kind::call) check_call(unit.ast, NodeId{i});
    }
  }
}

// Names are declared after those that their values depend on.
void AngleLint::find_powers() {
  for (const Declaration& d : program_.references.declarations()) {
    NodeId value = no_node;
    if (d.what == Declaration::What::value)
      value = d.unit->ast.bind_item(d.item).value;
    else if (d.what == Declaration::What::param)
      value = d.unit->ast.param_item(d.item).value;
    else if (d.what == Declaration::What::local && d.unit->ast.kind(d.item) == Kind::for_)
      value = d.unit->ast.for_item(d.item).head;
    powers_.push_back(value == no_node ? 0 : pi_power(d.unit->ast, value));
  }
}

int AngleLint::pi_power_of_name(const Ast& ast, NodeId name) const {
  const Reference* reference = program_.references.find(ast.span(name));
  if (!reference) return 0;
  if (const DeclarationId* declaration = std::get_if<DeclarationId>(&reference->referent)) {
    const auto i = static_cast<std::size_t>(*declaration);
    return i < powers_.size() ? powers_[i] : 0;
  }
  const Constant* constant = target_at<const Constant*>(ast.span(name));
  return constant && (constant->name == "pi" || constant->name == "tau") ? 1 : 0;
}

int AngleLint::pi_power_of_operation(const Ast& ast, NodeId node) const {
  const int left = pi_power(ast, ast.left(node)), right = pi_power(ast, ast.right(node));
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

// The power of pi that an expression contains: 1 for `pi / 2` and `2 * pi * t`, -1 for `180 / pi`, for a sum that of
// its dominant term.
int AngleLint::pi_power(const Ast& ast, NodeId node) const {
  constexpr std::size_t most_elements = 64; // of a list bound to a name
  switch (ast.kind(node)) {
  case Kind::number:
    return as_radians(ast.number(node)) != 0 ? 1 : 0;
  case Kind::name:
    return pi_power_of_name(ast, node);
  case Kind::unary:
    return pi_power(ast, ast.operand(node));
  case Kind::binary:
    return pi_power_of_operation(ast, node);
  case Kind::range: {
    const Range range = ast.range(node);
    const int ends = std::max(pi_power(ast, range.from), pi_power(ast, range.to));
    return range.step == no_node ? ends : std::max(ends, pi_power(ast, range.step));
  }
  case Kind::list: {
    int most = 0;
    for (const NodeId child : ast.children(node).first(std::min(most_elements, ast.children(node).size())))
      most = std::max(most, pi_power(ast, child));
    return most;
  }
  default:
    return 0;
  }
}

// A value where degrees are expected.
void AngleLint::check_value(const Ast& ast, NodeId node) {
  if (ast.kind(node) == Kind::list) {
    for (const NodeId child : ast.children(node)) check_value(ast, child);
    return;
  }
  const Span span = ast.span(node);
  if (ast.kind(node) == Kind::number) {
    if (const double degrees = as_radians(ast.number(node)); degrees != 0)
      return warnings::radians(report_, span, degrees, program_.sources.text(span));
  } else if (ast.kind(node) == Kind::numbers) {
    for (const double number : ast.numbers(node))
      if (const double degrees = as_radians(number); degrees != 0)
        return warnings::radians(report_, span, degrees, format_number(number));
  }
  if (pi_power(ast, node) >= 1) warnings::turns_in_pi(report_, span);
}

void AngleLint::check_property(const Ast& ast, NodeId item) {
  const auto* property = target_at<const Property*>(ast.named_span(item, program_.symbols));
  if (!property) return;
  const bool is_angle = property->common == Common::rotate || property->help.ends_with("degrees");
  if (!is_angle) return;
  const NodeId value = ast.named(item).value;
  check_value(ast, value);
  const bool is_opening = property->name == "fov" || property->name == "angle";
  if (!is_opening || ast.kind(value) != Kind::number) return;
  const double number = ast.number(value);
  if (!(number > 0 && number <= pi) || number == std::floor(number)) return; // 1 degree may be a telescope's
  warnings::narrow_angle(report_, ast.span(value), number, number * (180 / pi));
}

void AngleLint::check_call(const Ast& ast, NodeId node) {
  const NodeId callee = ast.call(node).callee;
  if (ast.kind(callee) == Kind::member) {
    if (const auto* method = target_at<const ChainMethod*>(ast.member_span(callee, program_.symbols)))
      check_arguments(ast, node, method->signature, method->name == "rotate");
  } else if (const auto* builtin = target_at<const Builtin*>(ast.span(callee))) {
    check_arguments(ast, node, builtin->signature, false);
  }
}

void AngleLint::check_arguments(const Ast& ast, NodeId call, const Signature& signature, bool is_rotation) {
  std::size_t position = 0;
  for (const NodeId argument : ast.call(call).arguments) {
    const bool is_named = ast.kind(argument) == Kind::argument;
    std::string_view parameter;
    if (is_named)
      parameter = program_.symbols.name(ast.named(argument).symbol);
    else if (position < signature.size())
      parameter = signature[position].name;
    ++position;
    const bool is_angle = parameter == "angle" || parameter == "degrees";
    const bool is_part = is_rotation && (parameter == "x" || parameter == "y" || parameter == "z");
    if (is_angle || is_part) check_value(ast, is_named ? ast.named(argument).value : argument);
  }
}

} // namespace

void lint_angles(const Program& program, Report& report) {
  AngleLint(program, report).run();
}

} // namespace rt::lang
