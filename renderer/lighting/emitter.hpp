#pragma once

#include "renderer/compile/geometries.hpp"
#include "renderer/lighting/light_tree.hpp"
#include "renderer/math/affine.hpp"

#include <optional>
#include <variant>

/// Shapes that emit light, as area lights that can be sampled.
namespace rt {

/// A geometry whose surface can be sampled.
template <class G>
concept Drawable = requires(const G& g) {
  area(lamp_surface(g));
};

namespace detail {

template <class T, class Variant>
struct AppendOnce;
template <class T, class... Known>
struct AppendOnce<T, std::variant<Known...>> {
  using Type = std::conditional_t<(std::is_same_v<T, Known> || ...), std::variant<Known...>, std::variant<Known..., T>>;
};

template <class Variant, class... G>
struct LampSurfacesFrom {
  using Type = Variant;
};
template <class Variant, class G, class... Rest>
struct LampSurfacesFrom<Variant, G, Rest...> {
  static auto next() {
    if constexpr (Drawable<G>)
      return
          typename AppendOnce<std::remove_cvref_t<decltype(lamp_surface(std::declval<const G&>()))>, Variant>::Type{};
    else
      return Variant{};
  }
  using Type = typename LampSurfacesFrom<decltype(next()), Rest...>::Type;
};

template <class Tuple>
struct LampSurfacesOf;
template <class... G>
struct LampSurfacesOf<std::tuple<G...>> {
  using Type = typename LampSurfacesFrom<std::variant<SphereGeometry>, G...>::Type;
};

} // namespace detail

/// What the points of any lamp are sampled on.
using LampSurface = detail::LampSurfacesOf<Geometries>::Type;

/// A direction towards a lamp.
struct EmitterSample {
  Vec3 direction;  ///< unit
  double distance; ///< to the point of the lamp
};

/// An emitting surface in scene space. Its points are sampled by area; those of a sphere seen from outside by solid
/// angle.
class Emitter {
public:
  /// The surface, and the map that places it. Nothing if it has no finite area.
  static std::optional<Emitter> make(const LampSurface& surface, const Affine& to_scene);

  /// Samples a direction from p, for uniform u and v; nothing if p is a point of the lamp itself.
  std::optional<EmitterSample> sample(const Vec3& p, double u, double v) const;
  /// The density, per solid angle, with which that samples the direction (unit) from p to a point of the lamp.
  double density(const Vec3& p, const Vec3& direction, const Vec3& point, const Vec3& normal) const;

  /// Any point of the surface.
  AreaPoint point(double u, double v) const;
  /// Approximate, where the map stretches it.
  double surface_area() const;
  /// As a lamp of this power.
  LightBounds bounds(double power) const;

private:
  Emitter(const LampSurface& surface, const Affine& to_scene, bool is_mapped);
  /// The sphere as which it is seen from p, if it is one and p lies outside.
  const SphereGeometry* ball_seen_from(const Vec3& p) const;
  /// The factor by which the map enlarges the surface where this is its normal, in scene space.
  double enlargement(const Vec3& normal) const;

  LampSurface surface_;
  Affine to_scene_;
  bool is_mapped_; ///< the map is not the identity
  double area_;    ///< before the map
};

} // namespace rt
