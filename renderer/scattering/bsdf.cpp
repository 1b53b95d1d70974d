#include "renderer/scattering/bsdf.hpp"

#include "renderer/scattering/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

enum Lobe { coat, mirror, glass, straight, ground };

Color at_least(double least, const Color& c) {
  return {std::max(least, c.r), std::max(least, c.g), std::max(least, c.b)};
}
Color at_most(double most, const Color& c) {
  return {std::min(most, c.r), std::min(most, c.g), std::min(most, c.b)};
}
/// 0 where the divisor is 0.
Color quotient(const Color& a, const Color& b) {
  const auto divided = [](double x, double y) { return y > 1e-12 ? x / y : 0; };
  return {divided(a.r, b.r), divided(a.g, b.g), divided(a.b, b.b)};
}

bool is_transparent(const MaterialValues& v) {
  return v.refract > 0 && !v.metal; // a metal transmits nothing
}

/// What the surface's colour adds to a metal's tint at normal incidence.
Color metal_tint(const MaterialValues& v) {
  return (v.color - white) * v.metallic;
}

/// The matte ground, before the layers above take their part.
Color ground_albedo(const MaterialValues& v) {
  return v.color * (1 - v.refract) * v.diffuse;
}

/// The reflectance of the facets, for tables of this curve. A metal's colour comes from n and k: `color` is that of its
/// ground, and what Whitted's model tints it by.
Reflectance mirrored(const MaterialValues& v, const Color& share, double eta) {
  if (v.metal) return {{FresnelCurve::Kind::conductor, 1, v.metal->n, v.metal->k}, black, white, black};
  const Color weight = v.reflect * share;
  if (v.fresnel) return {{.kind = FresnelCurve::Kind::dielectric, .eta = eta}, black, weight, weight * metal_tint(v)};
  return {{}, black, weight, weight * metal_tint(v)};
}

/// Schlick's curve with the same peak at normal incidence as Whitted's highlight.
Reflectance highlight(const MaterialValues& v) {
  const Color normal = at_most(1, (white + metal_tint(v)) * std::min(1.0, 8 * v.specular / (v.shininess + 2)));
  return {{.kind = FresnelCurve::Kind::schlick}, normal, white - normal, black};
}

} // namespace

// The ground gets what is not reflected. With Fresnel's equations the same holds for transmission, so that the maximum
// is where nothing or everything is reflected; without, m + p + (1 − m)·b must not exceed 1 after the division.
Color excess(const MaterialValues& v) {
  const Color below = ground_albedo(v), passed = is_transparent(v) ? v.color * v.refract : black;
  const Color mirrored = v.metal ? white : v.reflect * at_least(1, white + metal_tint(v));
  const auto divisor = [&](double m, double b, double p) {
    if (v.fresnel || v.metal) return std::max({1.0, m, b + p});
    const double sum = m + b + p;
    return std::max(1.0, (sum + std::sqrt(std::max(0.0, sum * sum - 4 * m * b))) / 2);
  };
  return {divisor(mirrored.r, below.r, passed.r), divisor(mirrored.g, below.g, passed.g),
          divisor(mirrored.b, below.b, passed.b)};
}

Bsdf::Bsdf(const MaterialValues& values, const MaterialTables& tables, double eta, const Vec3& wo) : wo_(wo) {
  const Color share = quotient(white, excess(values));
  if (values.coat > 0)
    coat_.emplace(coat_alpha(values),
                  Reflectance{{.kind = FresnelCurve::Kind::dielectric, .eta = values.coat_ior},
                              black,
                              grey(std::min(1.0, values.coat)),
                              black},
                  *tables.coat);
  layer_gloss(values, tables, eta, share);
  ground_.albedo = ground_albedo(values) * share;
  if (ground_.albedo != black) ground_.albedo *= quotient(below_all(wo_.z), mean_below_all());
  set_probabilities();
}

void Bsdf::layer_gloss(const MaterialValues& values, const MaterialTables& tables, double eta, const Color& share) {
  const auto [interface, is_outside] = tables.find(eta);
  const bool mirrors = values.metal || values.reflect != black, passes = is_transparent(values);
  const double alpha = surface_alpha(values);
  const Color passed = values.color * values.refract * share;
  const bool is_sheet = values.thin && values.fresnel && !values.metal;
  if (passes && interface->outside) {
    const double used = is_outside ? interface->eta : 1 / interface->eta;
    const GlassTables &out = *interface->outside, &in = *interface->inside;
    glass_.emplace(alpha, used, mirrored(values, share, used), passed, values.fresnel,
                   GlassSides{is_outside ? &out : &in, is_outside ? &in : &out, tables.mirror.get()});
  } else if (mirrors) {
    const Reflectance reflectance = mirrored(values, share, interface->eta);
    const bool has_ior = values.fresnel && !values.metal;
    mirror_.emplace(alpha, reflectance, has_ior ? *interface->mirror : *tables.mirror,
                    is_sheet ? std::optional(at_most(1, values.color)) : std::nullopt);
  }
  if (!mirrors && values.specular > 0) {
    is_glossy_ = true;
    mirror_.emplace(highlight_alpha(values), highlight(values), *tables.highlight);
  }
  if (!passes || glass_) return;
  straight_ = passed;
  if (is_sheet) {
    const Color side = mirrors ? mirrored(values, share, interface->eta).at(wo_.z) : black;
    straight_ = sheet_terms(side, at_most(1, values.color)).transmitted * (share * values.refract);
    // A rough mirror may take more than its share of a facet's light, at the expense of transmission.
    if (mirrors && !mirror_->is_perfect())
      straight_ *= at_most(1, quotient(white - mirror_->albedo(wo_.z), white - mirror_->reflectance(wo_.z)));
  } else if (values.fresnel || is_glossy_) {
    straight_ *= below_mirror(wo_.z);
  }
  straight_ *= below_coat(wo_.z) * below_coat(wo_.z);
}

