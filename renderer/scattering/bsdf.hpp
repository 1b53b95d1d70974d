#pragma once

#include "renderer/scattering/glass.hpp"
#include "renderer/scattering/lambert.hpp"
#include "renderer/scattering/material_tables.hpp"
#include "renderer/scattering/mirror.hpp"
#include "renderer/shading/materials.hpp"

namespace rt {

/// By how much a material's weights, taken as they are written, would make light, for each channel: 1 where they do
/// not. `Bsdf` divides all of them by it.
Color excess(const MaterialValues& values);

/// How a surface scatters light that is looked at from one direction: a coat on a mirror or glass on a matte ground,
/// each of which may be missing. No channel gives back more light than it gets, and rough surfaces lose none. What
/// passes is weighted for basic radiance, L/n², so that f(a, b)/n_b² = f(b, a)/n_a².
///
/// Directions are unit vectors in the frame of the surface: +z is the shading normal, turned to the viewer; `wo` points
/// to him, `wi` to where light comes from.
class Bsdf {
public:
  /// `eta` is the ior behind the surface by the ior before it. `wo.z` must be positive. The tables must be the
  /// material's, and outlive it.
  Bsdf(const MaterialValues& values, const MaterialTables& tables, double eta, const Vec3& wo);

  const Vec3& wo() const { return wo_; }

  /// Whether a direction chosen otherwise than by `sample` may bring light: not everything is perfectly sharp.
  bool has_spread() const;

  /// f(wo, wi), without the cosine; and the density with which `sample` finds wi, for each solid angle. Perfect mirrors
  /// and glass count nothing.
  Color evaluate(const Vec3& wi) const;
  double density(const Vec3& wi) const;

  /// Nothing where light is lost: the surface is black, or the chosen direction leads into it. All three numbers are in
  /// [0, 1).
  std::optional<BsdfSample> sample(double u, double v, double choice) const;

  /// The share of light from straight behind that passes unbent.
  const Color& passed_straight() const { return straight_; }

  /// The share of all light that comes back or passes, seen from `wo`.
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
  bool is_glossy_ = false; ///< the mirror is a highlight, which lies on glass, too
  Color straight_ = black;
  LambertLobe ground_;  ///< with what of `wo` reaches it
  Color shares_[lobes]; ///< albedos
  double probabilities_[lobes] = {};
};

} // namespace rt
