#include "lang/values/value.hpp"

#include "lang/values/builtin.hpp"
#include "lang/values/formula.hpp"
#include "lang/values/thing.hpp"
#include "renderer/math/hashing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::lang {

const Value* Record::find(Symbol name) const {
  for (const RecordEntry& entry : entries) {
    if (entry.name == name) return &entry.value;
  }
  return nullptr;
}

Frame::Frame(Ref<Frame> p, std::uint32_t n) : parent(std::move(p)), size(n) {
  for (std::uint32_t i = 0; i < n; ++i) new (slots() + i) Value(Value::unset());
}

Frame::~Frame() {
  for (std::uint32_t i = 0; i < size; ++i) slots()[i].~Value();
}

void Frame::clear() {
  for (std::uint32_t i = 0; i < size; ++i) slots()[i] = Value::unset();
}

Ref<Frame> make_frame(Heap& heap, Ref<Frame> parent, std::uint32_t size) {
  return Ref<Frame>(heap.make<Frame>(size * sizeof(Value), std::move(parent), size));
}

Value make_string(Heap& heap, std::string text) {
  Ref<String> cell(heap.make<String>(0));
  cell->text = std::move(text);
  heap.charge(cell->text.capacity());
  return cell;
}

namespace {

bool are_numbers(const std::vector<Value>& items) {
  return std::ranges::all_of(items, [](const Value& v) { return v.is_number(); });
}

std::uint16_t above(std::uint16_t deepest) {
  return static_cast<std::uint16_t>(std::min(deepest + 1, 0xffff));
}

} // namespace

Value make_list(Heap& heap, std::vector<Value> items) {
  if (items.size() == 3 && are_numbers(items)) return Vec3{items[0].number(), items[1].number(), items[2].number()};
  if (items.size() == 2 && are_numbers(items)) return Value::point(items[0].number(), items[1].number());
  if (auto vector = formula_vector(heap, items)) return *std::move(vector);
  Ref<List> cell(heap.make<List>(0));
  std::uint16_t deepest = 0;
  for (const Value& v : items) deepest = std::max(deepest, depth_of(v));
  cell->depth = above(deepest);
  cell->items = std::move(items);
  heap.charge(cell->items.capacity() * sizeof(Value));
  return cell;
}

Value make_record(Heap& heap, std::vector<Record::RecordEntry> entries) {
  Ref<Record> cell(heap.make<Record>(0));
  std::uint16_t deepest = 0;
  for (const Record::RecordEntry& entry : entries) deepest = std::max(deepest, depth_of(entry.value));
  cell->depth = above(deepest);
  cell->entries = std::move(entries);
  return cell;
}

double count(const RangeValue& range, bool excludes_end) {
  constexpr double slack = 1e-9;
  if (range.step == 0) return std::nan("");
  const double steps = (range.to - range.from) / range.step;
  double n = std::floor(steps + slack) + 1;
  if (n <= 0) return 0;
  if (excludes_end && std::abs(range.from + (n - 1) * range.step - range.to) <= slack * std::abs(range.step)) n -= 1;
  return n;
}

bool is_sequence(const Value& value) {
  return value.is(ValueKind::list) || value.is(ValueKind::vector) || value.is(ValueKind::range) ||
         is_formula(value, FormulaType::vector);
}

std::size_t sequence_size(const Value& value) {
  switch (value.kind()) {
  case ValueKind::list:
    return value.items().size();
  case ValueKind::vector:
    return value.vector_size();
  case ValueKind::formula:
    return value.formula().size;
  case ValueKind::range:
    return static_cast<std::size_t>(count(value.range(), value.excludes_end()));
  default:
    return 0;
  }
}

Value sequence_at(const Value& value, std::size_t i) {
  switch (value.kind()) {
  case ValueKind::list:
    return value.items()[i];
  case ValueKind::vector:
    return value.vector()[i];
  case ValueKind::formula:
    return part_of(value.formula(), i);
  case ValueKind::range:
    return value.range().from + static_cast<double>(i) * value.range().step;
  default:
    return Value();
  }
}

std::uint16_t depth_of(const Value& value) {
  return value.is_shared() ? value.cell()->depth : 0;
}

