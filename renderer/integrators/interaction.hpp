#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/integrators/pruning.hpp"
#include "renderer/integrators/recorder.hpp"
#include "renderer/shading/whitted_bsdf.hpp"

namespace rt {

/// What all rays that descend from one camera ray share.
struct RayTree {
  MediumStacks media;
  Contacts contacts;
  Pruning pruning;
};

/// A ray on its way, and what it has gathered.
struct PathState {
  RayKind kind;
  Ray ray;
  MediumStacks::List inside; ///< the media that contain the ray, a list in the tree's media
  RayTree* tree;
  std::uint32_t owned_from = 0;    ///< lists from there on belong to this ray
  Contacts::Position contact{};    ///< where it is among touching surfaces
  std::uint32_t contacts_from = 0; ///< surfaces stored from there on are not needed by the rays it descends from
  Color sum = black;
  Color passed = white; ///< the transmittance of the surfaces crossed unbent
  Color weight = white; ///< of its light in the camera ray's
};

/// A ray has hit a surface.
struct Interaction {
  PathState* path;
  double t;
  Surface surface;
  WhittedBsdf bsdf{};
  Vec3 normal{};     ///< the shading normal, flipped to the viewer's side of the surface
  double cosine = 0; ///< between the ray and the normal for reflection and refraction, not negative
  Color light{};     ///< emitted or reflected towards the viewer without further rays
};

/// How a light reaches an interaction.
struct DirectLight {
  LightSample sample;
  double cos_light = 0;
  Color transmittance = white;
  double left_out = 0; ///< the most it could have contributed to the camera ray, where no shadow ray is traced
  bool is_facing() const { return cos_light > 0 && sample.color != black && left_out == 0; }
};

/// Where the ray continues from an interaction.
struct Scattering {
  const Interaction* at;
  Medium medium; ///< behind the surface, or before it
  MediumTransition transition;
  double eta; ///< the ior before the surface divided by the ior behind it
  SpecularTerms terms;
  bool is_thin; ///< transmitted light is in the same medium as before
};

} // namespace rt
