#include "renderer/image/file.hpp"
#include "tools/live/povray.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/gate_arguments.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"
#include "tools/terminal/progress_bar.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <chrono>

namespace rt::tools {
namespace {

struct CheckArguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
  std::vector<std::string> gates;
  std::string html;
  bool is_json = false;
  double time_limit = 600;
};

povray::Gates gates_of(const CheckArguments& arguments) {
  povray::Gates gates;
  std::vector<NamedNumber> known;
  for (const povray::GateName& gate : povray::gate_names()) known.push_back({gate.name, &(gates.*gate.value)});
  set_gates(arguments.gates, known);
  return gates;
}

std::unique_ptr<const live::Check> check_with_progress(live::Document& document, live::CheckOptions options,
                                                       const SceneArguments& scene) {
  ProgressBar bar;
  if (error_is_terminal() && !scene.is_quiet && !scene.json_diagnostics) {
    options.on_progress = [&bar](const Progress& progress) { bar.show(progress); };
    options.on_wait = [&bar](double seconds) { bar.show(live::waiting_text(seconds), seconds); };
  }
  return live::check(document, options);
}

int run_check(const CheckArguments& arguments) {
  live::CheckOptions options;
  options.gates = gates_of(arguments);
  options.time_limit = std::chrono::milliseconds(static_cast<long>(1000 * arguments.time_limit));
  options.stop = &stop_flag();
  live::Document document = load_document(*arguments.scene, *arguments.picture);
  if (!document.has_scene()) return exit_scene_is_wrong;
  if (!arguments.html.empty()) require_writable(arguments.html);
  const auto check = check_with_progress(document, options, *arguments.scene);
  if (!check) throw Interrupted{};
  const povray::Report& report = check->report;
  if (!arguments.html.empty()) replace_file(arguments.html, povray::report_html(report));
  print(arguments.is_json ? povray::report_json(report) : povray::report_text(report));
  return report.holds() ? exit_fine : exit_scene_is_wrong;
}

} // namespace

Action declare_check(CLI::App& app) {
  auto arguments = std::make_shared<CheckArguments>();
  app.add_option("--report", arguments->html, "writes a page with both pictures, difference maps and the worst pixels")
      ->type_name("FILE.html");
  app.add_flag("--json", arguments->is_json, "prints the result as JSON");
  app.add_option("--gate", arguments->gates, "changes a threshold (repeatable)")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--time-limit", arguments->time_limit, "time limit of each run of POV-Ray (600)")
      ->type_name("SECONDS")
      ->check(CLI::PositiveNumber);
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer(
      "Renders the scene with both rtlang and POV-Ray 3.7, and compares for each pixel the object that its centre ray "
      "hits, the distance, the normal and the colour. The exit code is 0 if every gate holds, 1 if not, 3 if "
      "POV-Ray is not installed. Gates: ids, depth, depth_p999, normals, color, color_share, color_unexplained. "
      "A pixel that differs counts as explained if it agrees once traced by POV-Ray's own rules; "
      "unexplained ones are not allowed, and 99 % of the pixels have to be equal.");
  return [arguments] { return run_check(*arguments); };
}

} // namespace rt::tools