namespace {

bool equal_sequences(const Value& a, const Value& b) {
  const auto size = [](const Value& v) {
    return v.is(ValueKind::range) ? count(v.range(), v.excludes_end()) : static_cast<double>(sequence_size(v));
  };
  const double n = size(a);
  if (n != size(b) || !std::isfinite(n)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    if (!equal(sequence_at(a, i), sequence_at(b, i))) return false;
  }
  return true;
}

bool equal_records(const Record& a, const Record& b) {
  if (a.entries.size() != b.entries.size()) return false;
  return std::ranges::all_of(a.entries, [&](const Record::RecordEntry& entry) {
    const Value* other = b.find(entry.name);
    return other && equal(entry.value, *other);
  });
}

bool equal_chains(const Chain* a, const Chain* b) {
  if (a == b) return true;
  if (!a || !b || a->steps.size() != b->steps.size()) return false;
  return std::ranges::equal(a->steps, b->steps, [](const scene::Step& s, const scene::Step& t) {
    return s.index() == t.index() && scene::matrix(s) == scene::matrix(t);
  });
}

bool equal_things(const Thing& a, const Thing& b) {
  if (&a == &b) return true;
  if (a.type != b.type || a.def != b.def || a.def_frame != b.def_frame) return false;
  if (!a.def && a.content != b.content) return false;
  if (a.properties.size() != b.properties.size() || !equal_chains(a.chain.get(), b.chain.get())) return false;
  return std::ranges::all_of(a.properties, [&](const PropertyValue& p) {
    const PropertyValue* other = b.find(p.id);
    return other && equal(p.value, other->value);
  });
}

} // namespace

bool equal(const Value& a, const Value& b) {
  if (is_sequence(a) && is_sequence(b)) return equal_sequences(a, b);
  if (a.kind() != b.kind()) return false;
  switch (a.kind()) {
  case ValueKind::boolean:
    return a.truth() == b.truth();
  case ValueKind::number:
    return a.number() == b.number();
  case ValueKind::color:
    return a.color() == b.color();
  case ValueKind::fade:
    return a.fade() == b.fade();
  case ValueKind::choice:
    return a.choice() == b.choice();
  case ValueKind::builtin:
    return a.builtin() == b.builtin();
  case ValueKind::string:
    return a.text() == b.text();
  case ValueKind::record:
    return equal_records(a.record(), b.record());
  case ValueKind::closure:
    return a.closure().function == b.closure().function && a.closure().parent == b.closure().parent;
  case ValueKind::thing:
    return equal_things(a.thing(), b.thing());
  case ValueKind::module:
    return a.module().info == b.module().info;
  case ValueKind::formula:
    return a.cell() == b.cell();
  default:
    return true;
  }
}

std::uint64_t hash(const Value& value) {
  Hasher h;
  if (is_sequence(value)) {
    h.add(std::uint64_t{1});
    for (std::size_t i = 0, n = sequence_size(value); i < n; ++i) h.add(hash(sequence_at(value, i)));
    return h.value();
  }
  h.add(std::uint64_t{2} + static_cast<std::uint64_t>(value.kind()));
  switch (value.kind()) {
  case ValueKind::boolean:
    h.add(std::uint64_t{value.truth() ? 1U : 0U});
    break;
  case ValueKind::number:
    h.add(value.number());
    break;
  case ValueKind::color:
    h.add(value.color());
    break;
  case ValueKind::string:
    for (const char c : value.text()) h.add(std::uint64_t{static_cast<unsigned char>(c)});
    break;
  default:
    break;
  }
  return h.value();
}

namespace {

std::string_view kind_of(const Formula& formula) {
  switch (formula.type) {
  case FormulaType::number:
    return "a number";
  case FormulaType::boolean:
    return "a truth value";
  case FormulaType::vector:
    return formula.size == 3 ? "a vector" : "a list of two numbers";
  case FormulaType::color:
    return "a colour";
  }
  return "";
}

} // namespace

std::string describe(const Value& value) {
  switch (value.kind()) {
  case ValueKind::unset:
    return "a name without a value";
  case ValueKind::poison:
    return "something in error";
  case ValueKind::none:
    return "`none`";
  case ValueKind::boolean:
    return value.truth() ? "`true`" : "`false`";
  case ValueKind::number:
    return "a number";
  case ValueKind::vector:
    return value.vector_size() == 3 ? "a vector" : "a list of two numbers";
  case ValueKind::color:
    return "a colour";
  case ValueKind::range:
    return "a range";
  case ValueKind::fade:
    return "a fade";
  case ValueKind::choice:
    return fmt::format("the word `{}`", value.choice());
  case ValueKind::builtin:
  case ValueKind::closure:
    return "a function";
  case ValueKind::string:
    return "a string";
  case ValueKind::list:
    return "a list";
  case ValueKind::record:
    return "a record";
  case ValueKind::module:
    return "a module";
  case ValueKind::formula:
    return fmt::format("{} that depends on the point", kind_of(value.formula()));
  case ValueKind::thing:
    break;
  default:
    return "nothing";
  }
  const std::string_view type = value.thing().type->name;
  const bool has_vowel =
      std::string_view("aeiou").find(type.front()) != std::string_view::npos && !type.starts_with("uni");
  return fmt::format("{} {}", has_vowel ? "an" : "a", type);
}

std::string count_of_arguments(std::size_t count) {
  return fmt::format("{} argument{}", count, count == 1 ? "" : "s");
}

} // namespace rt::lang
