#include "renderer/shading/whitted_bsdf.hpp"

#include <catch2/catch.hpp>

using namespace rt;

namespace {

const Vec3 up{0, 0, 1};

// A unit vector at this angle to `up`, on the side of +x.
Vec3 at_degrees(double angle) {
  const double radians = angle * 3.14159265358979323846 / 180;
  return {std::sin(radians), 0, std::cos(radians)};
}

// Seen from `to_viewer`, lit with white light from `to_light`.
ReflectedLight lit(const MaterialValues& values, const Vec3& to_viewer, const Vec3& to_light) {
  return WhittedBsdf(values).evaluate(white, -to_viewer, up, to_light, to_light.z, true);
}

MaterialValues glossy(scene::Highlight form, double specular, double shininess) {
  MaterialValues v;
  v.specular = specular, v.shininess = shininess, v.highlight = form;
  return v;
}

MaterialValues glass(double ior) {
  MaterialValues v;
  v.reflect = white, v.refract = 1, v.ior = ior, v.fresnel = true;
  return v;
}

} // namespace

TEST_CASE("bsdf: diffuse light is the colour's opaque share by the cosine, from wherever it is seen") {
  MaterialValues v;
  v.color = {1, 0.5, 0.25}, v.diffuse = grey(0.8), v.refract = 0.25;
  for (const double viewer : {0.0, -30.0, 80.0}) {
    // 0.8 · (1 − 0.25) · cos 60° = 0.3
    const Color diffuse = lit(v, at_degrees(viewer), at_degrees(60)).diffuse;
    CHECK(diffuse.r == Approx(0.3));
    CHECK(diffuse.g == Approx(0.15));
    CHECK(diffuse.b == Approx(0.075));
  }
}

TEST_CASE("bsdf: Blinn's highlight is a power of the half-way vector's cosine") {
  // Light at 60° and viewer at 0°: half-way at 30°, cos² 30° = 3/4, so cos⁸ = (3/4)⁴ = 81/256.
  const ReflectedLight r = lit(glossy(scene::Highlight::blinn, 0.5, 8), up, at_degrees(60));
  CHECK(r.cos_highlight == Approx(std::sqrt(0.75)));
  CHECK(r.highlight.g == Approx(0.5 * 81 / 256));
  CHECK(r.sum().g == Approx(0.8 * 0.5 + 0.5 * 81 / 256));
}

TEST_CASE("bsdf: Phong's highlight is a power of the cosine between the light and the mirrored view") {
  // Viewer at −45°, so the view is mirrored to 45°; the light at 75° is 30° off.
  const ReflectedLight r = lit(glossy(scene::Highlight::phong, 1, 4), at_degrees(-45), at_degrees(75));
  CHECK(r.cos_highlight == Approx(std::sqrt(0.75)));
  CHECK(r.highlight.g == Approx(9.0 / 16));
  // Beyond 90° there is none: the view mirrored to −80°, the light at 80°.
  CHECK(lit(glossy(scene::Highlight::phong, 1, 4), at_degrees(80), at_degrees(80)).highlight == black);
}

TEST_CASE("bsdf: a light that is to give none brings no highlight") {
  const MaterialValues v = glossy(scene::Highlight::blinn, 1, 8);
  CHECK(WhittedBsdf(v).evaluate(white, -up, up, up, 1, false).highlight == black);
  CHECK(WhittedBsdf(v).evaluate(white, -up, up, up, 1, true).highlight == white);
}

TEST_CASE("bsdf: a metal's highlight and mirror have its colour at the normal and are white at grazing angles") {
  MaterialValues gold = glossy(scene::Highlight::blinn, 1, 1);
  gold.color = {1, 0.75, 0.25}, gold.metallic = 1, gold.reflect = white;
  const ReflectedLight straight = lit(gold, up, up);
  CHECK(straight.highlight.b == Approx(0.25).margin(1e-4));
  const WhittedBsdf bsdf(gold);
  CHECK(bsdf.specular(1, 1, 1).rho.b == Approx(0.25).margin(1e-4));
  CHECK(bsdf.specular(0, 1, 1).rho.b == Approx(1).margin(1e-3));
}

