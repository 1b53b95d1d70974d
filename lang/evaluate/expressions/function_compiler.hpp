#pragma once

#include "lang/evaluate/evaluation.hpp"

#include <string_view>

namespace rt::lang {

class ExpressionEvaluator;

/// Compiles functions of the scene's for the renderer: each is called once, with a point that is not known yet, and
/// what is computed with it is written down. Calls, loops, lists and conditions that do not depend on the point are
/// carried out on the way.
class FunctionCompiler : private EvaluationPart {
public:
  FunctionCompiler(Evaluation& evaluation, ExpressionEvaluator& expressions)
      : EvaluationPart(evaluation), expressions_(expressions) {}

  /// Of a function of one point that is the value of a property, a colour or a number: puts it into the closure. False
  /// after a mistake.
  bool compile(Closure& closure, std::string_view property, Span place);

private:
  bool takes_one_point(const FunctionInfo& function, std::string_view property, Span place);

  ExpressionEvaluator& expressions_;
};

} // namespace rt::lang
