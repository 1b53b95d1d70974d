#pragma once

#include "renderer/fields/constraint.hpp"
#include "renderer/functions/function.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// A description type (shape, material, light, …) declares its properties once, as a table of `Field`s. Constructors,
/// type errors, suggestions, documentation and random tests all read that table; nothing else lists properties.
namespace rt::scene {

/// Index of a pattern in `Scene::patterns`.
enum class PatternId : std::uint32_t {};

/// A colour or a number, or a pattern that gives one at every point. Where a pattern gives colours and a number is
/// expected, the red channel is used.
using Paint = std::variant<Color, PatternId>;
using NumberPaint = std::variant<double, PatternId>;

/// What a pattern shows at a place between 0 and 1 of its own.
struct Stop {
  double place = 0;
  Paint shown = black;
  friend bool operator==(const Stop&, const Stop&) = default;
};
using Stops = std::vector<Stop>;

/// How light weakens with distance D from its source; `distance` is d, in scene lengths.
struct Fade {
  enum class Law : std::uint8_t { none, linear, quadratic, inverse_square }; // 1, 1/(1+D/d), 1/(1+(D/d)²), 1/D²
  Law law = Law::none;
  double distance = 1;
  friend bool operator==(const Fade&, const Fade&) = default;
};

/// The complex index of refraction n + ik of a metal, for each channel.
struct Metal {
  Color n = white, k = black;
  friend bool operator==(const Metal&, const Metal&) = default;
};

/// The fraction of white light that a medium transmits over `distance`, in scene units.
struct Absorb {
  Color color = white;
  double distance = 1;
  friend bool operator==(const Absorb&, const Absorb&) = default;
};

/// A value that knows whether it was specified: if not, it may be implied by something else that was.
template <class T>
class Implicit {
public:
  Implicit() = default;
  /// Specified.
  template <class U>
  requires(std::is_convertible_v<U, T> && !std::is_same_v<std::remove_cvref_t<U>, Implicit>) Implicit(U&& value)
      : value_(std::forward<U>(value)), is_written_(true) {}
  static Implicit unwritten(T value) {
    Implicit made(std::move(value));
    made.is_written_ = false;
    return made;
  }

