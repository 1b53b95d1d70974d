#include "tools/povray/export/export_function.hpp"

#include "renderer/functions/enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

namespace rt::tools::povray {
namespace {

constexpr std::size_t most_parameters = 50; // POV-Ray's own limit is 56
constexpr std::size_t most_calls = 200;     // one within the other
constexpr int most_nested = 40;             // brackets

// How often an operation's text holds each of its operands.
struct Uses {
  int a = 1, b = 1, c = 1;
};
Uses uses_of(Opcode operation) {
  switch (operation) {
  case Opcode::round:
    return {.a = 3, .b = 0, .c = 0};
  case Opcode::modulo:
  case Opcode::hypotenuse:
    return {.a = 2, .b = 2, .c = 0};
  default:
    return {.a = 1, .b = operand_count(operation) > 1 ? 1 : 0, .c = operand_count(operation) > 2 ? 1 : 0};
  }
}

constexpr std::string_view per_degree = "0.017453292519943295", per_radian = "57.29577951308232";

std::string unary(Opcode operation, const std::string& a) {
  switch (operation) {
  case Opcode::negate:
    return fmt::format("(-{})", a);
  case Opcode::absolute:
    return fmt::format("abs({})", a);
  case Opcode::floor:
    return fmt::format("floor({})", a);
  case Opcode::ceil:
    return fmt::format("ceil({})", a);
  case Opcode::round:
    return fmt::format("select({0}, -floor(0.5 - {0}), floor({0} + 0.5))", a);
  case Opcode::square_root:
    return fmt::format("sqrt({})", a);
  case Opcode::sine:
    return fmt::format("sin({} * {})", a, per_degree);
  case Opcode::cosine:
    return fmt::format("cos({} * {})", a, per_degree);
  case Opcode::tangent:
    return fmt::format("tan({} * {})", a, per_degree);
  case Opcode::arc_sine:
    return fmt::format("(asin(min(1, max(-1, {}))) * {})", a, per_radian);
  case Opcode::arc_cosine:
    return fmt::format("(acos(min(1, max(-1, {}))) * {})", a, per_radian);
  case Opcode::arc_tangent:
    return fmt::format("(atan2({}, 1) * {})", a, per_radian);
  case Opcode::exponential:
    return fmt::format("exp({})", a);
  case Opcode::logarithm:
    return fmt::format("ln({})", a);
  case Opcode::logarithm2:
    return fmt::format("(ln({}) / 0.6931471805599453)", a);
  case Opcode::logarithm10:
    return fmt::format("log({})", a);
  default:
    return fmt::format("(1 - {})", a); // not, of 0 or 1
  }
}

std::string binary(Opcode operation, const std::string& a, const std::string& b) {
  switch (operation) {
  case Opcode::modulo:
    return fmt::format("({0} - {1} * floor({0} / {1}))", a, b);
  case Opcode::power:
    return fmt::format("pow({}, {})", a, b);
  case Opcode::minimum:
    return fmt::format("min({}, {})", a, b);
  case Opcode::maximum:
  case Opcode::or_:
    return fmt::format("max({}, {})", a, b);
  case Opcode::arc_tangent2:
    return fmt::format("(atan2({}, {}) * {})", a, b, per_radian);
  case Opcode::hypotenuse:
    return fmt::format("sqrt({0} * {0} + {1} * {1})", a, b);
  case Opcode::equal:
    return fmt::format("({} = {})", a, b);
  case Opcode::and_:
    return fmt::format("({} * {})", a, b);
  default:
    return fmt::format("({} {} {})", a, spelling(operation), b);
  }
}

// Transcribes one result: instructions that are used once stand within what uses them.
class Transcript {
public:
  Transcript(const Function& function, Register result) : function_(function), result_(result) {
    count_uses();
    for (Register r = function.first_instruction(); r <= result; ++r)
      if (uses_[r] > 0) write(r);
  }

