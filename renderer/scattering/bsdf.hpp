#pragma once

#include "renderer/scattering/glass.hpp"
#include "renderer/scattering/lambert.hpp"
#include "renderer/scattering/material_tables.hpp"
#include "renderer/scattering/mirror.hpp"
#include "renderer/shading/materials.hpp"

namespace rt {

/// The factor, per channel, by which a material's weights as written would exceed energy conservation: 1 if they do
/// not. `Bsdf` divides all of them by it.
Color excess(const MaterialValues& values);

/// How a surface scatters light towards one direction: a coat over a mirror or glass over a matte ground, each of which
/// may be absent. No channel reflects more light than it receives, and rough surfaces lose none. Transmission is
/// weighted for basic radiance, L/n², so that f(a, b)/n_b² = f(b, a)/n_a².
///
/// Directions are unit vectors in the frame of the surface: +z is the shading normal, facing the viewer; `wo` points to
/// the viewer, `wi` to where light comes from.
class Bsdf {
public:
  /// `eta` is the ior behind the surface divided by the ior before it. `wo.z` must be positive. The tables must be the
  /// material's, and outlive it.
  Bsdf(const MaterialValues& values, const MaterialTables& tables, double eta, const Vec3& wo);

  const Vec3& wo() const { return wo_; }

  /// Whether `evaluate` can be nonzero: not every lobe is a delta distribution.
  bool has_spread() const;

  /// f(wo, wi), without the cosine; and the density, per solid angle, with which `sample` finds wi. Perfect mirrors and
  /// glass are excluded.
  Color evaluate(const Vec3& wi) const;
  double density(const Vec3& wi) const;

  /// Nothing if the path is absorbed: the surface is black, or the sampled direction leads into it. All three numbers
  /// are in [0, 1).
  std::optional<BsdfSample> sample(double u, double v, double choice) const;

  /// The fraction of light from straight behind that is transmitted unbent.
  const Color& passed_straight() const { return straight_; }

  /// The fraction of all light that is reflected or transmitted towards `wo`.
  Color albedo() const;

private:
  static constexpr int lobes = 5; // coat, mirror, glass, straight, ground
  void layer_gloss(const MaterialValues& values, const MaterialTables& tables, double eta, const Color& share);
  Color below_coat(double cosine) const;
  Color below_mirror(double cosine) const;
  Color below_all(double cosine) const;
  Color mean_below_all() const;
  void set_probabilities();
  std::optional<BsdfSample> sample_lobe(int lobe, double u, double v, double choice) const;
  Color attenuation(int lobe, double cosine) const;

  Vec3 wo_;
  std::optional<MirrorLobe> coat_, mirror_;
  std::optional<GlassLobe> glass_;
  bool is_glossy_ = false; ///< the mirror is a highlight, which glass can have, too
  Color straight_ = black;
  LambertLobe ground_;  ///< scaled by the fraction of light towards `wo` that gets past the layers above
  Color shares_[lobes]; ///< albedos
  double probabilities_[lobes] = {};
};

} // namespace rt
