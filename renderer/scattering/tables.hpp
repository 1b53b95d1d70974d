#pragma once

#include "renderer/scattering/albedo_table.hpp"
#include "renderer/scattering/fresnel.hpp"

namespace rt {

/// What is tabulated for a reflecting surface: the single-scattering albedos for a Fresnel curve.
class MirrorTables {
public:
  MirrorTables(const RoughnessAxis& axis, const FresnelCurve& curve);

  RoughnessAxis::Place find(double alpha) const { return axis_.find(alpha); }

  /// E: every facet reflects everything. 1 for a smooth surface.
  double energy(RoughnessAxis::Place place, double cosine) const { return energy_.at(place, cosine); }
  double mean_energy(RoughnessAxis::Place place) const { return energy_.mean(place); }

  /// The albedo if the facets reflect `reflectance`, whose curve must be this one; and its mean over the hemisphere.
  Color albedo(const Reflectance& reflectance, RoughnessAxis::Place place, double cosine) const {
    return reflectance.constant * energy_.at(place, cosine) + reflectance.weight * curve_.at(place, cosine) +
           reflectance.tint * tinted_.at(place, cosine);
  }
  Color mean_albedo(const Reflectance& reflectance, RoughnessAxis::Place place) const {
    return reflectance.constant * energy_.mean(place) + reflectance.weight * curve_.mean(place) +
           reflectance.tint * tinted_.mean(place);
  }
  /// The mean of a facet's own reflectance over the hemisphere, F_avg.
  Color mean_reflectance(const Reflectance& reflectance) const {
    return reflectance.constant + reflectance.weight * mean_curve_ + reflectance.tint * mean_tinted_;
  }

private:
  RoughnessAxis axis_;
  AlbedoTable<double> energy_;
  AlbedoTable<Color> curve_, tinted_;
  Color mean_curve_, mean_tinted_;
};

/// What is tabulated for clear glass, seen from the side from which the other side's ior is `eta` times as large.
class GlassTables {
public:
  /// Without `fresnel` a facet transmits everything except on total internal reflection.
  GlassTables(const RoughnessAxis& axis, double eta, bool fresnel);

  RoughnessAxis::Place find(double alpha) const { return axis_.find(alpha); }
  double reflected(RoughnessAxis::Place place, double cosine) const { return reflected_.at(place, cosine); }
  double mean_reflected(RoughnessAxis::Place place) const { return reflected_.mean(place); }
  double transmitted(RoughnessAxis::Place place, double cosine) const { return transmitted_.at(place, cosine); }
  /// Both together: E.
  double energy(RoughnessAxis::Place place, double cosine) const {
    return reflected_.at(place, cosine) + transmitted_.at(place, cosine);
  }
  double mean_energy(RoughnessAxis::Place place) const { return reflected_.mean(place) + transmitted_.mean(place); }
  /// The mean of a facet's own reflectance over the hemisphere.
  double mean_reflectance() const { return mean_reflectance_; }

private:
  RoughnessAxis axis_;
  AlbedoTable<double> reflected_, transmitted_;
  double mean_reflectance_;
};

/// The cosine-weighted mean of Fresnel's reflectance over the hemisphere. `eta` is as fresnel_reflectance takes
/// it.
double mean_fresnel_reflectance(double eta);

} // namespace rt
