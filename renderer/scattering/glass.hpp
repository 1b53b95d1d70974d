#pragma once

#include "renderer/scattering/bsdf_sample.hpp"
#include "renderer/scattering/ggx.hpp"
#include "renderer/scattering/tables.hpp"

#include <optional>

namespace rt {

/// The tables of a surface between two media, for one side and the other.
struct GlassSides {
  const GlassTables* here;
  const GlassTables* behind;
  const MirrorTables* mirror; ///< of the facets' own curve on this side
};

/// A surface that mirrors and refracts, smooth or rough (Walter et al. 2007), with the light of all bounces between its
/// facets. What passes is weighted for basic radiance, L/n²: f(a, b)/n_b² = f(b, a)/n_a². Directions are in the frame
/// of the surface, `wo` on the side of +z, `wi` on either.
class GlassLobe {
public:
  /// `eta` is the ior behind the surface by the ior before it, not 1. A facet mirrors `reflectance` and passes
  /// `passed`, if `fresnel`, of what it does not mirror. The tables must be those of this eta and `fresnel`.
  GlassLobe(double alpha, double eta, const Reflectance& reflectance, const Color& passed, bool fresnel,
            const GlassSides& tables);

  bool is_perfect() const { return ggx_.is_smooth(); }

  /// Share of the light from a direction of this cosine that is mirrored, and its mean over the hemisphere.
  Color reflected_albedo(double cosine) const;
  Color mean_reflected_albedo() const;
  /// Mirrored or passed.
  Color albedo(double cosine) const;

  /// Black and 0 where it is perfect.
  Color evaluate(const Vec3& wo, const Vec3& wi) const;
  double density(const Vec3& wo, const Vec3& wi) const;

  /// The weight and density of a rough one are left to `evaluate` and `density`.
  std::optional<BsdfSample> sample(const Vec3& wo, double u, double v, double choice) const;

private:
  /// What a facet does at this cosine, and the probability with which its mirror is followed.
  struct FacetTerms {
    Color reflected, passed;
    double choice;
  };
  FacetTerms at_facet(double cosine) const;
  /// Light that leaves after several bounces, mirrored and passed, as shares of all; the probability that it is
  /// followed, and in it that of the mirrored part.
  struct Several {
    Color reflected, passed;
    double probability, choice;
  };
  Several several_bounces(double cosine) const;
  Vec3 facet_between(const Vec3& wo, const Vec3& wi) const;
  std::optional<Vec3> through(const Vec3& wo, const Vec3& h) const;
  /// Solid angle of h for each of wi.
  double passed_stretch(const Vec3& wo, const Vec3& wi, const Vec3& h) const;

  Ggx ggx_;
  double eta_;
  Reflectance reflectance_;
  Color passed_;
  bool fresnel_;
  GlassSides tables_;
  RoughnessAxis::Place place_;
  double behind_share_ = 0; ///< of the light lost by one bounce
  Color returned_ = black;  ///< without Fresnel, share of the light that a mirror loses
};

} // namespace rt
