#pragma once

#include "renderer/scene/light.hpp"

#include <optional>
#include <utility>
#include <variant>

namespace rt {

namespace detail {

template <class List>
struct EmittersOf;
template <class... L>
struct EmittersOf<scene::TypeList<L...>> {
  using Type = std::variant<decltype(placed(std::declval<const L&>(), std::declval<const Affine&>()))...>;
};

} // namespace detail

/// A light of the description transformed to scene space, ready for shading.
struct Light {
  detail::EmittersOf<scene::LightKinds>::Type emitter;
  Color color{};       ///< colour times intensity
  bool shadows = true; ///< false: nothing blocks it, and it gives diffuse light only
};

Light make_light(const scene::Light& light);

inline LightExtent extent(const Light& light) {
  return std::visit([](const auto& emitter) { return extent(emitter); }, light.emitter);
}

/// Where it stands; nothing where it shines from infinitely far away.
std::optional<Vec3> position(const Light& light);

/// At `p`, which must not be the light's position (then `distance` is 0 and the rest meaningless).
inline LightSample sample_light(const Light& light, const Vec3& p) {
  LightSample sample = std::visit([&](const auto& emitter) { return sample_light(emitter, p); }, light.emitter);
  sample.color = light.color * (sample.fade * sample.spot);
  return sample;
}

} // namespace rt
