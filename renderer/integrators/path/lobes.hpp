#pragma once

#include "renderer/shading/whitted_bsdf.hpp"

namespace rt {

/// How a surface scatters light in the path integrator: Whitted's material, given a physical meaning. Each colour is
/// the share of the light that goes that way.
struct Lobes {
  Color diffuse;         ///< albedo of Lambert's reflection
  Color mirror;          ///< of a perfect mirror
  Color transmission;    ///< of perfect refraction
  double eta = 1;        ///< ior before the surface by the ior behind it
  double cos_behind = 1; ///< between the refracted ray and the normal
  bool is_bent = false;

  Color sum() const { return diffuse + mirror + transmission; }
};

/// The lobes of a material for light that comes with this `cosine` to the normal; `eta` and `fresnel_eta` as in
/// `WhittedBsdf::specular`. In Whitted's model the weights may sum to more than 1. Here no material makes light: where
/// it could, for any direction, all its weights are divided by the greatest sum, channel by channel.
Lobes lobes(const WhittedBsdf& bsdf, double cosine, double eta, double fresnel_eta);

} // namespace rt