TEST_CASE("bsdf: at normal incidence glass mirrors ((n − 1)/(n + 1))² and lets the rest through unbent") {
  for (const double n : {1.333, 1.5, 2.417}) {
    const double share = (n - 1) / (n + 1) * ((n - 1) / (n + 1));
    const MaterialValues values = glass(n);
    const SpecularTerms entering = WhittedBsdf(values).specular(1, 1 / n, n),
                        leaving = WhittedBsdf(values).specular(1, n, 1 / n);
    for (const SpecularTerms& terms : {entering, leaving}) {
      CHECK(terms.reflectance == Approx(share).epsilon(1e-12));
      CHECK(terms.rho.g == Approx(share).epsilon(1e-12));
      CHECK(terms.tau.g == Approx(1 - share).epsilon(1e-12));
      CHECK(terms.cos_behind == 1);
      CHECK_FALSE(terms.is_total);
    }
  }
}

TEST_CASE("bsdf: all is mirrored beyond the angle whose sine is 1/n, and nothing before it") {
  const double n = 1.5, critical = std::asin(1 / n) * 180 / 3.14159265358979323846; // 41.8°
  const MaterialValues values = glass(n);
  const auto from_inside = [&](double angle) { return WhittedBsdf(values).specular(at_degrees(angle).z, n, 1 / n); };
  const SpecularTerms beyond = from_inside(critical + 0.01);
  CHECK(beyond.is_total);
  CHECK(beyond.rho == white);
  CHECK(beyond.tau == black);
  const SpecularTerms before = from_inside(critical - 0.01);
  CHECK_FALSE(before.is_total);
  CHECK(before.is_bent);
  CHECK(before.tau.g > 0);
  CHECK(before.rho.g < 1);
  CHECK_FALSE(WhittedBsdf(values).specular(at_degrees(89.9).z, 1 / n, n).is_total); // from outside never
}

TEST_CASE("bsdf: the refracted ray's angle is Snell's") {
  // sin 30° = 1.5 sin β: cos β = √(1 − 1/9)
  const MaterialValues values = glass(1.5);
  CHECK(WhittedBsdf(values).specular(at_degrees(30).z, 1 / 1.5, 1.5).cos_behind == Approx(std::sqrt(8.0 / 9)));
}

TEST_CASE("bsdf: without a difference of indices nothing is bent") {
  MaterialValues film;
  film.refract = 0.5, film.color = {1, 0.5, 0};
  const SpecularTerms terms = WhittedBsdf(film).specular(0.3, 1, 1);
  CHECK_FALSE(terms.is_bent);
  CHECK(terms.tau == Color{0.5, 0.25, 0});
  CHECK(terms.rho == black);
}

TEST_CASE("bsdf: a mirror without Fresnel's equation is the same at every angle") {
  MaterialValues v;
  v.reflect = {0.1, 0.2, 0.3};
  const WhittedBsdf bsdf(v);
  CHECK(bsdf.is_mirror());
  CHECK_FALSE(bsdf.is_transparent());
  for (const double cosine : {1.0, 0.5, 0.01}) CHECK(bsdf.specular(cosine, 1, 1).rho == Color{0.1, 0.2, 0.3});
}

TEST_CASE("bsdf: black glass lets nothing by, and beyond the critical angle it mirrors no more than before") {
  MaterialValues values = glass(1.5);
  values.color = black;
  const SpecularTerms beyond = WhittedBsdf(values).specular(at_degrees(60).z, 1.5, 1 / 1.5);
  CHECK_FALSE(beyond.is_total);
  CHECK(beyond.tau == black);
  CHECK(std::isfinite(beyond.cos_behind));
}
