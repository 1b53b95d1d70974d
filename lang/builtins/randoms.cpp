#include "lang/builtins/builtins.hpp"
#include "lang/builtins/formula_calls.hpp"
#include "renderer/math/noise.hpp"
#include "renderer/math/random.hpp"

namespace rt::lang::builtins {
namespace {

std::optional<std::uint64_t> key_hash(BuiltinCall& c, std::size_t first) {
  std::uint64_t h = 0;
  for (std::size_t i = first; i < c.arguments.size(); ++i) {
    if (!c.has(i)) continue;
    if (c[i].is_shared() && !c[i].is(ValueKind::string) && !c[i].is(ValueKind::list)) {
      c.fail(i, "a key is a number, a string, a truth value, a colour or a list of these", "this is " + describe(c[i]));
      return std::nullopt;
    }
    h = mixed_seed(h, hash(c[i]));
  }
  return h;
}

Value random_number(BuiltinCall& c) {
  const auto h = key_hash(c, 0);
  if (!h) return Value::poison();
  return unit_interval(*h);
}

Value noise(BuiltinCall& c) {
  const auto seed = key_hash(c, 1);
  if (!seed) return Value::poison();
  const Vec3& p = c.vector(0);
  if (!is_finite(p)) return c.fail(0, "noise needs a finite point");
  return gradient_noise(*seed, p);
}

Value noise_formula(BuiltinCall& call) {
  if (holds_formula(std::span(call.arguments).subspan(1)))
    return call.fail(1, "the seed of a noise is the same at all points", "this depends on the point");
  const auto seed = key_hash(call, 1);
  if (!seed) return Value::poison();
  const FormulaCall c(call);
  const TermVector p = c.vector(0);
  FunctionBuilder& builder = *c.formulas.builder();
  return c.formulas.value({builder, builder.noise(*seed, p[0].node(), p[1].node(), p[2].node())});
}

} // namespace

std::span<const Builtin> randoms() {
  static constexpr Builtin table[] = {
      {"random", "key…: any", "a pseudorandom number in [0, 1) determined by the key", random_number},
      {"noise_at", "p: point, seed…: any = ?", "smooth gradient noise, from -1 to 1 and 0 at integer points", noise,
       noise_formula},
  };
  return table;
}

} // namespace rt::lang::builtins
