#pragma once

#include "renderer/scattering/bsdf_sample.hpp"
#include "renderer/scattering/ggx.hpp"
#include "renderer/scattering/tables.hpp"

#include <optional>

namespace rt {

/// The tables of an interface between two media, for either side.
struct GlassSides {
  const GlassTables* here;
  const GlassTables* behind;
  const MirrorTables* mirror; ///< for the facets' own curve on this side
};

/// A surface that reflects and refracts, smooth or rough (Walter et al. 2007), including multiple scattering between
/// its facets. Transmission is weighted for basic radiance, L/n²: f(a, b)/n_b² = f(b, a)/n_a². Directions are in the
/// frame of the surface, `wo` on the side of +z, `wi` on either.
class GlassLobe {
public:
  /// `eta` is the ior behind the surface divided by the ior before it, not 1. A facet reflects `reflectance` and
  /// transmits `passed`, if `fresnel`, of what it does not reflect. The tables must be those of this eta and `fresnel`.
  GlassLobe(double alpha, double eta, const Reflectance& reflectance, const Color& passed, bool fresnel,
            const GlassSides& tables);

  bool is_perfect() const { return ggx_.is_smooth(); }

  /// The fraction of light from a direction of this cosine that is reflected, and its mean over the hemisphere.
  Color reflected_albedo(double cosine) const;
  Color mean_reflected_albedo() const;
  /// Reflected or transmitted.
  Color albedo(double cosine) const;

  /// Black and 0 if it is perfect.
  Color evaluate(const Vec3& wo, const Vec3& wi) const;
  double density(const Vec3& wo, const Vec3& wi) const;

  /// The weight and density of a rough one are left to `evaluate` and `density`.
  std::optional<BsdfSample> sample(const Vec3& wo, double u, double v, double choice) const;

private:
  /// What a facet does at this cosine, and the probability with which its reflection is sampled.
  struct FacetTerms {
    Color reflected, passed;
    double choice;
  };
  FacetTerms at_facet(double cosine) const;
  /// Light that leaves after several bounces, reflected and transmitted, as fractions of all; the probability that it
  /// is sampled, and within that the probability of the reflected part.
  struct Several {
    Color reflected, passed;
    double probability, choice;
  };
  Several several_bounces(double cosine) const;
  Vec3 facet_between(const Vec3& wo, const Vec3& wi) const;
  std::optional<Vec3> through(const Vec3& wo, const Vec3& h) const;
  /// The solid angle of h per solid angle of wi.
  double passed_stretch(const Vec3& wo, const Vec3& wi, const Vec3& h) const;

  Ggx ggx_;
  double eta_;
  Reflectance reflectance_;
  Color passed_;
  bool fresnel_;
  GlassSides tables_;
  RoughnessAxis::Place place_;
  double behind_share_ = 0; ///< of the light lost by single scattering
  Color returned_ = black;  ///< without Fresnel, the fraction of the light lost by a mirror that it returns
};

} // namespace rt
