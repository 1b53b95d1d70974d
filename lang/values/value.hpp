#pragma once

#include "lang/text/source.hpp"
#include "lang/text/symbol.hpp"
#include "lang/values/heap.hpp"
#include "renderer/fields/field.hpp"
#include "renderer/math/color.hpp"
#include "renderer/math/format_number.hpp"
#include "renderer/math/vec3.hpp"

#include <cassert>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

struct Builtin;
struct FunctionInfo;
struct ModuleInfo;
struct Frame;
struct String;
struct List;
struct Record;
struct Closure;
struct Thing;
struct Module;
struct Formula;

/// a..b by step, or a..<b.
struct RangeValue {
  double from = 0, to = 0, step = 1;
};

/// A value of the language: 32 bytes, enough to store numbers, vectors, colours and ranges in place.
class Value {
public:
  Value() : Value(ValueKind::none) {}
  Value(double number) : Value(ValueKind::number) { payload_.number = number; }
  Value(const Vec3& vector) : Value(ValueKind::vector, 3) { payload_.vector = vector; }
  Value(const Color& color) : Value(ValueKind::color) { payload_.color = color; }
  Value(const scene::Fade& fade) : Value(ValueKind::fade, static_cast<std::uint8_t>(fade.law)) {
    payload_.number = fade.distance;
  }
  Value(const Builtin* builtin) : Value(ValueKind::builtin) { payload_.builtin = builtin; }
  template <class T>
  Value(const Ref<T>& cell) : Value(T::cell_kind) {
    assert(cell);
    payload_.cell = cell.get();
    ++payload_.cell->references;
  }
  static Value boolean(bool truth) { return Value(ValueKind::boolean, truth ? 1 : 0); }
  static Value point(double x, double y) {
    Value v(ValueKind::vector, 2);
    v.payload_.vector = {x, y, 0};
    return v;
  }
  static Value range(const RangeValue& range, bool excludes_end) {
    Value v(ValueKind::range, excludes_end ? 1 : 0);
    v.payload_.range = range;
    return v;
  }
  /// `word` must outlive the value.
  static Value choice(std::string_view word) {
    Value v(ValueKind::choice);
    v.payload_.word = word;
    return v;
  }
  static Value poison() { return Value(ValueKind::poison); }
  static Value unset() { return Value(ValueKind::unset); }

  Value(const Value& other) : payload_(other.payload_), kind_(other.kind_), detail_(other.detail_) { retain(); }
  Value(Value&& other) noexcept : payload_(other.payload_), kind_(other.kind_), detail_(other.detail_) {
    other.kind_ = ValueKind::none;
  }
  Value& operator=(Value other) noexcept {
    std::swap(payload_, other.payload_);
    std::swap(kind_, other.kind_);
    std::swap(detail_, other.detail_);
    return *this;
  }
  ~Value() { drop(); }

  ValueKind kind() const { return kind_; }
  bool is(ValueKind kind) const { return kind_ == kind; }
  bool is_poison() const { return kind_ == ValueKind::poison; }
  bool is_number() const { return kind_ == ValueKind::number; }
  bool is_vector3() const { return kind_ == ValueKind::vector && detail_ == 3; }
  bool is_shared() const { return kind_ >= ValueKind::string; }

  // Each requires its kind.
  double number() const { return expect(ValueKind::number).number; }
  bool truth() const { return expect(ValueKind::boolean), detail_ != 0; }
  const Vec3& vector() const { return expect(ValueKind::vector).vector; }
  unsigned vector_size() const { return expect(ValueKind::vector), detail_; }
  const Color& color() const { return expect(ValueKind::color).color; }
  const RangeValue& range() const { return expect(ValueKind::range).range; }
  bool excludes_end() const { return expect(ValueKind::range), detail_ != 0; }
  scene::Fade fade() const { return {static_cast<scene::Fade::Law>(detail_), expect(ValueKind::fade).number}; }
  std::string_view choice() const { return expect(ValueKind::choice).word; }
  const Builtin* builtin() const { return expect(ValueKind::builtin).builtin; }
  const std::string& text() const;
  const std::vector<Value>& items() const;
  const Record& record() const;
  Closure& closure() const;
  Thing& thing() const;
  Module& module() const;
  Formula& formula() const;
  /// Of what `is_shared`.
  Cell* cell() const { return assert(is_shared()), payload_.cell; }

private:
  union Payload {
    Payload() : number(0) {}
    double number;
    Vec3 vector;
    Color color;
    RangeValue range;
    std::string_view word;
    const Builtin* builtin;
    Cell* cell;
  };

