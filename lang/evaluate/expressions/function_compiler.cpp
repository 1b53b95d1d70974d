#include "lang/evaluate/expressions/function_compiler.hpp"

#include "lang/evaluate/expressions/expression_evaluator.hpp"
#include "lang/values/formula.hpp"
#include "lang/values/value_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rt::lang {
namespace {

/// While it lives, a function is being compiled.
class Compilation {
public:
  Compilation(Evaluation& evaluation, FunctionBuilder& builder)
      : evaluation_(evaluation), outer_(std::exchange(evaluation.compiled, &builder)), note_(evaluation.errors) {}
  Compilation(const Compilation&) = delete;
  Compilation& operator=(const Compilation&) = delete;
  ~Compilation() { evaluation_.compiled = outer_; }

private:
  Evaluation& evaluation_;
  FunctionBuilder* outer_;
  ErrorReporter::Compilation note_;
};

std::string advice_on(const Value& result) {
  if (is_boolean_like(result)) return "write `if … { white } else { black }`";
  if (vector_like_size(result) == 3) return "write `linear_rgb(v.x, v.y, v.z)` for a vector that is meant as a colour";
  return {};
}

} // namespace

bool FunctionCompiler::takes_one_point(const FunctionInfo& function, std::string_view property, Span place) {
  const auto needed = static_cast<std::size_t>(
      std::ranges::count(function.parameters, no_node, &FunctionInfo::Parameter::default_value));
  const bool first_has_default = !function.parameters.empty() && function.parameters[0].default_value != no_node;
  if (needed == 1 && !first_has_default) return true;
  if (needed == 0 && first_has_default) return true;
  return refuse(errors::wrong_property_value(
      place, fmt::format("`{}` takes a function of one point", property),
      fmt::format("this one takes {}", count_of_arguments(function.parameters.size())), "write `fn(p) => …`"));
}

bool FunctionCompiler::compile(Closure& closure, std::string_view property, Span place) {
  if (closure.compiled) return true;
  if (!takes_one_point(*closure.function, property, place)) return false;
  const auto builder = std::make_shared<FunctionBuilder>(3);
  const Formulas formulas(heap_, builder);
  const auto input = [&](std::uint32_t i) { return Term(*builder, builder->input(i)); };
  Value result;
  {
    const Compilation compilation(evaluation_, *builder);
    const Value point = formulas.vector({input(0), input(1), input(2)}, 3);
    result = expressions_.call_function(Value(Ref<Closure>(&closure)), {point}, place);
  }
  if (result.is_poison()) return false;
  std::vector<FunctionBuilder::Node> results;
  if (is_number_like(result)) {
    results.push_back(formulas.number(result).node());
  } else if (const auto color = formulas.color(result)) {
    for (const Term& channel : *color) results.push_back(channel.node());
  } else {
    return refuse(errors::wrong_property_value(
        place, fmt::format("`{}` takes a function that gives a colour or a number", property),
        "this one gives " + describe(result), advice_on(result)));
  }
  closure.compiled = std::make_shared<const rt::Function>(builder->finish(results));
  return true;
}

} // namespace rt::lang
