#include "renderer/scattering/mirror.hpp"

#include "renderer/scattering/multiple_scattering.hpp"

#include <numbers>

namespace rt {
MirrorLobe::MirrorLobe(double alpha, const Reflectance& reflectance, const MirrorTables& tables,
                       std::optional<Color> absorbed)
    : ggx_(alpha), reflectance_(reflectance), known_(reflectance), absorbed_(absorbed), tables_(&tables),
      place_(tables.find(alpha)) {
  if (absorbed_) known_ = {{FresnelCurve::Kind::sheet, reflectance.curve.eta}, black, white, black};
  if (is_perfect()) return;
  const Color mean = tables.mean_reflectance(known_);
  returned_ = returned_share(mean, mean, tables.mean_energy(place_));
}

Color MirrorLobe::albedo(double cosine) const {
  if (is_perfect()) return known_.at(cosine);
  return tables_->albedo(known_, place_, cosine) + returned_ * (1 - tables_->energy(place_, cosine));
}

Color MirrorLobe::mean_albedo() const {
  if (is_perfect()) return tables_->mean_reflectance(known_);
  return tables_->mean_albedo(known_, place_) + returned_ * (1 - tables_->mean_energy(place_));
}

double MirrorLobe::several_bounces(double cosine) const {
  const double several = max_component(returned_) * (1 - tables_->energy(place_, cosine));
  return several > 0 ? several / max_component(albedo(cosine)) : 0;
}

Color MirrorLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (is_perfect() || wo.z <= 0 || wi.z <= 0) return black;
  const Vec3 h = normalize(wo + wi);
  const double facets = ggx_.distribution(h) * ggx_.reflected_visibility(wo.z, wi.z);
  const double lost_o = 1 - tables_->energy(place_, wo.z), lost_i = 1 - tables_->energy(place_, wi.z);
  const double lost = std::numbers::pi * (1 - tables_->mean_energy(place_));
  const Color several = lost > 0 ? returned_ * (lost_o * lost_i / lost) : black;
  return reflectance(dot(wo, h)) * facets + several;
}

double MirrorLobe::density(const Vec3& wo, const Vec3& wi) const {
  if (is_perfect() || wo.z <= 0 || wi.z <= 0) return 0;
  const Vec3 h = normalize(wo + wi);
  const double several = several_bounces(wo.z);
  return (1 - several) * ggx_.visible_density(wo, h) / (4 * dot(wo, h)) + several * several_bounces_density(wi.z);
}

std::optional<BsdfSample> MirrorLobe::sample(const Vec3& wo, double u, double v, double choice) const {
  BsdfSample sample;
  if (is_perfect()) {
    sample.wi = {-wo.x, -wo.y, wo.z};
    sample.weight = reflectance(wo.z);
    sample.density = 1;
    sample.is_perfect = true;
    return sample;
  }
  if (choice < several_bounces(wo.z)) {
    sample.wi = sample_several_bounces(u, v);
  } else {
    const Vec3 h = ggx_.sample_visible(wo, u, v);
    sample.wi = normalize(h * (2 * dot(wo, h)) - wo);
  }
  if (sample.wi.z <= 0) return std::nullopt;
  return sample;
}

} // namespace rt
