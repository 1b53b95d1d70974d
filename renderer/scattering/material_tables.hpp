#pragma once

#include "renderer/scattering/tables.hpp"
#include "renderer/shading/materials.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rt {

/// The roughness α of a material's mirror and glass, of its highlight, and of its coat.
double surface_alpha(const MaterialValues& values);
double highlight_alpha(const MaterialValues& values);
double coat_alpha(const MaterialValues& values);

/// If two media's ior differ by less, light passes straight through.
inline constexpr double least_bend = 1e-4;

/// The properties of a material that patterns give.
struct Varying {
  bool roughness = false, shininess = false, specular = false, reflect = false, refract = false, coat = false;
};

/// The tables of a material's lobes.
struct MaterialTables {
  /// Between two media, one of which is the material's.
  struct Interface {
    double eta; ///< the material's ior divided by the other's
    std::shared_ptr<const MirrorTables> mirror;
    std::shared_ptr<const GlassTables> outside, inside;
  };
  std::vector<Interface> interfaces;
  std::shared_ptr<const MirrorTables> mirror; ///< without an ior
  std::shared_ptr<const MirrorTables> highlight, coat;

  /// The interface for, or nearest to, the ior behind the surface divided by the ior before it, and whether it is seen
  /// from outside.
  struct Side {
    const Interface* interface;
    bool is_outside;
  };
  Side find(double eta) const;
};

/// The tables of all materials of a scene. Materials with equal surfaces share them.
class ScatteringTables {
public:
  explicit ScatteringTables(const Materials& materials);

  /// By the material's index in `Materials`.
  const MaterialTables& of(std::uint32_t material) const { return tables_[material]; }

private:
  std::vector<MaterialTables> tables_;
};

/// The tables of one material among media with these ior, of which there must be one.
MaterialTables make_material_tables(const MaterialValues& values, std::span<const double> iors, Varying varying = {});

} // namespace rt
