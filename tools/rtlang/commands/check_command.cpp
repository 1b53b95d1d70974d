#include "renderer/image/file.hpp"
#include "renderer/render/render.hpp"
#include "tools/povray/compare/report.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/gate_arguments.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <chrono>
#include <future>
#include <thread>

namespace rt::tools {
namespace {

struct Arguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<PictureArguments> picture;
  std::vector<std::string> gates;
  std::string html;
  bool is_json = false;
  double time_limit = 600;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

povray::Gates gates_of(const Arguments& arguments) {
  povray::Gates gates;
  std::vector<NamedNumber> known;
  for (const povray::GateName& gate : povray::gate_names()) known.push_back({gate.name, &(gates.*gate.value)});
  set_gates(arguments.gates, known);
  return gates;
}

// POV-Ray works while we do.
povray::Report make_report(const Arguments& arguments, const scene::Scene& scene, Film& film, povray::Shots& shots) {
  povray::Report report;
  report.scene = shown_name(*arguments.scene);
  report.gates = gates_of(arguments);
  report.povray_version = povray::version();
  report.description = &scene;
  report.inexact = povray::export_povray(scene).inexact;
  const auto start = std::chrono::steady_clock::now();
  povray::ShootOptions options;
  options.run.stop = &stop_flag();
  options.run.time_limit = std::chrono::milliseconds(static_cast<long>(1000 * arguments.time_limit));
  options.run.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  auto theirs = std::async(std::launch::async, [&] {
    povray::Shots result = povray::shoot(scene, options);
    report.povray_seconds = seconds_since(start);
    return result;
  });
  RenderOptions ours;
  ours.layers = true;
  ours.stop = &stop_flag();
  film = render(scene, ours).film;
  report.render_seconds = seconds_since(start);
  theirs.wait();
  throw_if_stopped();
  shots = theirs.get();
  report.film = &film;
  report.shots = &shots;
  report.comparison = povray::compare(scene, film, shots, report.gates);
  return report;
}

int run_check(const Arguments& arguments) {
  gates_of(arguments);
  lang::Loaded loaded = load(*arguments.scene);
  if (!loaded.scene) return exit_scene_is_wrong;
  apply(*arguments.picture, *loaded.scene);
  if (!arguments.html.empty()) require_writable(arguments.html);
  Film film;
  povray::Shots shots;
  const povray::Report report = make_report(arguments, *loaded.scene, film, shots);
  if (!arguments.html.empty()) replace_file(arguments.html, povray::report_html(report));
  print(arguments.is_json ? povray::report_json(report) : povray::report_text(report));
  return report.holds() ? exit_fine : exit_scene_is_wrong;
}

} // namespace

Action declare_check(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  app.add_option("--report", arguments->html, "writes a page with pictures, maps of differences and the worst pixels")
      ->type_name("FILE.html");
  app.add_flag("--json", arguments->is_json, "prints the result as JSON");
  app.add_option("--gate", arguments->gates, "moves a bound; can be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--time-limit", arguments->time_limit, "seconds that each run of POV-Ray may take (600)")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("Renders with both rtlang and POV-Ray 3.7 and compares what each pixel's centre ray hits, how far away, "
             "with which\n"
             "normal, and the pixel's colour. The exit code is 0 if every gate holds, 1 if not, 3 if POV-Ray is not "
             "installed.\n"
             "Gates: ids, depth, depth_p999, normals, color, color_share, color_unexplained. A pixel of another colour "
             "is explained\n"
             "if it agrees once POV-Ray's own limits are taken over; no other may differ, and 99 % have to be equal as "
             "they are.");
  return [arguments] { return run_check(*arguments); };
}

} // namespace rt::tools
