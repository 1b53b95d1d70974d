#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/integrators/pruning.hpp"
#include "renderer/integrators/recorder.hpp"
#include "renderer/shading/whitted_bsdf.hpp"

namespace rt {

/// What the rays share that follow from one ray of the camera's.
struct RayTree {
  MediumStacks media;
  Contacts contacts;
  Pruning pruning;
};

/// A ray on its way, and what it has gathered.
struct PathState {
  RayKind kind;
  Ray ray;
  MediumStacks::List inside; ///< the solids that the ray is inside of, a list in the tree's media
  RayTree* tree;
  std::uint32_t owned_from = 0;    ///< lists from there on are this ray's own
  Contacts::Position contact{};    ///< where it is among surfaces that touch
  std::uint32_t contacts_from = 0; ///< surfaces stored from there on are not needed by those it comes from
  Color sum = black;
  Color passed = white; ///< what surfaces that were crossed unbent let by
  Color weight = white; ///< of its light in the camera ray's
};

/// A ray has met a surface.
struct Interaction {
  PathState* path;
  double t;
  Surface surface;
  WhittedBsdf bsdf{};
  Vec3 normal{};     ///< the shading normal, turned to the viewer's side of the surface
  double cosine = 0; ///< between the ray and the normal for what is mirrored and refracted, not negative
  Color light{};     ///< what leaves the surface towards the viewer by itself
};

/// How a light reaches an interaction.
struct DirectLight {
  LightSample sample;
  double cos_light = 0;
  Color transmittance = white;
  double left_out = 0; ///< the most it could have brought to the camera's ray, where nobody looks what is in its way
  bool is_facing() const { return cos_light > 0 && sample.color != black && left_out == 0; }
};

/// Where the ray goes from an interaction.
struct Scattering {
  const Interaction* at;
  Medium medium; ///< behind the surface, or before it
  MediumTransition transition;
  double eta; ///< ior before the surface by the ior behind it
  SpecularTerms terms;
  bool is_thin; ///< what passes is in the same medium as before
};

} // namespace rt
