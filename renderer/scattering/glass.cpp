#include "renderer/scattering/glass.hpp"

#include "renderer/scattering/multiple_scattering.hpp"

#include <numbers>

namespace rt {
namespace {

double ratio(double part, double rest) {
  return part > 0 ? part / (part + rest) : 0;
}

} // namespace

GlassLobe::GlassLobe(double alpha, double eta, const Reflectance& reflectance, const Color& passed, bool fresnel,
                     const GlassSides& tables)
    : ggx_(alpha), eta_(eta), reflectance_(reflectance), passed_(passed), fresnel_(fresnel), tables_(tables),
      place_(tables.here->find(alpha)) {
  if (is_perfect()) return;
  behind_share_ = transmitted_share(tables.here->mean_reflectance(), tables.here->mean_energy(place_),
                                    tables.behind->mean_energy(place_));
  if (fresnel) return;
  const Color mean = tables.mirror->mean_reflectance(reflectance);
  returned_ = returned_share(mean, mean + passed, tables.mirror->mean_energy(place_));
}

GlassLobe::FacetTerms GlassLobe::at_facet(double cosine) const {
  if (1 - cosine * cosine >= eta_ * eta_) return {white, black, 1};
  FacetTerms terms{reflectance_.at(cosine), passed_, 0};
  if (fresnel_) terms.passed *= white - terms.reflected;
  terms.choice = ratio(max_component(terms.reflected), max_component(terms.passed));
  return terms;
}

GlassLobe::Several GlassLobe::several_bounces(double cosine) const {
  const double lost = std::max(0.0, 1 - tables_.here->energy(place_, cosine));
  const Color mirrored = fresnel_ ? reflectance_.constant + reflectance_.weight : passed_;
  Several several{mirrored * ((1 - behind_share_) * lost), passed_ * (behind_share_ * lost), 0, 0};
  if (!fresnel_) several.reflected += returned_ * (1 - tables_.mirror->energy(place_, cosine));
  const double reflected = max_component(several.reflected), passed = max_component(several.passed);
  several.probability = ratio(reflected + passed, 1 - lost);
  several.choice = ratio(reflected, passed);
  return several;
}

// From inside, total reflection makes the mirror's weight 1 whatever was written: intermediate values count as such.
Color GlassLobe::reflected_albedo(double cosine) const {
  if (is_perfect()) return at_facet(cosine).reflected;
  const Color several = several_bounces(cosine).reflected;
  const double clear = tables_.here->reflected(place_, cosine);
  const Color rho = reflectance_.constant + reflectance_.weight;
  if (!fresnel_) return tables_.mirror->albedo(reflectance_, place_, cosine) + (white - rho) * clear + several;
  return (eta_ < 1 ? white : rho) * clear + several;
}

Color GlassLobe::mean_reflected_albedo() const {
  const Color rho = reflectance_.constant + reflectance_.weight;
  const Color shown = fresnel_ ? (eta_ < 1 ? white : rho) : black;
  if (is_perfect()) {
    const double clear = tables_.here->mean_reflectance();
    return fresnel_ ? shown * clear : rho + (white - rho) * clear;
  }
  const double lost = 1 - tables_.here->mean_energy(place_), clear = tables_.here->mean_reflected(place_);
  if (fresnel_) return shown * clear + rho * ((1 - behind_share_) * lost);
  return tables_.mirror->mean_albedo(reflectance_, place_) + (white - rho) * clear +
         passed_ * ((1 - behind_share_) * lost) + returned_ * (1 - tables_.mirror->mean_energy(place_));
}

Color GlassLobe::albedo(double cosine) const {
  const Color reflected = reflected_albedo(cosine);
  if (is_perfect()) return reflected + at_facet(cosine).passed;
  if (fresnel_) return reflected + passed_ * (white - reflected);
  return reflected + passed_ * tables_.here->transmitted(place_, cosine) + several_bounces(cosine).passed;
}

// Its normal points to the +z side.
Vec3 GlassLobe::facet_between(const Vec3& wo, const Vec3& wi) const {
  const Vec3 h = normalize(wi.z > 0 ? wo + wi : wo + wi * eta_);
  return h.z < 0 ? -h : h;
}

std::optional<Vec3> GlassLobe::through(const Vec3& wo, const Vec3& h) const {
  const double cosine = dot(wo, h), cos2_behind = cos2_refracted(cosine, 1 / eta_);
  if (cos2_behind <= 0) return std::nullopt;
  return normalize(refract(-wo, h, 1 / eta_, cosine, std::sqrt(cos2_behind)));
}

double GlassLobe::passed_stretch(const Vec3& wo, const Vec3& wi, const Vec3& h) const {
  const double sum = dot(wo, h) + eta_ * dot(wi, h);
  return eta_ * eta_ * std::abs(dot(wi, h)) / (sum * sum);
}

Color GlassLobe::evaluate(const Vec3& wo, const Vec3& wi) const {
  if (is_perfect() || wo.z <= 0 || wi.z == 0) return black;
  const Several several = several_bounces(wo.z);
  const Vec3 h = facet_between(wo, wi);
  const double cos_facet = dot(wo, h);
  if (wi.z > 0) {
    // For both kinds of lost light, each with its own profile.
    const double lost = 1 - tables_.here->energy(place_, wi.z), all = 1 - tables_.here->mean_energy(place_);
    Color back = several.reflected * (lost / all);
    if (!fresnel_) {
      const double mirror = 1 - tables_.mirror->energy(place_, wi.z), whole = 1 - tables_.mirror->mean_energy(place_);
      const Color own = returned_ * (1 - tables_.mirror->energy(place_, wo.z));
      back = (several.reflected - own) * (lost / all) + own * (mirror / whole);
    }
    const double facets = ggx_.distribution(h) * ggx_.reflected_visibility(wo.z, wi.z);
    return at_facet(cos_facet).reflected * facets + back * std::numbers::inv_pi;
  }
  const double lost = 1 - tables_.behind->energy(place_, -wi.z), all = 1 - tables_.behind->mean_energy(place_);
  const Color back = several.passed * (lost / all * std::numbers::inv_pi);
  if (cos_facet <= 0 || dot(wi, h) >= 0) return back;
  const double facets = ggx_.distribution(h) * ggx_.transmitted_visibility(wo.z, -wi.z) * cos_facet;
  return at_facet(cos_facet).passed * (facets * passed_stretch(wo, wi, h)) + back;
}

double GlassLobe::density(const Vec3& wo, const Vec3& wi) const {
  if (is_perfect() || wo.z <= 0 || wi.z == 0) return 0;
  const Several several = several_bounces(wo.z);
  const Vec3 h = facet_between(wo, wi);
  const double cos_facet = dot(wo, h), spread = several_bounces_density(std::abs(wi.z));
  const double single = 1 - several.probability;
  if (wi.z > 0)
    return single * at_facet(cos_facet).choice * ggx_.visible_density(wo, h) / (4 * cos_facet) +
           several.probability * several.choice * spread;
  const double back = several.probability * (1 - several.choice) * spread;
  if (cos_facet <= 0 || dot(wi, h) >= 0) return back;
  return single * (1 - at_facet(cos_facet).choice) * ggx_.visible_density(wo, h) * passed_stretch(wo, wi, h) + back;
}

std::optional<BsdfSample> GlassLobe::sample(const Vec3& wo, double u, double v, double choice) const {
  BsdfSample sample;
  sample.is_perfect = is_perfect();
  const Several several = sample.is_perfect ? Several{} : several_bounces(wo.z);
  if (choice < several.probability) {
    sample.wi = sample_several_bounces(u, v);
    if (choice >= several.probability * several.choice) sample.wi.z = -sample.wi.z;
    return sample;
  }
  const double rest = (choice - several.probability) / (1 - several.probability);
  const Vec3 h = sample.is_perfect ? Vec3{0, 0, 1} : ggx_.sample_visible(wo, u, v);
  const double cosine = dot(wo, h);
  const FacetTerms facet = at_facet(cosine);
  if (rest < facet.choice) {
    sample.wi = sample.is_perfect ? Vec3{-wo.x, -wo.y, wo.z} : normalize(h * (2 * cosine) - wo);
    if (sample.wi.z <= 0) return std::nullopt;
  } else {
    const std::optional<Vec3> wi = through(wo, h);
    if (!wi || wi->z >= 0) return std::nullopt;
    sample.wi = *wi;
  }
  if (sample.is_perfect) {
    const bool is_mirrored = sample.wi.z > 0;
    sample.density = is_mirrored ? facet.choice : 1 - facet.choice;
    if (sample.density <= 0) return std::nullopt;
    sample.weight = (is_mirrored ? facet.reflected : facet.passed) * (1 / sample.density);
  }
  return sample;
}

} // namespace rt
