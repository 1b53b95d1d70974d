// What the recorder hears is what the picture shows: over random pixels of every example.

#include "lang/load.hpp"
#include "renderer/render/render.hpp"
#include "tests/paths.hpp"
#include "tools/explain/why/why.hpp"
#include "tools/explain/why/why_surface.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

using namespace rt;
using namespace rt::tools;

namespace {

std::vector<std::string> examples() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(RTLANG_SOURCE_DIR "/examples"))
    if (entry.path().extension() == ".rtl") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

double gap(const Color& a, const Color& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

template <class F>
void for_each_surface(const explain::RayNode& node, F&& f) {
  for (const explain::SurfaceNode& s : node.surfaces) {
    f(s);
    if (s.mirror && s.mirror->ray) for_each_surface(*s.mirror->ray, f);
    if (s.transition && s.transition->ray) for_each_surface(*s.transition->ray, f);
    if (s.total_reflection) for_each_surface(*s.total_reflection->ray, f);
  }
}

// What the equation makes of a ray's parts, which must be what the integrator returned.
Color assembled(const explain::RayNode& node) {
  Color sum = black;
  for (const explain::SurfaceNode& s : node.surfaces) {
    sum += s.passed * s.shading();
    if (s.total_reflection) sum += s.passed * s.total_reflection->ray->radiance;
    if (s.mirror && s.mirror->ray) sum += s.passed * s.mirror->rho * s.mirror->ray->radiance;
    if (s.transition && s.transition->ray) sum += s.passed * s.transition->tau * s.transition->ray->radiance;
  }
  if (node.end == explain::RayNode::End::background)
    sum += (node.surfaces.empty() ? white : node.surfaces.back().passed * node.surfaces.back().transition->tau) *
           node.background;
  return sum;
}

void check_pixel(const scene::Scene& scene, const RayQuery& query, std::string_view file, int x, int y) {
  explain::Question question;
  question.pixel = {x, y};
  const explain::Answer answer(scene, file, query, question);
  INFO(file << " pixel " << x << ", " << y);
  const Color traced = query.radiance(answer.ray.ray);
  CHECK(answer.tree->radiance == traced); // to the last bit
  CHECK(gap(answer.sum.total, traced) <= 1e-12);
  CHECK(gap(assembled(*answer.tree), traced) <= 1e-12);
  for_each_surface(*answer.tree, [&](const explain::SurfaceNode& s) {
    for (const explain::LightNode& lamp : s.lights) {
      Color filter = white;
      for (const explain::InTheWay& w : lamp.in_the_way) filter *= w.transmittance;
      CHECK(filter == lamp.record.filter); // the surfaces that are named are those that dim it
    }
    const explain::Derivation derivation = explain::derivation_of(answer, s);
    CHECK(derivation.disagreement < 1e-5); // the rest is what plain formulas lose by cancellation
    if (const auto intervals = explain::intervals_of(answer, s)) {
      const bool is_end =
          std::any_of(intervals->inside.begin(), intervals->inside.end(), [&](const explain::LineInterval& interval) {
            return std::abs(interval.enter - s.hit.t) <= 1e-9 * (1 + s.hit.t) ||
                   std::abs(interval.leave - s.hit.t) <= 1e-9 * (1 + s.hit.t);
          });
      CHECK(is_end);
    }
  });
  const std::string text = explain::why_text(answer, {.depth = 2});
  CHECK(text.find("matches the renderer") != std::string::npos);
}

} // namespace

TEST_CASE("why: over random pixels of every example the terms sum to the radiance, which listening does not change") {
  std::mt19937 random(1980);
  for (const std::string& path : examples()) {
    auto loaded = lang::load_file(path, {});
    REQUIRE(loaded.scene);
    const scene::Scene& scene = *loaded.scene;
    const RayQuery query(scene, 1);
    std::uniform_int_distribution<int> column(0, scene.size[0] - 1), row(0, scene.size[1] - 1);
    for (int i = 0; i < 40; ++i) {
      const int x = column(random), y = row(random);
      check_pixel(scene, query, path, x, y);
    }
  }
}

TEST_CASE("why: the pixel it explains is the picture's, with packets of rays, one sample or several") {
  for (const char* name : {"still_life", "nested_glass", "whitted"}) {
    auto loaded = lang::load_file(std::string(RTLANG_SOURCE_DIR "/examples/") + name + ".rtl", {});
    REQUIRE(loaded.scene);
    for (const int samples : {1, 4}) {
      loaded.scene->samples = samples;
      const RayQuery query(*loaded.scene, 1);
      const int x = loaded.scene->size[0] / 2, y = loaded.scene->size[1] / 2;
      RenderOptions options;
      options.threads = 1;
      options.crop = PixelRect{x, y, x + 4, y + 4};
      const Rendered picture = render(*loaded.scene, options);
      for (int i = 0; i < 16; ++i) {
        explain::Question question;
        question.pixel = {x + i % 4, y + i / 4};
        const explain::Answer answer(*loaded.scene, name, query, question);
        const Color whole = answer.pixel.value_or(answer.tree->radiance);
        CHECK(answer.pixel.has_value() == (samples > 1));
        const Rgb32& shown = picture.film.color[static_cast<std::size_t>(i)];
        CHECK(shown.r == static_cast<float>(whole.r));
        CHECK(shown.g == static_cast<float>(whole.g));
        CHECK(shown.b == static_cast<float>(whole.b));
      }
    }
  }
}

TEST_CASE("why: what is too much to show is summed up, and the sum is still whole") {
  auto loaded = lang::load_file(RTLANG_SOURCE_DIR "/examples/nested_glass.rtl", {});
  REQUIRE(loaded.scene);
  const RayQuery query(*loaded.scene, 1);
  const Ray ray = query.camera().ray(400.5, 300.5);
  const auto whole = explain::record(query, ray), part = explain::record(query, ray, 3);
  const explain::Sum sum = explain::take_apart(*part);
  CHECK(part->radiance == whole->radiance);
  CHECK(gap(sum.total, whole->radiance) <= 1e-12);
  CHECK(std::any_of(sum.terms.begin(), sum.terms.end(),
                    [](const explain::Contribution& t) { return t.kind == explain::Contribution::Kind::unexpanded; }));
  std::size_t expanded = 0;
  for_each_surface(*part, [&](const explain::SurfaceNode&) { ++expanded; });
  CHECK(expanded == 3);
}

TEST_CASE("why: every sample of a pixel can be asked about, and their mean is the pixel") {
  auto loaded = lang::load_file(RTLANG_SOURCE_DIR "/examples/still_life.rtl", {});
  REQUIRE(loaded.scene);
  loaded.scene->samples = 9;
  const RayQuery query(*loaded.scene, 1);
  Color sum = black;
  explain::Question question;
  question.pixel = {440, 330};
  for (int i = 0; i < 9; ++i) {
    question.sample = i;
    sum += explain::Answer(*loaded.scene, "", query, question).tree->radiance;
  }
  CHECK(gap(sum * (1.0 / 9), explain::Answer(*loaded.scene, "", query, question).pixel.value()) < 1e-15);
}
