#include "lang/builtins/builtins.hpp"
#include "lang/builtins/formula_calls.hpp"

#include <algorithm>
#include <cmath>

namespace rt::lang::builtins {
namespace {

constexpr std::size_t most_elements = std::size_t{1} << 32;

/// The number of elements of a sequence argument; nothing if there is no room for them.
std::optional<std::size_t> size_of(BuiltinCall& c, std::size_t i) {
  if (c[i].is(ValueKind::range)) {
    const double n = count(c[i].range(), c[i].excludes_end());
    if (!(n < static_cast<double>(most_elements))) {
      c.fail(i, "this range has no end", format_number(n) + " elements");
      return std::nullopt;
    }
  }
  return sequence_size(c[i]);
}

/// Like `size_of`, for functions that make a list of about as many elements.
std::optional<std::size_t> size_with_room(BuiltinCall& c, std::size_t i) {
  const auto n = size_of(c, i);
  if (n) c.spend(*n, *n * sizeof(Value));
  return n;
}

/// All arguments of a function that takes either numbers or one list of them.
std::optional<std::vector<Value>> numbers(BuiltinCall& c) {
  std::vector<Value> all;
  const bool is_list = c.arguments.size() == 1 && is_sequence(c[0]);
  if (is_list) {
    const auto n = size_with_room(c, 0);
    if (!n) return std::nullopt;
    for (std::size_t i = 0; i < *n; ++i) all.push_back(sequence_at(c[0], i));
  } else {
    all = c.arguments;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].is_poison()) return std::nullopt;
    if (all[i].is_number()) continue;
    const std::string label =
        is_list ? "element " + std::to_string(i) + " is " + describe(all[i]) : "this is " + describe(all[i]);
    c.fail(is_list ? 0 : i, "only numbers can be compared and summed here", label);
    return std::nullopt;
  }
  return all;
}

template <bool is_max>
Value extreme(BuiltinCall& c) {
  const auto all = numbers(c);
  if (!all) return Value::poison();
  if (all->empty()) return c.fail(0, "an empty list has no minimum or maximum");
  double best = (*all)[0].number();
  for (const Value& v : *all) best = is_max ? std::max(best, v.number()) : std::min(best, v.number());
  return best;
}

Value length_of_list(BuiltinCall& c) {
  if (c[0].is(ValueKind::string)) { // in characters, not bytes
    const std::string& text = c[0].text();
    return static_cast<double>(std::ranges::count_if(text, [](char ch) { return (ch & 0xc0) != 0x80; }));
  }
  const auto n = size_of(c, 0);
  return n ? Value(static_cast<double>(*n)) : Value::poison();
}

Value range_of(BuiltinCall& c) {
  const double a = c.has(1) ? c.number(0) : 0, b = c.has(1) ? c.number(1) : c.number(0);
  const double step = c.number_or(2, 1);
  if (step == 0) return c.fail(2, "the step of a range must not be 0");
  return Value::range({a, b, step}, true);
}

/// Adds up numbers, vectors or colours.
Value total(BuiltinCall& c) {
  const auto n = size_of(c, 0);
  if (!n) return Value::poison();
  c.spend(*n);
  if (*n == 0) return 0.0;
  Value sum = sequence_at(c[0], 0);
  for (std::size_t i = 0; i < *n; ++i) {
    const Value v = sequence_at(c[0], i);
    if (v.is_poison() || sum.is_poison()) return Value::poison();
    const bool is_alike = v.kind() == sum.kind() && (!v.is(ValueKind::vector) || v.vector_size() == sum.vector_size());
    if (!is_alike || !(v.is_number() || v.is(ValueKind::vector) || v.is(ValueKind::color)))
      return c.fail(0, "sum takes numbers, vectors or colours, all of one kind",
                    "element " + std::to_string(i) + " is " + describe(v));
    if (i == 0) continue;
    if (v.is_number())
      sum = sum.number() + v.number();
    else if (v.is(ValueKind::color))
      sum = sum.color() + v.color();
    else if (v.vector_size() == 2)
      sum = Value::point(sum.vector().x + v.vector().x, sum.vector().y + v.vector().y);
    else
      sum = sum.vector() + v.vector();
  }
  return sum;
}

Value product(BuiltinCall& c) {
  const auto all = numbers(c);
  if (!all) return Value::poison();
  double result = 1;
  for (const Value& v : *all) result *= v.number();
  return result;
}

Value mapped(BuiltinCall& c) {
  const auto n = size_with_room(c, 1);
  if (!n) return Value::poison();
  std::vector<Value> items;
  items.reserve(*n);
  for (std::size_t i = 0; i < *n; ++i) {
    c.spend(1);
    items.push_back(c.call(c[0], {sequence_at(c[1], i)}));
  }
  return make_list(c.heap(), std::move(items));
}

/// The truth value returned by a function argument; nothing after an error.
std::optional<bool> ask(BuiltinCall& c, const Value& element) {
  c.spend(1);
  const Value answer = c.call(c[0], {element});
  if (answer.is_poison()) return std::nullopt;
  if (answer.is(ValueKind::boolean)) return answer.truth();
  c.fail(0, "this function must return true or false", "it gives " + describe(answer));
  return std::nullopt;
}

