#include "tools/rtlang/statistics.hpp"

#include "tools/terminal/quantity.hpp"
#include "tools/terminal/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace rt::tools {
namespace {

struct Process {
  double user_seconds, system_seconds;
  std::uint64_t peak_bytes;
};

Process process() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return {seconds(usage.ru_utime), seconds(usage.ru_stime), static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
}

double rays_per_second(const RenderStatistics& render) {
  return render.trace_seconds > 0 ? static_cast<double>(count_rays(render)) / render.trace_seconds : 0;
}

std::string bytes(std::uint64_t value) {
  return human(static_cast<double>(value)) + (value < 1000 ? " B" : "B");
}

// "1 primitive", "20 primitives".
std::string counted(std::uint64_t n, std::string_view noun) {
  return fmt::format("{} {}{}", human(static_cast<double>(n)), noun, n == 1 ? "" : "s");
}

std::string seconds(double value) {
  return fmt::format("{:.{}f} s", value, value < 9.995 ? 2 : 1);
}

// ", 256 samples, noise 0.0087"; nothing in Whitted mode.
std::string quality(const RunStatistics& s) {
  if (!s.render.noise) return "";
  return fmt::format(", {} samples, noise {:.2g}", human(s.render.samples), *s.render.noise);
}

} // namespace

std::uint64_t count_rays(const RenderStatistics& s) {
  return s.rays.total();
}

std::string summary(const RunStatistics& s) {
  return fmt::format("{}: {}×{}{}, {}{}, {} rays in {} ({}/s), all in {}\n", fmt::join(s.outputs, ", "), s.width,
                     s.height, s.is_complete ? "" : ", incomplete", counted(s.render.primitives, "primitive"),
                     quality(s), human(static_cast<double>(count_rays(s.render))), seconds(s.render.trace_seconds),
                     human(rays_per_second(s.render)), seconds(s.total_seconds));
}

std::string table(const RunStatistics& s) {
  const Process own = process();
  const RenderStatistics& r = s.render;
  const auto count = [](std::uint64_t n) { return human(static_cast<double>(n)); };
  std::string text;
  const auto row = [&](std::string_view name, const std::string& value) {
    text += fmt::format("{:<12}{}\n", name, value);
  };
  row("scene", fmt::format("{} (hash {}), {}", s.scene, s.scene_hash, counted(r.primitives, "primitive")));
  row("picture", fmt::format("{}×{}{}, {} per pixel: {}", s.width, s.height, s.is_complete ? "" : " (incomplete)",
                             human(s.render.samples) + (s.render.samples == 1 ? " sample" : " samples"),
                             fmt::join(s.outputs, ", ")));
  if (r.noise) row("noise", fmt::format("{:.2g} of full scale in the noisiest part", *r.noise));
  row("rays", fmt::format("{}: {} from the camera, {} to lights, {} reflected, {} refracted{}", count(count_rays(r)),
                          count(r.rays.camera), count(r.rays.shadow), count(r.rays.reflected), count(r.rays.refracted),
                          r.rays.scattered == 0 ? "" : fmt::format(", {} scattered", count(r.rays.scattered))));
  row("speed", fmt::format("{} rays/s on {}", human(rays_per_second(r)),
                           counted(static_cast<std::uint64_t>(r.threads), "thread")));
  row("load", fmt::format("{}: parse {}, check {}, evaluate {} ({} of text, {} steps)", seconds(s.load_seconds),
                          seconds(s.load.parse_seconds), seconds(s.load.check_seconds),
                          seconds(s.load.evaluate_seconds), bytes(s.load.bytes), count(s.load.steps)));
  row("render", fmt::format("build {}, trace {}", seconds(r.build_seconds), seconds(r.trace_seconds)));
  row("write", seconds(s.write_seconds));
  row("total", fmt::format("{} (CPU: {} user, {} system)", seconds(s.total_seconds), seconds(own.user_seconds),
                           seconds(own.system_seconds)));
  row("memory", bytes(own.peak_bytes) + " at its peak");
  return text;
}

std::string json(const RunStatistics& s) {
  const Process own = process();
  const RenderStatistics& r = s.render;
  nlohmann::ordered_json j;
  j["program"] = fmt::format("rtlang {}", version_number());
  j["scene"] = s.scene;
  j["scene_hash"] = s.scene_hash;
  j["outputs"] = s.outputs;
  j["width"] = s.width;
  j["height"] = s.height;
  j["samples"] = s.render.samples;
  if (s.render.noise) j["noise"] = *s.render.noise;
  j["is_complete"] = s.is_complete;
  j["primitives"] = r.primitives;
  j["threads"] = r.threads;
  j["rays"] = {{"camera", r.rays.camera},       {"shadow", r.rays.shadow},       {"reflected", r.rays.reflected},
               {"refracted", r.rays.refracted}, {"scattered", r.rays.scattered}, {"total", count_rays(r)}};
  j["rays_per_second"] = rays_per_second(r);
  j["source_bytes"] = s.load.bytes;
  j["steps"] = s.load.steps;
  j["seconds"] = {
      {"parse", s.load.parse_seconds},   {"check", s.load.check_seconds}, {"evaluate", s.load.evaluate_seconds},
      {"load", s.load_seconds},          {"build", r.build_seconds},      {"trace", r.trace_seconds},
      {"write", s.write_seconds},        {"total", s.total_seconds},      {"cpu_user", own.user_seconds},
      {"cpu_system", own.system_seconds}};
  j["peak_memory_bytes"] = own.peak_bytes;
  // A scene's name need not be valid UTF-8.
  return j.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

} // namespace rt::tools
