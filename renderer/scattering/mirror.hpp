#pragma once

#include "renderer/scattering/bsdf_sample.hpp"
#include "renderer/scattering/ggx.hpp"
#include "renderer/scattering/tables.hpp"

#include <optional>

namespace rt {

/// A surface that reflects, smooth or rough, including multiple scattering between its facets. Directions are in the
/// frame of the surface, on the viewer's side.
class MirrorLobe {
public:
  /// The tables must be those of the reflectance's curve and include this α; they must outlive it. `absorbed` makes it
  /// the outside of a thin sheet whose inside transmits this fraction of light; the reflectance is then that of one
  /// side, and the tables those of FresnelCurve::Kind::sheet.
  MirrorLobe(double alpha, const Reflectance& reflectance, const MirrorTables& tables,
             std::optional<Color> absorbed = std::nullopt);

  bool is_perfect() const { return ggx_.is_smooth(); }

  /// The fraction of light from a direction of this cosine that it reflects (for a thin sheet: at least that); and its
  /// mean over the hemisphere.
  Color albedo(double cosine) const;
  Color mean_albedo() const;

  /// Of one facet.
  Color reflectance(double cosine) const {
    const Color side = reflectance_.at(cosine);
    return absorbed_ ? sheet_terms(side, *absorbed_).reflected : side;
  }

  /// Black and 0 if it is perfect.
  Color evaluate(const Vec3& wo, const Vec3& wi) const;
  double density(const Vec3& wo, const Vec3& wi) const;

  /// `choice` in [0, 1) selects single or multiple scattering. The weight and density of a rough one are left to
  /// `evaluate` and `density`.
  std::optional<BsdfSample> sample(const Vec3& wo, double u, double v, double choice) const;

private:
  double several_bounces(double cosine) const; // probability

  Ggx ggx_;
  Reflectance reflectance_; ///< of a facet's outer side
  Reflectance known_;       ///< the one that the tables are for: the same, or that of a clear sheet
  std::optional<Color> absorbed_;
  const MirrorTables* tables_;
  RoughnessAxis::Place place_;
  Color returned_ = black; ///< fraction of the light lost by single scattering
};

} // namespace rt