  std::optional<FunctionText> text(std::string& problem) {
    if (has_noise_) return problem = "POV-Ray has another noise: this function stays black there", std::nullopt;
    if (named_.size() > most_calls)
      return problem = "this function has too many steps for POV-Ray: it stays black there", std::nullopt;
    FunctionText all;
    std::string body = texts_[result_];
    std::set<Register> live = reads_[result_];
    for (std::size_t k = named_.size(); k-- > 0;) {
      if (live.size() > most_parameters)
        return problem = "this function keeps too many values at once for POV-Ray: it stays black there", std::nullopt;
      const std::string name = fmt::format("f{}", k + 1);
      std::string parameters = "x, y, z", arguments = parameters;
      const Register own = named_[k];
      for (const Register r : live) {
        parameters += ", " + name_of(r);
        arguments += ", " + (r == own ? texts_[own] : name_of(r));
      }
      all.declarations.push_back({name, parameters, body});
      body = fmt::format("{}({})", name, arguments);
      live.erase(own);
      live.insert(reads_[own].begin(), reads_[own].end());
    }
    all.expression = body;
    return all;
  }

private:
  void count_uses() {
    uses_.resize(function_.register_count());
    uses_[result_] = 1;
    for (Register r = result_ + 1; r-- > function_.first_instruction();) {
      if (uses_[r] == 0) continue;
      const Instruction& i = instruction(r);
      const Uses uses = uses_of(i.operation);
      uses_[i.a] += uses.a, uses_[i.b] += uses.b, uses_[i.c] += uses.c;
    }
    texts_.resize(uses_.size()), reads_.resize(uses_.size()), depths_.resize(uses_.size()),
        is_named_.resize(uses_.size());
  }

  void write(Register r) {
    const Instruction& i = instruction(r);
    const int count = operand_count(i.operation);
    int depth = 0;
    for (const Register operand : {i.a, i.b, i.c}) {
      if (operand < function_.first_instruction()) continue;
      if (is_named_[operand])
        reads_[r].insert(operand);
      else
        reads_[r].insert(reads_[operand].begin(), reads_[operand].end()), depth = std::max(depth, depths_[operand]);
    }
    const std::string a = operand(i.a), b = operand(i.b), c = operand(i.c);
    has_noise_ |= i.operation == Opcode::noise;
    texts_[r] = count == 1   ? unary(i.operation, a)
                : count == 2 ? binary(i.operation, a, b)
                             : fmt::format("select(-{}, {}, {})", a, b, c); // of a number below 0 the second
    depths_[r] = depth + 1;
    if (r == result_ || (uses_[r] == 1 && depth < most_nested)) return;
    is_named_[r] = true;
    named_.push_back(r);
  }

  std::string operand(Register r) const {
    if (function_.is_input(r)) return std::string(1, "xyz"[r]);
    if (!function_.is_constant(r)) return is_named_[r] ? name_of(r) : texts_[r];
    const double value = function_.constant(r);
    return value < 0 ? fmt::format("({})", number(value)) : number(value);
  }
  std::string name_of(Register r) const { return fmt::format("t{}", r - function_.first_instruction() + 1); }
  const Instruction& instruction(Register r) const { return function_.code[r - function_.first_instruction()]; }

  const Function& function_;
  Register result_;
  std::vector<int> uses_;
  std::vector<std::string> texts_;        // of instructions
  std::vector<std::set<Register>> reads_; // the named values in a text
  std::vector<int> depths_;
  std::vector<bool> is_named_;
  std::vector<Register> named_;
  bool has_noise_ = false;
};

} // namespace

std::optional<FunctionText> function_text(const Function& function, std::size_t result, std::string& problem) {
  const Register r = function.results[result];
  if (function.is_input(r)) return FunctionText{{}, std::string(1, "xyz"[r])};
  if (function.is_constant(r)) return FunctionText{{}, number(function.constant(r))};
  return Transcript(function, r).text(problem);
}

double upper_bound(const Function& function, std::size_t result) {
  constexpr double most = std::numeric_limits<double>::max();
  const std::vector<Enclosure> box(function.input_count, {-most, most, false});
  std::vector<Enclosure> registers(function.register_count());
  evaluate(function, box, registers);
  return registers[function.results[result]].upper;
}

void write_function_pattern(Writer& out, const FunctionText& text, double scale) {
  for (const FunctionText::Declaration& d : text.declarations)
    out.line(fmt::format("#declare {} = function({}) {{ {} }}", d.name, d.parameters, d.body));
  const std::string value = scale == 1 ? text.expression : fmt::format("({}) / {}", text.expression, number(scale));
  out.line(fmt::format("function {{ min(1, max(0, {})) }}", value));
  for (const FunctionText::Declaration& d : text.declarations) out.line("#undef " + d.name);
}

} // namespace rt::tools::povray