Value filtered(BuiltinCall& c) {
  const auto n = size_of(c, 1);
  if (!n) return Value::poison();
  std::vector<Value> items;
  for (std::size_t i = 0; i < *n; ++i) {
    Value element = sequence_at(c[1], i);
    const auto holds = ask(c, element);
    if (!holds) return Value::poison();
    if (*holds) items.push_back(std::move(element));
  }
  return make_list(c.heap(), std::move(items));
}

Value folded(BuiltinCall& c) {
  const auto n = size_of(c, 2);
  if (!n) return Value::poison();
  Value result = c[1];
  for (std::size_t i = 0; i < *n && !result.is_poison(); ++i) {
    c.spend(1);
    result = c.call(c[0], {std::move(result), sequence_at(c[2], i)});
  }
  return result;
}

/// any (`wanted` true) and all (false): a list with a function, or a list of truth values alone.
template <bool wanted>
Value quantified(BuiltinCall& c) {
  const bool has_function = c.has(1);
  const auto n = size_of(c, has_function ? 1 : 0);
  if (!n) return Value::poison();
  Value result = Value::boolean(!wanted); // a formula, once one of the elements is
  for (std::size_t i = 0; i < *n; ++i) {
    const Value element = sequence_at(c[has_function ? 1 : 0], i);
    c.spend(1);
    const Value holds = has_function ? c.call(c[0], {element}) : element;
    if (holds.is_poison()) return holds;
    if (!is_boolean_like(holds))
      return has_function ? c.fail(0, "this function must return true or false", "it gives " + describe(holds))
                          : c.fail(0, "without a function, the list must contain truth values",
                                   "element " + std::to_string(i) + " is " + describe(holds));
    if (holds.is(ValueKind::boolean) && holds.truth() == wanted) return holds;
    if (holds.is(ValueKind::boolean)) continue;
    const Formulas formulas(c.heap(), {&holds, 1});
    const Term so_far = formulas.boolean(result);
    result = formulas.truth(so_far.apply(wanted ? Opcode::or_ : Opcode::and_, formulas.boolean(holds)));
  }
  return result;
}

Value zipped(BuiltinCall& c) {
  std::size_t shortest = most_elements;
  for (std::size_t i = 0; i < c.arguments.size(); ++i) {
    const auto n = size_of(c, i);
    if (!n) return Value::poison();
    shortest = std::min(shortest, *n);
  }
  c.spend(shortest, shortest * (c.arguments.size() + 2) * sizeof(Value));
  std::vector<Value> rows;
  rows.reserve(shortest);
  for (std::size_t row = 0; row < shortest; ++row) {
    std::vector<Value> items;
    for (const Value& list : c.arguments) items.push_back(sequence_at(list, row));
    rows.push_back(make_list(c.heap(), std::move(items)));
  }
  return make_list(c.heap(), std::move(rows));
}

Value concatenated(BuiltinCall& c) {
  std::vector<Value> items;
  for (std::size_t k = 0; k < c.arguments.size(); ++k) {
    const auto n = size_with_room(c, k);
    if (!n) return Value::poison();
    for (std::size_t i = 0; i < *n; ++i) items.push_back(sequence_at(c[k], i));
  }
  return make_list(c.heap(), std::move(items));
}

Value flattened(BuiltinCall& c) {
  std::vector<Value> items;
  const auto n = size_with_room(c, 0);
  if (!n) return Value::poison();
  for (std::size_t i = 0; i < *n; ++i) {
    const Value element = sequence_at(c[0], i);
    if (!is_sequence(element)) {
      items.push_back(element);
      continue;
    }
    if (element.is(ValueKind::range) &&
        !(count(element.range(), element.excludes_end()) < static_cast<double>(most_elements)))
      return c.fail(0, "a range in this list has no end");
    const std::size_t inner = sequence_size(element);
    c.spend(inner, inner * sizeof(Value));
    for (std::size_t j = 0; j < inner; ++j) items.push_back(sequence_at(element, j));
  }
  return make_list(c.heap(), std::move(items));
}

/// The order in which elements are sorted: of numbers, or of strings.
bool comes_before(const Value& a, const Value& b) {
  return a.is_number() ? a.number() < b.number() : a.text() < b.text();
}

Value sorted(BuiltinCall& c) {
  const auto n = size_with_room(c, 0);
  if (!n) return Value::poison();
  struct Keyed {
    Value key, element;
  };
  std::vector<Keyed> rows;
  rows.reserve(*n);
  for (std::size_t i = 0; i < *n; ++i) {
    Value element = sequence_at(c[0], i);
    c.spend(1);
    Value key = c.has(1) ? c.call(c[1], {element}) : element;
    if (key.is_poison()) return key;
    const bool is_fine = (key.is_number() && !std::isnan(key.number())) || key.is(ValueKind::string);
    if (!is_fine || (i > 0 && key.kind() != rows[0].key.kind()))
      return c.fail(c.has(1) ? 1 : 0, "lists are sorted by numbers or by strings, all of one kind",
                    "element " + std::to_string(i) + " is " + describe(key));
    rows.push_back({std::move(key), std::move(element)});
  }
  std::ranges::stable_sort(rows, [](const Keyed& a, const Keyed& b) { return comes_before(a.key, b.key); });
  std::vector<Value> items;
  items.reserve(rows.size());
  for (Keyed& row : rows) items.push_back(std::move(row.element));
  return make_list(c.heap(), std::move(items));
}

