#include "tools/live/povray.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <thread>

namespace rt::tools::live {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

povray::ShootOptions shoot_options(const CheckOptions& options) {
  povray::ShootOptions shoot;
  shoot.run.stop = options.stop;
  shoot.run.time_limit = options.time_limit;
  shoot.run.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return shoot;
}

} // namespace

PovrayExport export_povray(const Document& document, bool has_comments) {
  povray::Exported exported = povray::export_povray(document.scene(), {.comments = has_comments});
  PovrayExport result{std::move(exported.text), ""};
  for (const povray::Inexact& inexact : exported.inexact) {
    const std::string place = place_text(document.scene(), inexact.origin);
    result.problems += fmt::format("error: {}\n", inexact.message);
    if (!place.empty()) result.problems += fmt::format("  --> {}\n", place);
  }
  return result;
}

std::string waiting_text(double seconds) {
  return fmt::format("waiting for POV-Ray, {:.0f} s", seconds);
}

std::unique_ptr<const Check> check(Document& document, const CheckOptions& options) {
  const scene::Scene& scene = document.scene();
  auto check = std::make_unique<Check>();
  povray::Report& report = check->report;
  report.scene = document.file();
  report.gates = options.gates;
  report.povray_version = povray::version();
  report.description = &scene;
  report.inexact = povray::export_povray(scene).inexact;
  const Clock::time_point start = Clock::now();
  auto theirs = std::async(std::launch::async, [&] {
    povray::Shots shots = povray::shoot(scene, shoot_options(options));
    report.povray_seconds = seconds_since(start);
    return shots;
  });
  RenderOptions ours;
  ours.layers = true;
  ours.integrator = IntegratorKind::whitted_exported;
  ours.stop = options.stop;
  ours.on_progress = options.on_progress;
  check->film = document.render_whitted(ours).film;
  report.render_seconds = seconds_since(start);
  while (theirs.wait_for(std::chrono::milliseconds(200)) != std::future_status::ready)
    if (options.on_wait) options.on_wait(seconds_since(start));
  if (options.stop && *options.stop) return nullptr;
  check->shots = theirs.get();
  report.film = &check->film;
  report.shots = &check->shots;
  report.comparison = povray::compare(scene, check->film, check->shots, report.gates);
  return check;
}

} // namespace rt::tools::live
