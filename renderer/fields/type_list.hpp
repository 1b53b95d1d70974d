#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

namespace rt::scene {

/// A closed list of types: the kinds of shapes, patterns, lights, steps of a transform.
template <class... T>
struct TypeList {
  static constexpr std::uint32_t size = sizeof...(T);
  /// One of them.
  using Variant = std::variant<T...>;

  template <class S>
  static constexpr std::uint32_t index_of() {
    std::uint32_t i = 0;
    const bool found = ((std::is_same_v<S, T> || (++i, false)) || ...);
    return found ? i : size;
  }
  /// Calls f.operator()<T>() for each type, in order.
  template <class F>
  static constexpr void for_each(F&& f) {
    (f.template operator()<T>(), ...);
  }
};

namespace detail {
template <class A, class B>
struct Joined;
template <class... A, class... B>
struct Joined<TypeList<A...>, TypeList<B...>> {
  using Type = TypeList<A..., B...>;
};
} // namespace detail

/// The types of both lists.
template <class A, class B>
using Joined = typename detail::Joined<A, B>::Type;

} // namespace rt::scene