Value reversed(BuiltinCall& c) {
  const auto n = size_with_room(c, 0);
  if (!n) return Value::poison();
  std::vector<Value> items;
  items.reserve(*n);
  for (std::size_t i = *n; i-- > 0;) items.push_back(sequence_at(c[0], i));
  return make_list(c.heap(), std::move(items));
}

Value contains(BuiltinCall& c) {
  const auto n = size_of(c, 0);
  if (!n) return Value::poison();
  c.spend(*n);
  for (std::size_t i = 0; i < *n; ++i) {
    if (equal(sequence_at(c[0], i), c[1])) return Value::boolean(true);
  }
  return Value::boolean(false);
}

Value as_string(BuiltinCall& c) {
  if (c[0].is(ValueKind::string)) return c[0];
  return make_string(c.heap(), format(c[0], c.symbols()));
}

Value printed(BuiltinCall& c) {
  std::string line;
  for (const Value& value : c.arguments)
    line += (line.empty() ? "" : " ") + (value.is(ValueKind::string) ? value.text() : format(value, c.symbols()));
  c.spend(1, line.size());
  c.print(std::move(line));
  return {};
}

// The same where numbers in lists depend on the point. What only moves elements about does not look at them.

/// All of some numbers, or of one list of them, combined one after the other.
template <Opcode operation>
Value combined_formula(BuiltinCall& call) {
  const bool is_list = call.arguments.size() == 1 && is_sequence(call[0]);
  const std::size_t n = is_list ? sequence_size(call[0]) : call.arguments.size();
  const FormulaCall c(call);
  std::optional<Term> result;
  for (std::size_t i = 0; i < n; ++i) {
    const Value v = is_list ? sequence_at(call[0], i) : call[i];
    if (v.is_poison()) return v;
    if (!is_number_like(v))
      return call.fail(is_list ? 0 : i, "only numbers can be compared and summed here", "this is " + describe(v));
    call.spend(1);
    result = result ? result->apply(operation, c.formulas.number(v)) : c.formulas.number(v);
  }
  return c.formulas.value(*result); // there is a formula among them
}

Value total_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  Value sum = sequence_at(call[0], 0);
  for (std::size_t i = 1, n = sequence_size(call[0]); i < n; ++i) {
    call.spend(1);
    const Value v = sequence_at(call[0], i);
    if (v.is_poison()) return v;
    auto next = c.formulas.arithmetic(Opcode::add, sum, v);
    if (!next || is_number_like(sum) != is_number_like(v))
      return call.fail(0, "sum takes numbers, vectors or colours, all of one kind",
                       "element " + std::to_string(i) + " is " + describe(v));
    sum = *std::move(next);
  }
  return sum;
}

} // namespace

std::span<const Builtin> lists() {
  static constexpr Builtin table[] = {
      {"len", "list: list or string", "number of elements, or of characters", length_of_list, length_of_list},
      {"range", "a: number, b: number = ?, step: number = 1", "0..<a, or a..<b by step", range_of},
      {"map", "f: function, list: list", "f(x) for each element x", mapped, mapped},
      {"filter", "f: function, list: list", "the elements x for which f(x) is true", filtered, filtered},
      {"fold", "f: function, start: any, list: list", "f(… f(f(start, first), second) …, last)", folded, folded},
      {"sum", "list: list", "sum of numbers, vectors or colours", total, total_formula},
      {"product", "x…: number or list", "product of numbers, or of one list of them", product,
       combined_formula<Opcode::multiply>},
      {"min", "x…: number or list", "minimum of numbers, or of a list of them", extreme<false>,
       combined_formula<Opcode::minimum>},
      {"max", "x…: number or list", "maximum of numbers, or of a list of them", extreme<true>,
       combined_formula<Opcode::maximum>},
      {"zip", "lists…: list", "list of the first elements, of the second ones, and so on", zipped, zipped},
      {"concat", "lists…: list", "concatenation of lists", concatenated, concatenated},
      {"flatten", "list: list", "the elements of the lists in a list, one level deep", flattened, flattened},
      {"sort", "list: list, key: function = ?", "in ascending order of the elements, or of key(x)", sorted},
      {"reverse", "list: list", "from the last to the first", reversed, reversed},
      {"any", "f: function or list, list: list = ?", "whether f(x) is true for an element", quantified<true>,
       quantified<true>},
      {"all", "f: function or list, list: list = ?", "whether f(x) is true for each element", quantified<false>,
       quantified<false>},
      {"contains", "list: list, x: any", "whether an element equals x", contains},
      {"str", "x: any", "as text", as_string},
      {"print", "x…: any", "prints the values and the place to standard error, and returns `none`", printed},
  };
  return table;
}

} // namespace rt::lang::builtins
