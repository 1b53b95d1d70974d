#pragma once

#include "renderer/compile/hit_rules.hpp"
#include "renderer/compile/placed_shape.hpp"
#include "renderer/compile/povray_box.hpp"
#include "renderer/scene/scene.hpp"

#include <tuple>
#include <utility>
#include <variant>

/// Lists of types over all kinds of shapes. They are derived from `scene::ShapeKinds`, so a new shape needs nothing
/// here.
namespace rt {

template <class S>
using GeometryOf = decltype(geometry(std::declval<const S&>()));

namespace detail {

template <class... Tuple>
using Joined = decltype(std::tuple_cat(std::declval<Tuple>()...));

// A type, or none of it.
template <bool is_wanted, class... T>
struct Either {
  using Type = std::tuple<>;
};
template <class... T>
struct Either<true, T...> {
  using Type = std::tuple<T...>;
};

template <class S>
struct GeometryOfShape {
  static_assert(Solidlike<GeometryOf<S>> ||
                    std::is_same_v<decltype(is_solid(std::declval<GeometryOf<S>>())), std::false_type>,
                "a solid says where lines cross it and which points it contains: without that it would be no operand");
  using Type = std::tuple<GeometryOf<S>>;
};
template <>
struct GeometryOfShape<scene::Group> : Either<false> {};
template <>
struct GeometryOfShape<scene::Combination> : Either<false> {};

template <class List>
struct GeometriesOf;
template <class... S>
struct GeometriesOf<scene::TypeList<S...>> {
  using Type = Joined<typename GeometryOfShape<S>::Type..., std::tuple<SmoothTriangleGeometry, PovrayBoxGeometry>>;
};

template <class Tuple>
struct OperandsOf;
template <class... G>
struct OperandsOf<std::tuple<G...>> {
  template <class... P>
  static std::variant<P...> as_variant(std::tuple<P...>*);
  using Type = decltype(as_variant(
      static_cast<Joined<typename Either<Solidlike<G>, Baked<G>, Transformed<G>>::Type...>*>(nullptr)));
};

} // namespace detail

/// The geometry of every shape, the triangle with vertex normals, and POV-Ray's box.
using Geometries = detail::GeometriesOf<scene::ShapeKinds>::Type;

/// A shape of any kind that has an inside, placed in either way.
using SolidShape = detail::OperandsOf<Geometries>::Type;

/// Calls `add` with each of the geometries that the shape is traced as. Together they form one object.
template <class S, class Add>
void for_each_geometry(const S& shape, HitRules rules, Add&& add) {
  if constexpr (std::is_same_v<S, scene::Box>) {
    if (rules == HitRules::povray) return add(PovrayBoxGeometry{geometry(shape)});
  }
  if constexpr (std::is_same_v<S, scene::Triangle>) {
    const auto& n = shape.normals;
    if (n.size() == 3) return add(SmoothTriangleGeometry{geometry(shape), {n[0], n[1], n[2]}});
  }
  add(geometry(shape));
}

} // namespace rt
