#pragma once

#include "lang/values/signature.hpp"
#include "lang/values/value.hpp"
#include "renderer/scene/transform.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rt::scene {
struct Scene;
}

namespace rt::lang {

class Observer;

/// A call of a built-in function, with its arguments in the order of its parameters and their types checked. Omitted
/// ones are `unset`; the values of a last parameter with `…` come last.
class BuiltinCall {
public:
  std::vector<Value> arguments;

  virtual ~BuiltinCall() = default;
  virtual Heap& heap() = 0;
  virtual const SymbolTable& symbols() = 0;
  /// Calls a function value; poison after a failure, which is reported.
  virtual Value call(const Value& function, std::vector<Value> function_arguments) = 0;
  /// Reports an error at an argument and returns poison.
  virtual Value fail(std::size_t argument, const std::string& message, const std::string& label = {}) = 0;
  /// Outputs a note, with the place of the call.
  virtual void print(std::string text) = 0;
  /// Counts `steps` of work, and ensures that `bytes` more may be allocated. Does not return if a limit is exceeded:
  /// that ends the evaluation.
  virtual void spend(std::uint64_t steps, std::uint64_t bytes = 0) = 0;
  /// The observer of the scene, or of the thing alone that argument `alone` is, placed or not; null after a failure,
  /// which is reported. For questions only.
  virtual const Observer* observer(std::optional<std::size_t> alone = {}) = 0;
  /// The precision of the answer, if the expectation states one. For questions only.
  virtual std::optional<double> precision() = 0;
  virtual const scene::Scene& scene() = 0;

  bool has(std::size_t i) const { return i < arguments.size() && !arguments[i].is(ValueKind::unset); }
  const Value& operator[](std::size_t i) const { return arguments[i]; }
  double number(std::size_t i) const { return arguments[i].number(); }
  double number_or(std::size_t i, double otherwise) const { return has(i) ? number(i) : otherwise; }
  const Vec3& vector(std::size_t i) const { return arguments[i].vector(); }
};

/// One row of a table of built-in functions.
struct Builtin {
  std::string_view name;
  Signature signature;
  std::string_view help; ///< one line
  Value (*function)(BuiltinCall& call);
  /// The same where arguments depend on the point at which a function is evaluated, as a formula (`Formulas`); null
  /// where that cannot be.
  Value (*formula)(BuiltinCall& call) = nullptr;
};

/// One row of the table of chain methods: `thing.name(…)` appends a step.
struct ChainMethod {
  std::string_view name;
  Signature signature;
  std::string_view help;
  std::optional<scene::Step> (*function)(BuiltinCall& call); ///< nothing after an error
};

/// A name for a value.
struct Constant {
  std::string_view name;
  std::string_view value_text;
  std::string_view help;
  Value (*value)();
};

/// A table of functions with the name of its topic in the reference.
struct BuiltinGroup {
  std::string_view title;
  std::span<const Builtin> rows;
};

} // namespace rt::lang
