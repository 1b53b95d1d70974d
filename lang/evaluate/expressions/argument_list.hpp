#pragma once

#include "lang/builtins/builtins.hpp"
#include "lang/check/errors/argument_errors.hpp"
#include "lang/evaluate/evaluation.hpp"

namespace rt::lang {

class CallEvaluator;
class ExpressionEvaluator;
class ThingSource;

/// The arguments of a call of a built-in function or chain method, in the order of its parameters. With
/// `takes_formulas`, they may depend on the point for which a function is compiled.
class ArgumentList final : public BuiltinCall {
public:
  ArgumentList(Evaluation& evaluation, CallEvaluator& calls, ThingSource& things, std::string_view name,
               const Signature& signature, Span place, bool takes_formulas = false);

  /// Evaluates the arguments of a call node and checks them; false after an error, or if one is poison.
  bool read(NodeId node, const Context& context, ExpressionEvaluator& expressions);
  /// The same for existing values.
  bool take(std::vector<Value> values);

  Heap& heap() override;
  const SymbolTable& symbols() override;
  Value call(const Value& function, std::vector<Value> function_arguments) override;
  Value fail(std::size_t argument, const std::string& message, const std::string& label) override;
  void print(std::string text) override;
  void spend(std::uint64_t steps, std::uint64_t bytes) override;
  const Observer* observer(std::optional<std::size_t> alone) override;
  std::optional<double> precision() override;
  const scene::Scene& scene() override;

private:
  bool put(std::size_t i, Value value, Span place);
  bool refuse(Diagnostic diagnostic);
  errors::Callee callee() const;
  bool are_complete();
  bool check_type(std::size_t i);
  Span place_of(std::size_t i) const { return i < places_.size() && places_[i].end > 0 ? places_[i] : place_; }

  Evaluation& evaluation_;
  CallEvaluator& calls_;
  ThingSource& things_;
  std::string_view name_;
  const Signature& signature_;
  Span place_;
  bool takes_formulas_;
  std::vector<Span> places_;
};

} // namespace rt::lang
