#include "lang/load.hpp"
#include "renderer/render/render.hpp"
#include "tools/bench/bars/glass.hpp"
#include "tools/bench/bars/native.hpp"
#include "tools/bench/process.hpp"
#include "tools/bench/scenes/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <regex>

// Measures what the comparison with other programs does not cover, and prints it as a Markdown table.
namespace rt::tools::bench {
namespace {

namespace fs = std::filesystem;

void row(std::string_view what, std::string_view value) {
  fmt::print("| {} | {} |\n", what, value);
  std::fflush(stdout);
}

double least_of(int runs, const std::function<double()>& measure) {
  double least = measure();
  for (int i = 1; i < runs; ++i) least = std::min(least, measure());
  return least;
}

lang::Loaded load(const std::string& text) {
  lang::Loaded loaded = lang::load_text(text, "scene", ".", {});
  if (!loaded.scene) throw std::runtime_error("a scene has errors");
  return loaded;
}

double load_seconds(const std::string& text) {
  return least_of(3, [&] {
    const double start = cpu_seconds();
    load(text);
    return cpu_seconds() - start;
  });
}

void reading(const std::string& literal) {
  row(fmt::format("reading 1 million spheres as literal text ({:.0f} MB): parse, check, evaluate, CPU",
                  static_cast<double>(literal.size()) * 1e-6),
      fmt::format("{:.2f} s", load_seconds(literal)));
  const std::string body = "sphere { at: [i % 100, floor(i / 100) % 100, floor(i / 10000)], radius: 0.3 }";
  row("1 million spheres from a `for`, CPU",
      fmt::format("{:.2f} s", load_seconds("for i in 0..<1000000 { " + body + " }\n")));
  row("1 million spheres from a comprehension, CPU",
      fmt::format("{:.2f} s", load_seconds("[" + body + " for i in 0..<1000000]\n")));
  std::ifstream file(RTLANG_SOURCE_DIR "/tools/bench/scenes/sphereflake.rtl");
  const std::string flake(std::istreambuf_iterator<char>(file), {});
  row("sphereflake_6 as written in our own language (`scenes/sphereflake.rtl`), CPU",
      fmt::format("{:.2f} s", load_seconds(std::regex_replace(flake, std::regex("depth = 4"), "depth = 6"))));
}

double trace_seconds(const scene::Scene& scene, int threads) {
  RenderOptions options;
  options.threads = threads;
  return render(scene, options).statistics.trace_seconds;
}

// In turns, so that other load on the machine affects both alike.
void threads() {
  const scene::Scene scene = describe(make_layout("sphereflake_4"));
  double one = trace_seconds(scene, 1), two = trace_seconds(scene, 2);
  for (int i = 0; i < 8; ++i) {
    one = std::min(one, trace_seconds(scene, 1));
    two = std::min(two, trace_seconds(scene, 2));
  }
  row("2 threads against 1, wall, trace phase (sphereflake_4)", fmt::format("{:.2f}×", one / two));
}

double trace_cpu(std::string_view name) {
  const scene::Scene scene = describe(make_layout(name));
  const CompiledScene compiled(scene, 1);
  RenderOptions options;
  options.threads = 1;
  return least_of(3, [&] {
    const double start = cpu_seconds();
    render(compiled, {scene.camera, scene.size, 1}, options);
    return cpu_seconds() - start;
  });
}

void growth() {
  const double small = trace_cpu("random_10k"), large = trace_cpu("random_1m");
  row("trace phase, 10 thousand to 1 million spheres, CPU",
      fmt::format("{:.2f} s to {:.2f} s: {:.2f}×", small, large, large / small));
}

void native() {
  double logarithms = 0;
  int count = 0;
  for (const std::string_view name : {"sphereflake_4", "mixed", "random_1m"}) {
    const Layout layout = make_layout(name);
    const scene::Scene scene = describe(layout);
    const CompiledScene compiled(scene, 1);
    const FrameRays rays = frame_rays(compiled, scene.camera, picture_size / 2);
    TracingCost exact = trace_exactly(compiled, rays), native = trace_natively(layout, rays);
    for (int i = 0; i < 2; ++i) {
      exact.seconds = std::min(exact.seconds, trace_exactly(compiled, rays).seconds);
      native.seconds = std::min(native.seconds, trace_natively(layout, rays).seconds);
    }
    row(fmt::format("{}: Embree's float shapes against ours in double, the {:.2f} M rays of a Whitted frame, CPU", name,
                    static_cast<double>(rays.nearest.size() + rays.shadow.size()) * 1e-6),
        fmt::format("{:.2f} s / {:.2f} s = {:.2f}×", native.seconds, exact.seconds, native.seconds / exact.seconds));
    logarithms += std::log(native.seconds / exact.seconds);
    ++count;
  }
  row("Embree's float shapes against ours in double: geometric mean of these",
      fmt::format("{:.2f}×", std::exp(logarithms / count)));
}

constexpr std::string_view ten_million = R"(max_depth: 3
cloud = group {
  for i in 0..<10000 {
    sphere { at: [random(i, 0), random(i, 1), random(i, 2)], radius: 0.01 }
  }
}
for i in 0..<1000 {
  cloud { at: [i % 10 * 1.2, floor(i / 10) % 10 * 1.2, floor(i / 100) * 1.2] }
}
)";

void processes(const std::string& program) {
  const fs::path folder = "bench_bars.tmp";
  fs::create_directories(folder);
  std::ofstream(folder / "one.rtl") << "sphere {}\n";
  std::ofstream(folder / "clouds.rtl") << ten_million;
  run_apart([&] { std::ofstream(folder / "million.rtl") << write(make_layout("random_1m"), Format::rtl); });
  const Command small{program, "render", "one.rtl", "-o", "one.png", "--size", "160x120"};
  row("`sphere {}` at 160×120, start to finished file, wall, least of 40",
      fmt::format("{:.1f} ms", 1000 * least_of(40, [&] { return run(small, folder, "log").wall_seconds; })));
  const Cost clouds = run({program, "render", "clouds.rtl", "-o", "clouds.png"}, folder, "log");
  row("10 million spheres, 1,000 instances of a group of 10,000, 800×600: peak memory",
      fmt::format("{:.0f} MB ({:.2f} s CPU)", clouds.peak_megabytes, clouds.user_seconds));
  const Cost million = run({program, "render", "million.rtl", "-o", "million.png"}, folder, "log");
  row("1 million spheres as literal text: peak memory of the whole run",
      fmt::format("{:.0f} MB", million.peak_megabytes));
  measure_glass(program, folder.string(), row);
  fs::remove_all(folder);
}

} // namespace
} // namespace rt::tools::bench

int main(int argc, char** argv) {
  using namespace rt::tools::bench;
  if (argc != 2) {
    std::cerr << "usage: bench_bars RTLANG\n";
    return 2;
  }
  try {
    fmt::print("| what | measured |\n|---|---|\n");
    processes(std::filesystem::absolute(argv[1]).string()); // while this process is small
    reading(write(make_layout("random_1m"), Format::rtl));
    threads();
    growth();
    native();
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "bench_bars: " << error.what() << '\n';
    return 3;
  }
}
