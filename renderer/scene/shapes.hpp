#pragma once

#include "renderer/fields/type_list.hpp"
#include "renderer/scene/composite.hpp"
#include "renderer/scene/object.hpp"
#include "renderer/shapes/box.hpp"
#include "renderer/shapes/cone.hpp"
#include "renderer/shapes/cylinder.hpp"
#include "renderer/shapes/disc.hpp"
#include "renderer/shapes/plane.hpp"
#include "renderer/shapes/polygon.hpp"
#include "renderer/shapes/quad.hpp"
#include "renderer/shapes/sphere.hpp"
#include "renderer/shapes/triangle.hpp"

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace rt::scene {

/// All shapes; a shape's index here is its `ShapeRef::kind`. A new shape is added here, and its header above.
using ShapeKinds = TypeList<Sphere, Plane, Cylinder, Cone, Box, Disc, Triangle, Quad, Polygon, Group, Combination>;

template <class S>
inline constexpr std::uint32_t kind_of = ShapeKinds::index_of<S>();

/// Whether shapes of this kind consist of other objects.
template <class S>
inline constexpr bool is_composite = std::is_same_v<S, Group> || std::is_same_v<S, Combination>;

constexpr bool refers_to_composite(ShapeRef ref) {
  return ref.kind == kind_of<Group> || ref.kind == kind_of<Combination>;
}

/// All shapes of a scene, stored by kind. References stay valid when shapes are added; pointers do not.
class Shapes {
public:
  template <class S>
  ShapeRef add(S shape) {
    auto& list = all<S>();
    list.push_back(std::move(shape));
    return {kind_of<S>, static_cast<std::uint32_t>(list.size() - 1)};
  }
  template <class S>
  std::vector<S>& all() {
    return std::get<std::vector<S>>(lists_);
  }
  template <class S>
  const std::vector<S>& all() const {
    return std::get<std::vector<S>>(lists_);
  }
  /// `ref.kind` must be that of S.
  template <class S>
  const S& get(ShapeRef ref) const {
    return all<S>()[ref.index];
  }

  /// Calls f with the shape, whatever its type.
  template <class F>
  decltype(auto) visit(ShapeRef ref, F&& f) const {
    return visit_from<0>(ref, std::forward<F>(f));
  }

private:
  template <std::size_t I, class F>
  decltype(auto) visit_from(ShapeRef ref, F&& f) const {
    if constexpr (I + 1 < ShapeKinds::size) {
      if (ref.kind != I) return visit_from<I + 1>(ref, std::forward<F>(f));
    }
    return f(std::get<I>(lists_)[ref.index]);
  }

  template <class List>
  struct Storage;
  template <class... S>
  struct Storage<TypeList<S...>> {
    using Type = std::tuple<std::vector<S>...>;
  };
  Storage<ShapeKinds>::Type lists_;
};

/// The members of a group, or the operands of a combination.
inline const std::vector<Object>& parts(const Shapes& shapes, ShapeRef composite) {
  if (composite.kind == kind_of<Group>) return shapes.get<Group>(composite).members;
  return shapes.get<Combination>(composite).operands;
}

} // namespace rt::scene
