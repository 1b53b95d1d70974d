#include "renderer/scattering/material_tables.hpp"

#include "renderer/scattering/ggx.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

namespace rt {
namespace {

using Key = std::vector<double>;

/// Builds each table once.
class TableMaker {
public:
  std::shared_ptr<const MirrorTables> mirror(const RoughnessAxis& axis, const FresnelCurve& curve) {
    Key key = key_of(axis);
    for (const double number :
         {static_cast<double>(curve.kind), curve.eta, curve.n.r, curve.n.g, curve.n.b, curve.k.r, curve.k.g, curve.k.b})
      key.push_back(number);
    auto& tables = mirrors_[key];
    if (!tables) tables = std::make_shared<const MirrorTables>(axis, curve);
    return tables;
  }
  std::shared_ptr<const GlassTables> glass(const RoughnessAxis& axis, double eta, bool fresnel) {
    Key key = key_of(axis);
    key.push_back(eta);
    key.push_back(fresnel ? 1 : 0);
    auto& tables = glasses_[key];
    if (!tables) tables = std::make_shared<const GlassTables>(axis, eta, fresnel);
    return tables;
  }

private:
  // Smooth surfaces have the same tables whatever their α.
  static Key key_of(const RoughnessAxis& axis) {
    if (axis.alphas().size() > 1) return {-1};
    return {Ggx(axis.alphas()[0]).is_smooth() ? 0 : axis.alphas()[0]};
  }
  std::map<Key, std::shared_ptr<const MirrorTables>> mirrors_;
  std::map<Key, std::shared_ptr<const GlassTables>> glasses_;
};

// Whether its ior may be that of a medium.
bool passes(const Materials& materials, std::uint32_t i) {
  return materials.constant(i).refract > 0 || materials.varies(i, &MaterialValues::refract);
}

RoughnessAxis axis_of(double alpha, bool varies) {
  return varies ? RoughnessAxis::patterned(Ggx::least_alpha) : RoughnessAxis::constant(alpha);
}

MaterialTables make_tables(const MaterialValues& v, std::span<const double> iors, Varying varying, TableMaker& make) {
  using Kind = FresnelCurve::Kind;
  MaterialTables tables;
  const bool mirrors = v.metal || v.reflect != black || varying.reflect;
  const bool passes = !v.metal && (v.refract > 0 || varying.refract);
  const RoughnessAxis surface = axis_of(surface_alpha(v), varying.roughness);
  if (mirrors || passes)
    tables.mirror =
        make.mirror(surface, v.metal ? FresnelCurve{Kind::conductor, 1, v.metal->n, v.metal->k} : FresnelCurve{});
  if (!v.metal && (v.specular > 0 || varying.specular))
    tables.highlight =
        make.mirror(axis_of(highlight_alpha(v), varying.shininess || varying.roughness), {.kind = Kind::schlick});
  if (v.coat > 0 || varying.coat)
    tables.coat = make.mirror(RoughnessAxis::constant(coat_alpha(v)), {.kind = Kind::dielectric, .eta = v.coat_ior});
  for (const double ior : iors) {
    MaterialTables::Interface& interface = tables.interfaces.emplace_back();
    interface.eta = v.ior / ior;
    if (mirrors && v.fresnel && !v.metal)
      interface.mirror = make.mirror(surface, {.kind = v.thin ? Kind::sheet : Kind::dielectric, .eta = interface.eta});
    if (!passes || v.thin || std::abs(interface.eta - 1) < least_bend) continue;
    interface.outside = make.glass(surface, interface.eta, v.fresnel);
    interface.inside = make.glass(surface, 1 / interface.eta, v.fresnel);
  }
  return tables;
}

} // namespace

double surface_alpha(const MaterialValues& values) {
  return values.roughness ? *values.roughness * *values.roughness : 0;
}

double highlight_alpha(const MaterialValues& values) {
  return std::min(1.0, std::sqrt(2 / (values.shininess + 2)));
}

double coat_alpha(const MaterialValues& values) {
  return values.coat_roughness * values.coat_roughness;
}

ScatteringTables::ScatteringTables(const Materials& materials) {
  TableMaker make;
  std::vector<double> iors{1};
  for (std::uint32_t i = 0; i < materials.size(); ++i)
    if (passes(materials, i)) iors.push_back(materials.constant(i).ior);
  std::sort(iors.begin(), iors.end());
  iors.erase(std::unique(iors.begin(), iors.end()), iors.end());
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    const auto varies = [&](auto property) { return materials.varies(i, property); };
    const Varying varying{.roughness = varies(&MaterialValues::roughness),
                          .shininess = varies(&MaterialValues::shininess),
                          .specular = varies(&MaterialValues::specular),
                          .reflect = varies(&MaterialValues::reflect),
                          .refract = varies(&MaterialValues::refract),
                          .coat = varies(&MaterialValues::coat)};
    tables_.push_back(make_tables(materials.constant(i), iors, varying, make));
  }
}

MaterialTables::Side MaterialTables::find(double eta) const {
  Side best{nullptr, true};
  double least = 0;
  for (const Interface& interface : interfaces) {
    for (const bool is_outside : {true, false}) {
      const double stretch = is_outside ? eta / interface.eta : eta * interface.eta;
      const double difference = std::max(stretch, 1 / stretch);
      if (best.interface && difference >= least) continue;
      best = {&interface, is_outside};
      least = difference;
    }
  }
  return best;
}

MaterialTables make_material_tables(const MaterialValues& values, std::span<const double> iors, Varying varying) {
  TableMaker make;
  return make_tables(values, iors, varying, make);
}

} // namespace rt