  bool is_written() const { return is_written_; }
  const T& value() const { return value_; }
  operator const T&() const { return value_; }
  friend bool operator==(const Implicit&, const Implicit&) = default;
  /// Compares the value alone.
  friend bool operator==(const Implicit& a, const T& b) { return a.value_ == b; }

private:
  T value_{};
  bool is_written_ = false;
};

/// One of a field's `choices`, by index.
struct Choice {
  int index = 0;
  friend bool operator==(const Choice&, const Choice&) = default;
};

/// What kind of value a field takes.
enum class FieldType : std::uint8_t {
  number,
  boolean,
  vector,     ///< three numbers
  size,       ///< three numbers, or one number for all three
  color,      ///< a colour, or a number as linear grey
  points,     ///< a list of points
  choice,     ///< one of `Field::choices`, written as a bare name
  fade,       ///< linear(d), quadratic(d) or inverse_square
  resolution, ///< two whole numbers, width and height
  metal,      ///< a record of n and k, or a material that has one
  absorb,     ///< a record of a colour and a distance
  function,   ///< of a point
  stops,      ///< a list of places, each with what is shown there
};

/// Width and height in pixels.
using Resolution = std::array<int, 2>;

/// A function that descriptions share: it never changes.
using FunctionRef = std::shared_ptr<const Function>;
/// Of a point, the same number everywhere.
FunctionRef constant_function(double value);

using FieldValue = std::variant<double, bool, Vec3, Color, PatternId, std::vector<Vec3>, Choice, Fade, Resolution,
                                Metal, Absorb, FunctionRef, Stops>;

/// One property of a description type.
struct Field {
  std::string_view name;
  FieldType type;
  /// Properties of different forms are mutually exclusive (a plane is `normal` and `offset`, or `y`); 0 goes with every
  /// form.
  int form;
  Constraint constraint;
  std::string_view default_text; ///< as it would be written; empty if there is none
  std::string_view help;         ///< one line, with the unit
  std::span<const std::string_view> choices;
  bool is_textured; ///< it also takes a pattern
  /// Why it takes no pattern although one might expect it to; empty if nobody would.
  std::string_view constant_because;
  void (*set)(void* owner, const FieldValue& value);
  /// Empty if the property was not specified and has no default.
  std::optional<FieldValue> (*get)(const void* owner);
  /// How the owner's value violates the constraint. A pattern passes: it has fields of its own.
  std::optional<Violation> (*check)(const Field& field, const void* owner);
};

namespace detail {

template <class Member>
struct MemberOf;
template <class O, class T>
struct MemberOf<T O::*> {
  using Owner = O;
  using Type = T;
};

template <class T>
struct Unwrap {
  using Type = T;
};
template <class T>
struct Unwrap<std::optional<T>> {
  using Type = T;
};
template <class T>
struct Unwrap<Implicit<T>> {
  using Type = T;
};

template <class T>
constexpr bool is_optional = false;
template <class T>
constexpr bool is_optional<std::optional<T>> = true;

template <class T>
constexpr bool is_points = std::is_same_v<T, std::vector<Vec3>>;
template <std::size_t N>
constexpr bool is_points<std::array<Vec3, N>> = true;

template <class T>
constexpr bool is_paint = std::is_same_v<T, Paint> || std::is_same_v<T, NumberPaint>;

template <class T>
FieldValue to_value(const T& member) {
  if constexpr (is_paint<T>)
    return std::visit([](const auto& shown) -> FieldValue { return shown; }, member);
  else if constexpr (std::is_enum_v<T>)
    return Choice{static_cast<int>(member)};
  else if constexpr (std::is_same_v<T, int>)
    return static_cast<double>(member);
  else if constexpr (is_points<T>)
    return std::vector<Vec3>(member.begin(), member.end());
  else
    return member;
}

/// A number serves as grey where a colour is expected; a colour's red channel where a number is.
template <class T>
T paint_from(const FieldValue& value) {
  constexpr bool is_number = std::is_same_v<T, NumberPaint>;
  if (const PatternId* pattern = std::get_if<PatternId>(&value)) return *pattern;
  const Color* color = std::get_if<Color>(&value);
  if constexpr (is_number)
    return color ? color->r : std::get<double>(value);
  else
    return color ? *color : grey(std::get<double>(value));
}

template <class T>
T from_value(const FieldValue& value) {
  if constexpr (is_paint<T>)
    return paint_from<T>(value);
  else if constexpr (std::is_enum_v<T>)
    return static_cast<T>(std::get<Choice>(value).index);
  else if constexpr (std::is_same_v<T, int>)
    return static_cast<int>(std::get<double>(value));
  else if constexpr (is_points<T> && !std::is_same_v<T, std::vector<Vec3>>) {
    T points{};
    const auto& given = std::get<std::vector<Vec3>>(value);
    for (std::size_t i = 0; i < points.size() && i < given.size(); ++i) points[i] = given[i];
    return points;
  } else
    return std::get<T>(value);
}

inline std::optional<Violation> check_choice(const Field& field, int index) {
  if (index >= 0 && static_cast<std::size_t>(index) < field.choices.size()) return std::nullopt;
  return Violation{Violation::Kind::out_of_bounds, "must be one of its choices", "this is none"};
}

/// What a metal and a medium consist of: n above 0, k at least 0; a colour from 0 to 1.
inline std::optional<Violation> check_metal(const Metal& metal) {
  if (auto violation = check(positive, metal.n)) return violation;
  return check(not_negative, metal.k);
}
inline std::optional<Violation> check_absorb(const Absorb& absorb) {
  if (auto violation = check(zero_to_one, absorb.color)) return violation;
  return check(positive, absorb.distance);
}

template <class T>
std::optional<Violation> check_points(const Field& field, const T& points) {
  for (const Vec3& point : points)
    if (auto violation = check(field.constraint, point)) return violation;
  return check_count(field.constraint, points.size());
}

std::optional<Violation> check_function(const FunctionRef& function);
std::optional<Violation> check_stops(const Stops& stops);

template <class T>
std::optional<Violation> check_value(const Field& field, const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    return std::nullopt;
  else if constexpr (std::is_enum_v<T>)
    return check_choice(field, static_cast<int>(value));
  else if constexpr (is_points<T>)
    return check_points(field, value);
  else if constexpr (std::is_same_v<T, Fade>)
    return check(positive, value.distance);
  else if constexpr (std::is_same_v<T, Metal>)
    return check_metal(value);
  else if constexpr (std::is_same_v<T, Absorb>)
    return check_absorb(value);
  else if constexpr (std::is_same_v<T, FunctionRef>)
    return check_function(value);
  else if constexpr (std::is_same_v<T, Stops>)
    return check_stops(value);
  else if constexpr (std::is_same_v<T, Resolution>)
    return check(field.constraint, Vec3{static_cast<double>(value[0]), static_cast<double>(value[1]), 1.0});
  else if constexpr (is_paint<T>)
    return value.index() == 0 ? check(field.constraint, std::get<0>(value)) : std::nullopt;
  else if constexpr (std::is_same_v<T, Vec3>)
    return field.type == FieldType::size ? check_size(field.constraint, value) : check(field.constraint, value);
  else if constexpr (std::is_same_v<T, Color>)
    return check(field.constraint, value);
  else
    return check(field.constraint, static_cast<double>(value));
}

template <class T>
constexpr FieldType default_type() {
  if constexpr (std::is_same_v<T, bool>)
    return FieldType::boolean;
  else if constexpr (std::is_same_v<T, Vec3>)
    return FieldType::vector;
  else if constexpr (std::is_same_v<T, Color> || std::is_same_v<T, Paint>)
    return FieldType::color;
  else if constexpr (std::is_same_v<T, Fade>)
    return FieldType::fade;
  else if constexpr (std::is_same_v<T, Resolution>)
    return FieldType::resolution;
  else if constexpr (std::is_same_v<T, Metal>)
    return FieldType::metal;
  else if constexpr (std::is_same_v<T, Absorb>)
    return FieldType::absorb;
  else if constexpr (std::is_same_v<T, FunctionRef>)
    return FieldType::function;
  else if constexpr (std::is_same_v<T, Stops>)
    return FieldType::stops;
  else if constexpr (is_points<T>)
    return FieldType::points;
  else if constexpr (std::is_enum_v<T>)
    return FieldType::choice;
  else
    return FieldType::number;
}

} // namespace detail

/// What a field table says about a member beyond its name and type.
struct FieldText {
  std::string_view default_text;
  std::string_view help;
  Constraint constraint = any_value;
  int form = 0;
  std::optional<FieldType> type = std::nullopt; ///< where the member's type alone does not determine it
  std::span<const std::string_view> choices = {};
  std::string_view constant_because = {};
};

/// The table row for `Member`, a pointer to a data member: `field<&Sphere::radius>("radius", {.default_text = "1",
/// …})`. `set` expects the FieldValue alternative that belongs to the member's type. A member that is a paint takes
/// patterns.
template <auto Member>
constexpr Field field(std::string_view name, const FieldText& text) {
  using Owner = typename detail::MemberOf<decltype(Member)>::Owner;
  using Stored = typename detail::MemberOf<decltype(Member)>::Type;
  using T = typename detail::Unwrap<Stored>::Type;
  return {
      name,
      text.type.value_or(detail::default_type<T>()),
      text.form,
      text.constraint,
      text.default_text,
      text.help,
      text.choices,
      detail::is_paint<T>,
      text.constant_because,
      [](void* owner, const FieldValue& value) { static_cast<Owner*>(owner)->*Member = detail::from_value<T>(value); },
      [](const void* owner) -> std::optional<FieldValue> {
        const Stored& member = static_cast<const Owner*>(owner)->*Member;
        if constexpr (!detail::is_optional<Stored>)
          return detail::to_value<T>(member);
        else
          return member ? std::optional<FieldValue>(detail::to_value<T>(*member)) : std::nullopt;
      },
      [](const Field& self, const void* owner) -> std::optional<Violation> {
        const Stored& member = static_cast<const Owner*>(owner)->*Member;
        if constexpr (!detail::is_optional<Stored>)
          return detail::check_value<T>(self, member);
        else
          return member ? detail::check_value<T>(self, *member) : std::nullopt;
      }};
}

/// Puts f(id) in the place of each pattern that the owner's fields show.
template <class F>
void replace_patterns(std::span<const Field> table, void* owner, F&& f) {
  for (const Field& field : table) {
    if (!field.is_textured && field.type != FieldType::stops) continue;
    std::optional<FieldValue> value = field.get(owner);
    if (!value) continue;
    if (const PatternId* pattern = std::get_if<PatternId>(&*value)) field.set(owner, f(*pattern));
    if (Stops* stops = std::get_if<Stops>(&*value)) {
      for (Stop& stop : *stops)
        if (PatternId* pattern = std::get_if<PatternId>(&stop.shown)) *pattern = f(*pattern);
      field.set(owner, *value);
    }
  }
}

/// Calls f(id) for each.
template <class F>
void for_each_pattern(std::span<const Field> table, const void* owner, F&& f) {
  for (const Field& field : table) {
    if (!field.is_textured && field.type != FieldType::stops) continue;
    const std::optional<FieldValue> value = field.get(owner);
    if (!value) continue;
    if (const PatternId* pattern = std::get_if<PatternId>(&*value)) f(*pattern);
    if (const Stops* stops = std::get_if<Stops>(&*value))
      for (const Stop& stop : *stops)
        if (const PatternId* pattern = std::get_if<PatternId>(&stop.shown)) f(*pattern);
  }
}

/// Why a description that satisfies every field's constraint is still not a valid shape, light, …: two points coincide,
/// a polygon is not planar. `field` is the property to blame, `advice` a fix where the message does not imply one.
struct Problem {
  std::string_view field;
  std::string message;
  std::string advice = {};
};

} // namespace rt::scene
