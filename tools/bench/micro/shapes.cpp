#include "renderer/scene/shapes.hpp"

#include <benchmark/benchmark.h>

#include <random>
#include <string>

// Each shape's intersection, with rays from outside, about half of which hit.
namespace {

using namespace rt;

std::vector<Ray> rays() {
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  const auto point = [&] {
    const double x = normal(engine), y = normal(engine), z = normal(engine);
    return Vec3{x, y, z};
  };
  std::vector<Ray> all;
  for (int i = 0; i < 1024; ++i) {
    const Vec3 origin = normalize(point()) * 4;
    all.push_back({origin, normalize(point() * 0.6 - origin)});
  }
  return all;
}

template <class S>
S example() {
  return {};
}
template <>
scene::Polygon example<scene::Polygon>() {
  scene::Polygon polygon;
  polygon.points = {{-1, -1, 0}, {1, -1, 0}, {0.3, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
  return polygon;
}

template <class S>
void intersect_one(benchmark::State& state) {
  const auto shape = geometry(example<S>());
  const std::vector<Ray> all = rays();
  std::size_t i = 0, hits = 0;
  for (auto _ : state) {
    Hit hit;
    hits += intersect(shape, all[i++ % all.size()], Interval{}, hit) ? 1 : 0;
    benchmark::DoNotOptimize(hit);
  }
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}

[[maybe_unused]] const bool are_registered = [] {
  scene::ShapeKinds::for_each([]<class S>() {
    if constexpr (!scene::is_composite<S>)
      benchmark::RegisterBenchmark(("intersect_" + std::string(S::noun)).c_str(), &intersect_one<S>);
  });
  return true;
}();

} // namespace
