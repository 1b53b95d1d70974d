#pragma once

#include "lang/load.hpp"
#include "renderer/render/render.hpp"
#include "tools/povray/compare/report.hpp"

#include <catch2/catch.hpp>

#include <string>

/// Comparisons with the POV-Ray that is installed. Where there is none, they throw, and the tests fail: a comparison
/// that is left out silently proves nothing.
namespace rt::tests {

struct Checked {
  scene::Scene scene;
  Film film;
  tools::povray::Shots shots;
  tools::povray::Comparison comparison;
};

inline scene::Scene loaded(lang::Loaded&& result, const std::string& name) {
  for (const lang::Diagnostic& d : result.diagnostics)
    if (d.severity == lang::Severity::error) FAIL(name << ": " << d.message);
  REQUIRE(result.scene);
  return std::move(*result.scene);
}
inline scene::Scene scene_of(const std::string& text) {
  return loaded(lang::load_text(text, "test.rtl", ".", {}), "test.rtl");
}

inline Film film_of(const scene::Scene& scene) {
  RenderOptions options;
  options.threads = 1;
  options.layers = true;
  options.integrator = IntegratorKind::whitted_exported;
  return render(scene, options).film;
}

inline Checked check_scene(scene::Scene scene) {
  Checked c{std::move(scene), {}, {}, {}};
  REQUIRE(tools::povray::export_povray(c.scene).inexact.empty());
  c.film = film_of(c.scene);
  c.shots = tools::povray::shoot(c.scene);
  c.comparison = tools::povray::compare(c.scene, c.film, c.shots);
  return c;
}

inline bool holds(const tools::povray::Comparison& comparison) {
  return tools::povray::all_hold(tools::povray::judge(comparison, {}));
}
/// The names of the gates that do not hold.
inline std::string failing(const tools::povray::Comparison& comparison) {
  std::string names;
  for (const auto& v : tools::povray::judge(comparison, {}))
    if (!v.holds()) names += (names.empty() ? "" : " ") + v.name;
  return names;
}

} // namespace rt::tests
