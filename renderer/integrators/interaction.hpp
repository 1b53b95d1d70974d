#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/integrators/recorder.hpp"
#include "renderer/shading/whitted_bsdf.hpp"

namespace rt {

/// A ray on its way, and what it has gathered.
struct PathState {
  RayKind kind;
  Ray ray;
  MediumStacks::List inside;    ///< the solids that the ray is inside of
  MediumStacks* media;          ///< where that list is
  std::uint32_t owned_from = 0; ///< lists from there on are this ray's own
  Contacts* contacts;
  Contacts::Position contact{};    ///< where it is among surfaces that touch
  std::uint32_t contacts_from = 0; ///< surfaces stored from there on are not needed by those it comes from
  Color sum = black;
  Color passed = white; ///< what surfaces that were crossed unbent let by
  Color weight = white; ///< of its light in the camera ray's; for recorders only
};

/// A ray has met a surface.
struct Interaction {
  PathState* path;
  double t;
  Surface surface;
  WhittedBsdf bsdf{};
  Vec3 normal{};     ///< the shading normal, turned to the viewer
  double cosine = 0; ///< between the ray and the normal, positive
  Color light{};     ///< what leaves the surface towards the viewer by itself
};

/// How a light reaches an interaction.
struct DirectLight {
  LightSample sample;
  double cos_light = 0;
  Color transmittance = white;
  bool is_facing() const { return cos_light > 0 && sample.color != black; }
};

/// Where the ray goes from an interaction.
struct Scattering {
  const Interaction* at;
  Medium medium; ///< behind the surface, or before it
  MediumTransition transition{};
  double eta = 1; ///< ior before the surface by the ior behind it
  SpecularTerms terms{};
  bool is_thin = false; ///< what passes is in the same medium as before
};

} // namespace rt
