// Measures what a change costs in a session of 100,000 objects, and how long a preview takes.
//   bench_session [SCENE]   SCENE: what the preview is of, examples/still_life.rtl unless given

#include "lang/session/session.hpp"
#include "renderer/compile/compile.hpp"
#include "renderer/compile/compiled_scene.hpp"
#include "renderer/render/render.hpp"
#include "tools/terminal/picture.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

using rt::lang::Session;

constexpr int objects = 100'000;
constexpr int unlike_statements = 10'000;
constexpr rt::scene::Resolution preview_size{160, 120};

// Wall time, and CPU time of all threads: on a machine with other load only the latter is meaningful.
struct Times {
  double wall = 0, cpu = 0; // milliseconds
};

class Stopwatch {
public:
  Times elapsed() const {
    const auto wall = std::chrono::steady_clock::now() - start_;
    return {std::chrono::duration<double, std::milli>(wall).count(),
            1e3 * static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC};
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::clock_t cpu_start_ = std::clock();
};

std::vector<rt::Part> parts_of(Session& session) {
  std::vector<rt::Part> parts;
  for (const rt::lang::SceneRange& s : session.ranges()) parts.push_back({s.begin, s.end, s.stamp});
  return parts;
}

// The time of the parts of a change.
struct Parts {
  std::vector<Times> evaluating, building, tracing;
};

void preview(Session& session, rt::CompileCache& cache, rt::scene::Resolution size, Parts& parts) {
  const Stopwatch build;
  const rt::scene::Scene& scene = session.scene();
  const rt::CompiledScene compiled(scene, parts_of(session), cache);
  parts.building.push_back(build.elapsed());
  const Stopwatch trace;
  rt::render(compiled, {scene.camera, size, 1}, {});
  parts.tracing.push_back(trace.elapsed());
}

Times median(const std::vector<Times>& all) {
  const auto middle = [&all](double Times::*member) {
    std::vector<double> values;
    for (const Times& times : all) values.push_back(times.*member);
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  return {middle(&Times::wall), middle(&Times::cpu)};
}

constexpr const char* view =
    "camera { at: [50, 60, 130], look_at: [50, 0, 45], fov: 50 }\nsun { direction: [-1, -2, -1] }\n";

std::string one_loop() {
  return fmt::format("for i in 0..<{} {{ sphere {{ at: [i % 100, (i / 100) % 10, i / 1000], radius: 0.3 }} }}\n",
                     objects);
}

std::string many_lines() {
  std::string text;
  for (int i = 0; i < objects; ++i)
    text += fmt::format("sphere {{ at: [{}, {}, {}], radius: 0.3 }}\n", i % 100, i / 100 % 10, i / 1000);
  return text;
}

// Names, and things of several kinds that use them.
std::string unlike_lines() {
  std::string text;
  for (int i = 0; i < unlike_statements / 4; ++i)
    text += fmt::format("r{0} = {1}\nball{0} = sphere {{ radius: r{0}, at: [{2}, 0, {3}] }}\nball{0}\n"
                        "box {{ size: r{0}, at: [{2}, 1, {3}] }}\n",
                        i, 0.2 + 0.0001 * i, i % 100, i / 100);
  return text;
}

// A start of the program, with the same scene plus one sphere.
Times start_afresh(const std::string& path) {
  const std::string changed = path + ".more.rtl", picture = path + ".ppm";
  std::filesystem::copy_file(path, changed, std::filesystem::copy_options::overwrite_existing);
  std::ofstream(changed, std::ios::app) << "sphere { at: [50, 12, 50], radius: 3 }\n";
  const std::string size = fmt::format("{}x{}", preview_size[0], preview_size[1]);
  std::vector<std::string> words{RTLANG_BINARY, changed, "--quiet", "--size", size, "-o", picture};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  if (posix_spawn(&child, RTLANG_BINARY, nullptr, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error("the program cannot be started");
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const auto wall = std::chrono::steady_clock::now() - start;
  std::filesystem::remove(changed);
  std::filesystem::remove(picture);
  if (status != 0) throw std::runtime_error("the program failed");
  const auto milliseconds = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return {std::chrono::duration<double, std::milli>(wall).count(),
          milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime)};
}

void measure_change(const std::string& name, const std::string& path, std::uint64_t count) {
  std::vector<Times> fresh, changed;
  for (int i = 0; i < 5; ++i) fresh.push_back(start_afresh(path));
  Session session(".");
  session.load(path);
  rt::CompileCache cache(0);
  Parts first, parts;
  preview(session, cache, preview_size, first);
  const auto counters = session.counters();
  const auto counts = cache.counts();
  constexpr int changes = 15;
  for (int i = 0; i < changes; ++i) {
    const Stopwatch watch;
    session.submit(fmt::format("sphere {{ at: [{}, 12, 50], radius: 3 }}", 40 + i));
    parts.evaluating.push_back(watch.elapsed());
    preview(session, cache, preview_size, parts);
    changed.push_back(watch.elapsed());
  }
  const Times before = median(fresh), after = median(changed);
  fmt::print("{:<20} a fresh start {:.0f} ms (cpu {:.0f}), one sphere more {:.1f} ms (cpu {:.1f}): {:.1f} times faster "
             "(cpu {:.1f})\n",
             name, before.wall, before.cpu, after.wall, after.cpu, before.wall / after.wall, before.cpu / after.cpu);
  fmt::print("{:<20} cpu of it: session {:.2f} ms, building {:.2f} ms, tracing {:.2f} ms\n", "",
             median(parts.evaluating).cpu, median(parts.building).cpu, median(parts.tracing).cpu);
  fmt::print("{:<20} of {} objects evaluated again {}, rebuilt {}, in {} changes\n", "", count,
             session.counters().objects_evaluated - counters.objects_evaluated - changes,
             cache.counts().objects_built - counts.objects_built, changes);
}

void measure_preview(const std::string& path) {
  Session session(".");
  if (!session.load(path).is_accepted) throw std::runtime_error("the scene does not load");
  const rt::tools::PicturePrinter printer(true);
  rt::CompileCache cache(0);
  std::vector<Times> times;
  for (int i = 0; i < 9; ++i) {
    const Stopwatch watch;
    const rt::scene::Scene& scene = session.scene();
    const rt::CompiledScene compiled(scene, parts_of(session), cache);
    const rt::Rendered rendered = rt::render(compiled, {scene.camera, {320, 240}, 1}, {});
    const std::string text = printer.print(rendered.film, {79, 30, 320, 240});
    times.push_back(watch.elapsed());
  }
  fmt::print("preview of {} at 320x240: {:.0f} ms (cpu {:.0f})\n", path, median(times).wall, median(times).cpu);
}

void run(int count, char** arguments) {
  const auto measure = [](const std::string& name, const std::string& text, std::uint64_t objects_of_text) {
    const std::string path = (std::filesystem::temp_directory_path() / "rtlang_bench_session.rtl").string();
    std::ofstream(path) << view << text;
    measure_change(name, path, objects_of_text);
    std::filesystem::remove(path);
  };
  measure("one `for` of 100,000", one_loop(), objects);
  measure("100,000 lines", many_lines(), objects);
  measure("10,000 unlike lines", unlike_lines(), unlike_statements / 2);
  measure_preview(count > 1 ? arguments[1] : "examples/still_life.rtl");
}

} // namespace

int main(int count, char** arguments) {
  try {
    run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_session: %s\n", error.what());
    return 3;
  }
}
