#include "tools/bench/bars/rays.hpp"
#include "tools/bench/scenes/describe.hpp"

#include <benchmark/benchmark.h>

#include <memory>

// Building, and each kind of ray, on three of the measured scenes.
namespace {

using namespace rt;
using namespace rt::tools::bench;

constexpr std::array<std::string_view, 3> scenes = {"sphereflake_4", "rings", "random_10k"};
constexpr int size = 256;

void build(benchmark::State& state, std::string_view name) {
  const scene::Scene scene = describe(make_layout(name));
  for (auto _ : state) benchmark::DoNotOptimize(std::make_unique<CompiledScene>(scene, 1));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.objects.size()));
}

struct Prepared {
  scene::Scene scene;
  CompiledScene compiled;
  FrameRays rays;
  std::vector<Ray> camera, bounce;

  explicit Prepared(std::string_view name)
      : scene(describe(make_layout(name))), compiled(scene, 1), rays(frame_rays(compiled, scene.camera, size)) {
    for (const Ray& ray : rays.nearest) (ray.origin == scene.camera.at ? camera : bounce).push_back(ray);
  }
};

void trace(benchmark::State& state, const CompiledScene& compiled, const std::vector<Ray>& rays) {
  TraceScratch scratch;
  for (auto _ : state)
    for (const Ray& ray : rays) benchmark::DoNotOptimize(compiled.nearest(ray, {}, scratch).t);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays.size()));
}

void primary(benchmark::State& state, std::string_view name) {
  const Prepared p(name);
  trace(state, p.compiled, p.camera);
}

// As in rendering; here the rays of a packet are adjacent in a row of the picture.
void primary_packets(benchmark::State& state, std::string_view name) {
  const Prepared p(name);
  TraceScratch scratch;
  std::array<RayHit, bvh::packet_size> hits;
  for (auto _ : state)
    for (std::size_t i = 0; i + bvh::packet_size <= p.camera.size(); i += bvh::packet_size) {
      p.compiled.nearest(std::span(p.camera).subspan(i, bvh::packet_size), {}, hits, scratch);
      benchmark::DoNotOptimize(hits.data());
    }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.camera.size()));
}

void bounce(benchmark::State& state, std::string_view name) {
  const Prepared p(name);
  trace(state, p.compiled, p.bounce);
}

void shadow(benchmark::State& state, std::string_view name) {
  const Prepared p(name);
  TraceScratch scratch;
  for (auto _ : state)
    for (std::size_t i = 0; i < p.rays.shadow.size(); ++i)
      benchmark::DoNotOptimize(p.compiled.transmittance(p.rays.shadow[i], {0, p.rays.shadow_ends[i]}, scratch));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.rays.shadow.size()));
}

[[maybe_unused]] const bool are_registered = [] {
  for (const std::string_view name : scenes)
    for (const auto& [what, run] :
         {std::pair{"build/", &build}, std::pair{"primary/", &primary}, std::pair{"primary_packets/", &primary_packets},
          std::pair{"shadow/", &shadow}, std::pair{"bounce/", &bounce}})
      benchmark::RegisterBenchmark((what + std::string(name)).c_str(), run, name)->Unit(benchmark::kMillisecond);
  return true;
}();

} // namespace
