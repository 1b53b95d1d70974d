#include "renderer/functions/enclosure.hpp"

#include "renderer/functions/outward.hpp"
#include "renderer/math/noise.hpp"

#include <cassert>

namespace rt {
namespace {

bool either_undefined(const Enclosure& a, const Enclosure& b) {
  return a.may_be_undefined || b.may_be_undefined;
}

// A truth value: known to be 1, known to be 0, or either. Comparisons with what has no value are false.
Enclosure truth(bool is_surely_true, bool is_surely_false, bool may_be_undefined) {
  if (is_surely_false) return Enclosure::of(0);
  return {is_surely_true && !may_be_undefined ? 1.0 : 0.0, 1, false};
}

// As `select` sees it: all but 0 is true.
bool is_surely_true(const Enclosure& a) {
  return !a.contains(0);
}
bool is_surely_false(const Enclosure& a) {
  return a.lower == 0 && a.upper == 0 && !a.may_be_undefined;
}

Enclosure square_root_of(const Enclosure& a) {
  if (a.upper < 0) return {0, Enclosure::infinity, true};
  const double low = std::sqrt(std::max(a.lower, 0.0)), high = std::sqrt(a.upper);
  return held(outward(low, high, a.may_be_undefined || a.lower < 0), 0, Enclosure::infinity);
}

Enclosure logarithm_of(const Enclosure& a, double (*f)(double)) {
  if (a.upper < 0) return Enclosure::whole(true);
  return outward(a.lower > 0 ? f(a.lower) : -Enclosure::infinity, f(a.upper), a.may_be_undefined || a.lower < 0, 2);
}

// Of a function that never falls.
Enclosure monotone(const Enclosure& a, double (*f)(double)) {
  return {f(a.lower), f(a.upper), a.may_be_undefined};
}

template <Opcode operation>
Enclosure enclosed(const Enclosure& a) {
  using enum Opcode;
  if constexpr (operation == negate) return negated(a);
  if constexpr (operation == absolute) return magnitude(a);
  if constexpr (operation == Opcode::floor) return monotone(a, [](double v) { return std::floor(v); });
  if constexpr (operation == Opcode::ceil) return monotone(a, [](double v) { return std::ceil(v); });
  if constexpr (operation == Opcode::round) return monotone(a, [](double v) { return std::round(v); });
  if constexpr (operation == square_root) return square_root_of(a);
  if constexpr (operation == Opcode::sine) return rt::sine(a);
  if constexpr (operation == Opcode::cosine) return rt::cosine(a);
  if constexpr (operation == Opcode::tangent) return rt::tangent(a);
  if constexpr (operation == Opcode::arc_sine) return rt::arc_sine(a);
  if constexpr (operation == Opcode::arc_cosine) return rt::arc_cosine(a);
  if constexpr (operation == Opcode::arc_tangent) return rt::arc_tangent(a);
  if constexpr (operation == exponential)
    return held(outward(std::exp(a.lower), std::exp(a.upper), a.may_be_undefined, 2), 0, Enclosure::infinity);
  if constexpr (operation == logarithm) return logarithm_of(a, [](double v) { return std::log(v); });
  if constexpr (operation == logarithm2) return logarithm_of(a, [](double v) { return std::log2(v); });
  if constexpr (operation == logarithm10) return logarithm_of(a, [](double v) { return std::log10(v); });
  if constexpr (operation == not_) return truth(is_surely_false(a), is_surely_true(a), false);
}

Enclosure hypotenuse_of(const Enclosure& a, const Enclosure& b) {
  const Enclosure x = magnitude(a), y = magnitude(b);
  return held(outward(std::hypot(x.lower, y.lower), std::hypot(x.upper, y.upper), either_undefined(a, b), 2), 0,
              Enclosure::infinity);
}

// Of what has no value, `minimum` gives the first operand.
Enclosure least(const Enclosure& a, const Enclosure& b) {
  if (either_undefined(a, b)) return hull(a, b);
  return {std::min(a.lower, b.lower), std::min(a.upper, b.upper), false};
}

// `is_same`: both operands are one register.
template <Opcode operation>
Enclosure enclosed(const Enclosure& a, const Enclosure& b, bool is_same) {
  using enum Opcode;
  if constexpr (operation == add) return sum(a, b);
  if constexpr (operation == subtract) return sum(a, negated(b));
  if constexpr (operation == multiply) return is_same ? square(a) : product(a, b);
  if constexpr (operation == divide) return quotient(a, b);
  if constexpr (operation == modulo) return remainder(a, b);
  if constexpr (operation == Opcode::power) return rt::power(a, b);
  if constexpr (operation == minimum) return least(a, b);
  if constexpr (operation == maximum) return negated(least(negated(a), negated(b)));
  if constexpr (operation == Opcode::arc_tangent2) return rt::arc_tangent2(a, b);
  if constexpr (operation == hypotenuse) return hypotenuse_of(a, b);
  if constexpr (operation == Opcode::less) return truth(a.upper < b.lower, a.lower >= b.upper, either_undefined(a, b));
  if constexpr (operation == Opcode::less_equal)
    return truth(a.upper <= b.lower, a.lower > b.upper, either_undefined(a, b));
  if constexpr (operation == equal)
    return truth(a.lower == a.upper && a.lower == b.lower && b.lower == b.upper, a.upper < b.lower || b.upper < a.lower,
                 either_undefined(a, b));
  if constexpr (operation == and_)
    return truth(is_surely_true(a) && is_surely_true(b), is_surely_false(a) || is_surely_false(b), false);
  if constexpr (operation == or_)
    return truth(is_surely_true(a) || is_surely_true(b), is_surely_false(a) && is_surely_false(b), false);
}

Enclosure selected(const Enclosure& condition, const Enclosure& a, const Enclosure& b) {
  if (is_surely_true(condition)) return a;
  return is_surely_false(condition) ? b : hull(a, b);
}

// The value in the middle, and as far from it as it can get within the box.
Enclosure noise_within(std::uint64_t seed, const Enclosure& x, const Enclosure& y, const Enclosure& z) {
  double reach = 1e-12; // more than all rounding
  Vec3 middle{};
  bool is_undefined = false;
  const Enclosure* const sides[] = {&x, &y, &z};
  for (std::size_t i = 0; i < 3; ++i) {
    const Enclosure& side = *sides[i];
    is_undefined = is_undefined || side.may_be_undefined || side.lower == -Enclosure::infinity ||
                   side.upper == Enclosure::infinity;
    middle[i] = side.lower / 2 + side.upper / 2;
    reach += steepest_noise * std::max(side.upper - middle[i], middle[i] - side.lower);
  }
  if (!(reach < 2)) return {-1, 1, is_undefined};
  const double value = gradient_noise(seed, middle);
  return held(outward(value - reach, value + reach, is_undefined), -1, 1);
}

} // namespace

void evaluate(const Function& function, std::span<const Enclosure> inputs, Registers<Enclosure> registers) {
  assert(inputs.size() == function.input_count && registers.size() >= function.register_count());
  Enclosure* const r = registers.data();
  Enclosure* own = std::ranges::copy(inputs, r).out;
  for (const double constant : function.constants) *own++ = Enclosure::of(constant);
  for (const Instruction& i : function.code) {
    const Enclosure &a = r[i.a], &b = r[i.b], &c = r[i.c];
    *own++ = dispatch(i.operation, [&]<Opcode operation>() {
      if constexpr (operation == Opcode::select)
        return selected(a, b, c);
      else if constexpr (operation == Opcode::noise)
        return noise_within(function.seeds[i.seed], a, b, c);
      else if constexpr (operand_count(operation) == 1)
        return enclosed<operation>(a);
      else
        return enclosed<operation>(a, b, i.a == i.b);
    });
  }
}

} // namespace rt
