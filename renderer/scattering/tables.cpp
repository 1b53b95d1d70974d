#include "renderer/scattering/tables.hpp"

#include "renderer/scattering/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

const GaussLegendre& along_cosines() {
  static const GaussLegendre rule(48);
  return rule;
}

// 2∫ f μ dμ, f a function of the cosine that may have a kink at one.
template <class F>
auto hemispherical_mean(F&& f, double bend = 0) {
  const auto between = [&](double a, double b) {
    // Clustered at the ends, where there are square roots at the kink.
    return along_cosines().integrate([&](double x) {
      const double mu = a + (b - a) * x * x * (3 - 2 * x);
      return f(mu) * (2 * mu * (b - a) * 6 * x * (1 - x));
    });
  };
  return bend > 0 ? between(0, bend) + between(bend, 1) : between(0, 1);
}

// The cosine below which reflection is total.
double critical_cosine(double eta) {
  return eta < 1 ? std::sqrt(1 - eta * eta) : 0;
}

Color tinted(const FresnelCurve& curve, double cosine) {
  return curve.at(cosine) * (1 - exact_metallic_falloff(cosine));
}

double clear_reflectance(double cosine, double eta, bool fresnel) {
  if (fresnel) return fresnel_reflectance(cosine, eta);
  return cosine < critical_cosine(eta) ? 1 : 0;
}

// No rounding may make a surface reflect more than it receives.
double at_most_one(double albedo) {
  return std::min(1.0, albedo);
}
Color at_most_one(const Color& albedo) {
  return {at_most_one(albedo.r), at_most_one(albedo.g), at_most_one(albedo.b)};
}

const FacetQuadrature& facets() {
  static const FacetQuadrature rule;
  return rule;
}
// The onset of total reflection varies with the azimuth.
const FacetQuadrature& glass_facets(double eta) {
  static const FacetQuadrature from_inside(16, 64);
  return eta < 1 ? from_inside : facets();
}

} // namespace

// The transmitted flux is the same from both sides: n²(1 − F_avg).
double mean_fresnel_reflectance(double eta) {
  if (eta < 1) return 1 - eta * eta * (1 - mean_fresnel_reflectance(1 / eta));
  return hemispherical_mean([eta](double mu) { return fresnel_reflectance(mu, eta); });
}

MirrorTables::MirrorTables(const RoughnessAxis& axis, const FresnelCurve& curve)
    : axis_(axis),
      mean_curve_(hemispherical_mean([&](double mu) { return curve.at(mu); },
                                     curve.kind == FresnelCurve::Kind::dielectric ? critical_cosine(curve.eta) : 0)),
      mean_tinted_(hemispherical_mean([&](double mu) { return tinted(curve, mu); })) {
  // A smooth surface, unless it is a sample of a patterned one, is its facet.
  const auto of = [&](auto f) {
    return [f](double alpha, double mu) {
      if (Ggx(alpha).is_smooth()) return at_most_one(f(mu));
      return at_most_one(facets().reflected(alpha, mu, f));
    };
  };
  energy_ = {axis, of([](double) { return 1.0; })};
  curve_ = {axis, of([&](double cosine) { return curve.at(cosine); })};
  tinted_ = {axis, of([&](double cosine) { return tinted(curve, cosine); })};
}

GlassTables::GlassTables(const RoughnessAxis& axis, double eta, bool fresnel)
    : axis_(axis), mean_reflectance_(fresnel ? mean_fresnel_reflectance(eta) : std::max(0.0, 1 - eta * eta)) {
  const double critical = critical_cosine(eta);
  const auto reflectance = [=](double cosine) { return clear_reflectance(cosine, eta, fresnel); };
  reflected_ = {axis, [&](double alpha, double mu) {
                  if (Ggx(alpha).is_smooth()) return reflectance(mu);
                  return glass_facets(eta).reflected(alpha, mu, reflectance, critical);
                }};
  transmitted_ = {axis, [&](double alpha, double mu) {
                    if (Ggx(alpha).is_smooth()) return 1 - reflectance(mu);
                    const auto passed = [&](double cosine) { return 1 - reflectance(cosine); };
                    const double most = 1 - glass_facets(eta).reflected(alpha, mu, reflectance, critical);
                    return std::min(most, glass_facets(eta).transmitted(alpha, mu, eta, passed));
                  }};
}

} // namespace rt