  explicit Value(ValueKind kind, std::uint8_t detail = 0) : kind_(kind), detail_(detail) {}
  const Payload& expect([[maybe_unused]] ValueKind kind) const { return assert(kind_ == kind), payload_; }
  void retain() const {
    if (is_shared()) ++payload_.cell->references;
  }
  void drop() {
    if (is_shared() && --payload_.cell->references == 0) payload_.cell->heap->release(payload_.cell);
  }

  Payload payload_;
  ValueKind kind_;
  std::uint8_t detail_; // a vector's size, a fade's law, whether a range excludes its end
};
static_assert(sizeof(Value) == 32);

struct String : Cell {
  static constexpr ValueKind cell_kind = ValueKind::string;
  std::string text;
};

struct List : Cell {
  static constexpr ValueKind cell_kind = ValueKind::list;
  std::vector<Value> items;
};

struct Record : Cell {
  static constexpr ValueKind cell_kind = ValueKind::record;
  struct RecordEntry {
    Symbol name;
    Value value;
    Span span;      ///< of the value, for messages
    Span name_span; ///< of the name
  };
  std::vector<RecordEntry> entries; ///< in the order written
  const Value* find(Symbol name) const;
};

/// A function of the scene's, with the frame it was made in.
struct Closure : Cell {
  static constexpr ValueKind cell_kind = ValueKind::closure;
  Closure(const FunctionInfo& f, Ref<Frame> p) : function(&f), parent(std::move(p)) {}
  const FunctionInfo* function;
  Ref<Frame> parent;
  scene::FunctionRef compiled; ///< as a function of a point, once a property has asked for it
};

/// The value of `use`: the names of a file.
struct Module : Cell {
  static constexpr ValueKind cell_kind = ValueKind::module;
  Module(const ModuleInfo& m, Ref<Frame> f) : info(&m), frame(std::move(f)) {}
  const ModuleInfo* info;
  Ref<Frame> frame;
};

/// The values of the names of one call (or of one file, or of one iteration of a loop in which functions are made).
/// `parent` is the enclosing frame.
struct Frame : Cell {
  static constexpr ValueKind cell_kind = ValueKind::frame;
  Frame(Ref<Frame> p, std::uint32_t n);
  ~Frame();
  Value& operator[](std::uint32_t slot) { return slots()[slot]; }
  Value* slots() { return reinterpret_cast<Value*>(this + 1); }
  /// Drops all values: what they refer to may refer to the frame.
  void clear();

  Ref<Frame> parent;
  std::uint32_t size;
};
Ref<Frame> make_frame(Heap& heap, Ref<Frame> parent, std::uint32_t size);

Value make_string(Heap& heap, std::string text);
/// A list in its canonical form: two or three numbers are a `vector`.
Value make_list(Heap& heap, std::vector<Value> items);
Value make_record(Heap& heap, std::vector<Record::RecordEntry> entries);

/// How many elements a range has: floor((b − a)/step + 1e-9) + 1, one less if `..<` excludes the end. Infinite or NaN
/// if its numbers are; a step of 0 counts as NaN.
double count(const RangeValue& range, bool excludes_end);

/// Whether the value is a list, vector or range; the functions below require it.
bool is_sequence(const Value& value);
/// The number of elements; that of a range must have been checked to fit.
std::size_t sequence_size(const Value& value);
Value sequence_at(const Value& value, std::size_t i);

/// The nesting depth of lists, records and things in a value.
std::uint16_t depth_of(const Value& value);

/// Equality by content; functions are equal if they are the same.
bool equal(const Value& a, const Value& b);
/// Equal values have equal hashes.
std::uint64_t hash(const Value& value);

/// "a number", "a list", "a colour", "a sphere": for messages.
std::string describe(const Value& value);
/// "1 argument", "2 arguments".
std::string count_of_arguments(std::size_t count);
/// As `str` gives it and a session prints it; `names` knows the names of records' fields.
std::string format(const Value& value, const SymbolTable& names);

inline const std::string& Value::text() const {
  return static_cast<const String*>(expect(ValueKind::string).cell)->text;
}
inline const std::vector<Value>& Value::items() const {
  return static_cast<const List*>(expect(ValueKind::list).cell)->items;
}
inline const Record& Value::record() const {
  return *static_cast<const Record*>(expect(ValueKind::record).cell);
}
inline Closure& Value::closure() const {
  return *static_cast<Closure*>(expect(ValueKind::closure).cell);
}
inline Module& Value::module() const {
  return *static_cast<Module*>(expect(ValueKind::module).cell);
}

} // namespace rt::lang