Color Bsdf::below_coat(double cosine) const {
  return coat_ ? at_least(0, white - coat_->albedo(cosine)) : white;
}

Color Bsdf::below_mirror(double cosine) const {
  return mirror_ ? at_least(0, white - mirror_->albedo(cosine)) : white;
}

Color Bsdf::below_all(double cosine) const {
  Color below = below_coat(cosine) * below_mirror(cosine);
  if (glass_) below *= at_least(0, white - glass_->reflected_albedo(cosine));
  return below;
}

// 2∫ below_all μ dμ; for a single layer it is tabulated.
Color Bsdf::mean_below_all() const {
  const int layers = (coat_ ? 1 : 0) + (mirror_ ? 1 : 0) + (glass_ ? 1 : 0);
  if (layers == 0) return white;
  if (layers == 1) {
    const Color mean = coat_     ? coat_->mean_albedo()
                       : mirror_ ? mirror_->mean_albedo()
                                 : glass_->mean_reflected_albedo();
    return at_least(0, white - mean);
  }
  static const GaussLegendre rule(16);
  return rule.integrate([&](double x) { return below_all(x * x) * (4 * x * x * x); });
}

/// The fraction of light that reaches a lobe, or leaves it again, in a direction of this cosine.
Color Bsdf::attenuation(int lobe, double cosine) const {
  switch (lobe) {
  case mirror:
    return below_coat(cosine);
  case glass:
    return is_glossy_ ? below_coat(cosine) * below_mirror(cosine) : below_coat(cosine);
  case ground:
    return below_all(cosine);
  default:
    return white;
  }
}

void Bsdf::set_probabilities() {
  if (coat_) shares_[coat] = coat_->albedo(wo_.z);
  if (mirror_) shares_[mirror] = attenuation(mirror, wo_.z) * mirror_->albedo(wo_.z);
  if (glass_) shares_[glass] = attenuation(glass, wo_.z) * glass_->albedo(wo_.z);
  shares_[straight] = straight_;
  shares_[ground] = ground_.albedo * mean_below_all();
  double sum = 0;
  for (const Color& share : shares_) sum += max_component(share);
  for (int i = 0; i < lobes && sum > 0; ++i) probabilities_[i] = max_component(shares_[i]) / sum;
}

bool Bsdf::has_spread() const {
  return ground_.albedo != black || (coat_ && !coat_->is_perfect()) || (mirror_ && !mirror_->is_perfect()) ||
         (glass_ && !glass_->is_perfect());
}

Color Bsdf::evaluate(const Vec3& wi) const {
  const double cosine = std::abs(wi.z);
  Color f = black;
  if (glass_ && !glass_->is_perfect())
    f += glass_->evaluate(wo_, wi) * attenuation(glass, wo_.z) * attenuation(glass, cosine);
  if (wi.z <= 0) return f;
  if (coat_) f += coat_->evaluate(wo_, wi);
  if (mirror_ && !mirror_->is_perfect())
    f += mirror_->evaluate(wo_, wi) * attenuation(mirror, wo_.z) * attenuation(mirror, cosine);
  if (ground_.albedo != black) f += ground_.evaluate() * attenuation(ground, cosine);
  return f;
}

double Bsdf::density(const Vec3& wi) const {
  double density = 0;
  if (coat_) density += probabilities_[coat] * coat_->density(wo_, wi);
  if (mirror_) density += probabilities_[mirror] * mirror_->density(wo_, wi);
  if (glass_) density += probabilities_[glass] * glass_->density(wo_, wi);
  return density + probabilities_[ground] * LambertLobe::density(wi);
}

std::optional<BsdfSample> Bsdf::sample_lobe(int lobe, double u, double v, double choice) const {
  switch (lobe) {
  case coat:
    return coat_->sample(wo_, u, v, choice);
  case mirror:
    return mirror_->sample(wo_, u, v, choice);
  case glass:
    return glass_->sample(wo_, u, v, choice);
  case straight:
    return BsdfSample{-wo_, straight_, 1, true, true};
  default:
    return BsdfSample{LambertLobe::sample(u, v)};
  }
}

std::optional<BsdfSample> Bsdf::sample(double u, double v, double choice) const {
  int lobe = 0;
  while (lobe + 1 < lobes && choice >= probabilities_[lobe]) choice -= probabilities_[lobe++];
  while (lobe > 0 && probabilities_[lobe] == 0) --lobe; // choice was rounded up
  const double probability = probabilities_[lobe];
  if (probability == 0) return std::nullopt;
  auto sample = sample_lobe(lobe, u, v, std::min(choice / probability, 1 - 0x1p-53));
  if (!sample) return std::nullopt;
  if (sample->is_perfect) {
    sample->weight *= attenuation(lobe, wo_.z) * attenuation(lobe, std::abs(sample->wi.z)) * (1 / probability);
    sample->density *= probability;
    return sample;
  }
  sample->density = density(sample->wi);
  if (!(sample->density > 0)) return std::nullopt;
  sample->weight = evaluate(sample->wi) * (std::abs(sample->wi.z) / sample->density);
  return sample;
}

Color Bsdf::albedo() const {
  Color sum = black;
  for (const Color& share : shares_) sum += share;
  return sum;
}

} // namespace rt
