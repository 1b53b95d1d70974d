#pragma once

#include <cstdint>
#include <string_view>

namespace rt {

/// What an instruction of a function does with one to three numbers. Truth values are the numbers 1 and 0.
enum class Operation : std::uint8_t {
  // Of one number
  negate,
  absolute,
  floor,
  ceil,
  round, ///< halves away from 0
  square_root,
  sine, ///< angles are degrees, here and below
  cosine,
  tangent,
  arc_sine,
  arc_cosine,
  arc_tangent,
  exponential,
  logarithm,
  logarithm2,
  logarithm10,
  not_,
  // Of two
  add,
  subtract,
  multiply,
  divide,
  modulo, ///< a − b·⌊a/b⌋: with the sign of b
  power,
  minimum,
  maximum,
  arc_tangent2, ///< of (y, x)
  hypotenuse,
  less,
  less_equal,
  equal,
  and_,
  or_,
  // Of three
  select, ///< the second where the first is true, else the third
  noise,  ///< gradient noise at a point
};

constexpr int operand_count(Operation operation) {
  return operation < Operation::add ? 1 : operation < Operation::select ? 2 : 3;
}

/// `sqrt`, `+`, `select`: as it is written, a function or an infix operator.
std::string_view spelling(Operation operation);
bool is_infix(Operation operation);

/// Calls f.operator()<operation>(): a switch that turns an operation into one known to the compiler.
template <class F>
constexpr decltype(auto) dispatch(Operation operation, F&& f) {
  switch (operation) {
  case Operation::negate:
    return f.template operator()<Operation::negate>();
  case Operation::absolute:
    return f.template operator()<Operation::absolute>();
  case Operation::floor:
    return f.template operator()<Operation::floor>();
  case Operation::ceil:
    return f.template operator()<Operation::ceil>();
  case Operation::round:
    return f.template operator()<Operation::round>();
  case Operation::square_root:
    return f.template operator()<Operation::square_root>();
  case Operation::sine:
    return f.template operator()<Operation::sine>();
  case Operation::cosine:
    return f.template operator()<Operation::cosine>();
  case Operation::tangent:
    return f.template operator()<Operation::tangent>();
  case Operation::arc_sine:
    return f.template operator()<Operation::arc_sine>();
  case Operation::arc_cosine:
    return f.template operator()<Operation::arc_cosine>();
  case Operation::arc_tangent:
    return f.template operator()<Operation::arc_tangent>();
  case Operation::exponential:
    return f.template operator()<Operation::exponential>();
  case Operation::logarithm:
    return f.template operator()<Operation::logarithm>();
  case Operation::logarithm2:
    return f.template operator()<Operation::logarithm2>();
  case Operation::logarithm10:
    return f.template operator()<Operation::logarithm10>();
  case Operation::not_:
    return f.template operator()<Operation::not_>();
  case Operation::add:
    return f.template operator()<Operation::add>();
  case Operation::subtract:
    return f.template operator()<Operation::subtract>();
  case Operation::multiply:
    return f.template operator()<Operation::multiply>();
  case Operation::divide:
    return f.template operator()<Operation::divide>();
  case Operation::modulo:
    return f.template operator()<Operation::modulo>();
  case Operation::power:
    return f.template operator()<Operation::power>();
  case Operation::minimum:
    return f.template operator()<Operation::minimum>();
  case Operation::maximum:
    return f.template operator()<Operation::maximum>();
  case Operation::arc_tangent2:
    return f.template operator()<Operation::arc_tangent2>();
  case Operation::hypotenuse:
    return f.template operator()<Operation::hypotenuse>();
  case Operation::less:
    return f.template operator()<Operation::less>();
  case Operation::less_equal:
    return f.template operator()<Operation::less_equal>();
  case Operation::equal:
    return f.template operator()<Operation::equal>();
  case Operation::and_:
    return f.template operator()<Operation::and_>();
  case Operation::or_:
    return f.template operator()<Operation::or_>();
  case Operation::select:
    return f.template operator()<Operation::select>();
  case Operation::noise:
    return f.template operator()<Operation::noise>();
  }
  __builtin_unreachable();
}

} // namespace rt
