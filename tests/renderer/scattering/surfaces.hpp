#pragma once

#include "renderer/math/random.hpp"
#include "renderer/scattering/bsdf.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace rt::tests {

/// A material among others, and what it is looked at through: vacuum, or from inside of it.
struct Surface {
  std::string name;
  MaterialValues values;
  bool is_inside = false;

  double eta() const { return is_inside ? 1 / values.ior : values.ior; }
};

/// With its tables.
class TabulatedSurface {
public:
  explicit TabulatedSurface(const Surface& surface)
      : surface_(surface), tables_(make_material_tables(surface.values, std::vector<double>{1})) {}

  const Surface& surface() const { return surface_; }
  Bsdf bsdf(const Vec3& wo) const { return {surface_.values, tables_, surface_.eta(), wo}; }
  /// Of the same place, seen from behind.
  Bsdf bsdf_from_behind(const Vec3& wo) const { return {surface_.values, tables_, 1 / surface_.eta(), wo}; }

private:
  Surface surface_;
  MaterialTables tables_;
};

inline Vec3 direction(double cosine, double turns = 0.1) {
  const double sine = std::sqrt(1 - cosine * cosine), angle = 2 * std::numbers::pi * turns;
  return {sine * std::cos(angle), sine * std::sin(angle), cosine};
}

inline MaterialValues matte() {
  MaterialValues v;
  v.diffuse = white;
  return v;
}
inline MaterialValues rough_mirror(double roughness) {
  MaterialValues v;
  v.diffuse = black;
  v.reflect = white;
  v.roughness = roughness;
  return v;
}
inline MaterialValues rough_metal(double roughness) {
  MaterialValues v;
  v.diffuse = black;
  v.roughness = roughness;
  v.metal = scene::Metal{{0.1310, 0.4919, 1.4829}, {4.0624, 2.2399, 1.7805}};
  return v;
}
inline MaterialValues clear_glass(double roughness) {
  MaterialValues v = rough_mirror(roughness);
  v.refract = 1;
  v.ior = 1.5;
  v.fresnel = true;
  return v;
}
inline MaterialValues plain_glass(double roughness) { // without Fresnel
  MaterialValues v = clear_glass(roughness);
  v.fresnel = false;
  v.reflect = {0.3, 0.2, 0.1};
  v.color = {0.8, 0.7, 0.9};
  v.refract = 0.8;
  return v;
}
inline MaterialValues plastic(double roughness) {
  MaterialValues v = matte();
  v.reflect = white;
  v.ior = 1.5;
  v.fresnel = true;
  v.roughness = roughness;
  return v;
}
inline MaterialValues glossy() {
  MaterialValues v = matte();
  v.specular = 0.6;
  v.shininess = 20;
  return v;
}
inline MaterialValues coated(MaterialValues v, double weight, double roughness) {
  v.coat = weight;
  v.coat_roughness = roughness;
  return v;
}
inline MaterialValues sheet(double roughness) {
  MaterialValues v = clear_glass(roughness);
  v.color = grey(0.8);
  v.thin = true;
  return v;
}

/// Every lobe and side, alone and layered; roughness r, α = r².
inline std::vector<Surface> surfaces() {
  return {{"matte", matte()},
          {"mirror, smooth", rough_mirror(0)},
          {"mirror, r 0.35", rough_mirror(0.35)},
          {"mirror, r 1", rough_mirror(1)},
          {"metal, r 0.5", rough_metal(0.5)},
          {"glass, smooth", clear_glass(0)},
          {"glass, r 0.5", clear_glass(0.5)},
          {"glass, r 0.5, inside", clear_glass(0.5), true},
          {"glass, r 0.9", clear_glass(0.9)},
          {"glass, r 0.9, inside", clear_glass(0.9), true},
          {"glass without Fresnel, r 0.6", plain_glass(0.6)},
          {"glass without Fresnel, r 0.6, inside", plain_glass(0.6), true},
          {"plastic, r 0.4", plastic(0.4)},
          {"highlight", glossy()},
          {"matte, coated", coated(matte(), 0.8, 0.5)},
          {"metal, coated", coated(rough_metal(0.5), 1, 0.4)},
          {"plastic, coated", coated(plastic(0.7), 1, 0)},
          {"glass, coated", coated(clear_glass(0.7), 0.5, 0.5)},
          {"sheet, r 0.5", sheet(0.5)}};
}

/// The mean of what `value` gives of samples that are spread evenly (M. Roberts, 2018: the plastic number's powers).
template <class F>
Color mean_of_samples(const Bsdf& bsdf, int count, F&& value) {
  constexpr double step[] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  Color sum = black;
  for (int i = 0; i < count; ++i) {
    const auto part = [&](int k) { return std::fmod(0.5 + i * step[k], 1.0); };
    if (const auto sample = bsdf.sample(part(0), part(1), part(2))) sum += value(*sample);
  }
  return sum * (1.0 / count);
}

/// The share of a white environment's light that the surface shows.
inline Color furnace(const Bsdf& bsdf, int count) {
  return mean_of_samples(bsdf, count, [](const BsdfSample& sample) { return sample.weight; });
}

} // namespace rt::tests
