#pragma once

#include <cstdint>
#include <string_view>

namespace rt {

/// What an instruction of a function does with one to three numbers. Truth values are the numbers 1 and 0.
enum class Opcode : std::uint8_t {
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

constexpr int operand_count(Opcode operation) {
  return operation < Opcode::add ? 1 : operation < Opcode::select ? 2 : 3;
}

/// `sqrt`, `+`, `select`: as it is written, a function or an infix operator.
std::string_view spelling(Opcode operation);
bool is_infix(Opcode operation);

/// Calls f.operator()<operation>(): a switch that turns an operation into one known to the compiler.
template <class F>
constexpr decltype(auto) dispatch(Opcode operation, F&& f) {
  switch (operation) {
  case Opcode::negate:
    return f.template operator()<Opcode::negate>();
  case Opcode::absolute:
    return f.template operator()<Opcode::absolute>();
  case Opcode::floor:
    return f.template operator()<Opcode::floor>();
  case Opcode::ceil:
    return f.template operator()<Opcode::ceil>();
  case Opcode::round:
    return f.template operator()<Opcode::round>();
  case Opcode::square_root:
    return f.template operator()<Opcode::square_root>();
  case Opcode::sine:
    return f.template operator()<Opcode::sine>();
  case Opcode::cosine:
    return f.template operator()<Opcode::cosine>();
  case Opcode::tangent:
    return f.template operator()<Opcode::tangent>();
  case Opcode::arc_sine:
    return f.template operator()<Opcode::arc_sine>();
  case Opcode::arc_cosine:
    return f.template operator()<Opcode::arc_cosine>();
  case Opcode::arc_tangent:
    return f.template operator()<Opcode::arc_tangent>();
  case Opcode::exponential:
    return f.template operator()<Opcode::exponential>();
  case Opcode::logarithm:
    return f.template operator()<Opcode::logarithm>();
  case Opcode::logarithm2:
    return f.template operator()<Opcode::logarithm2>();
  case Opcode::logarithm10:
    return f.template operator()<Opcode::logarithm10>();
  case Opcode::not_:
    return f.template operator()<Opcode::not_>();
  case Opcode::add:
    return f.template operator()<Opcode::add>();
  case Opcode::subtract:
    return f.template operator()<Opcode::subtract>();
  case Opcode::multiply:
    return f.template operator()<Opcode::multiply>();
  case Opcode::divide:
    return f.template operator()<Opcode::divide>();
  case Opcode::modulo:
    return f.template operator()<Opcode::modulo>();
  case Opcode::power:
    return f.template operator()<Opcode::power>();
  case Opcode::minimum:
    return f.template operator()<Opcode::minimum>();
  case Opcode::maximum:
    return f.template operator()<Opcode::maximum>();
  case Opcode::arc_tangent2:
    return f.template operator()<Opcode::arc_tangent2>();
  case Opcode::hypotenuse:
    return f.template operator()<Opcode::hypotenuse>();
  case Opcode::less:
    return f.template operator()<Opcode::less>();
  case Opcode::less_equal:
    return f.template operator()<Opcode::less_equal>();
  case Opcode::equal:
    return f.template operator()<Opcode::equal>();
  case Opcode::and_:
    return f.template operator()<Opcode::and_>();
  case Opcode::or_:
    return f.template operator()<Opcode::or_>();
  case Opcode::select:
    return f.template operator()<Opcode::select>();
  case Opcode::noise:
    return f.template operator()<Opcode::noise>();
  }
  __builtin_unreachable();
}

} // namespace rt
