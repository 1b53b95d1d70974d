#include "renderer/image/file.hpp"
#include "tools/oracle/runs.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <filesystem>

using namespace rt::tools;

namespace {

struct Arguments {
  oracle::RunSettings settings;
  std::string mode = "color";
  std::string folder = ".";
  long print_only = -1;
  bool all_pairs = false;
  bool lists_explained = false;
  bool is_quiet = false;
};

void declare(CLI::App& app, Arguments& a) {
  app.add_option("--scenes", a.settings.scenes, "how many");
  app.add_option("--seed", a.settings.seed, "of the run");
  app.add_option("--first", a.settings.first, "the number of the first scene: --first 17 --scenes 1 repeats one");
  app.add_option("--mode", a.mode, "color: whole pictures; geometry: rays against shapes")
      ->check(CLI::IsMember({"color", "geometry"}));
  app.add_option("--at-once", a.settings.at_once, "POV-Rays that work at the same time");
  app.add_option("--rays", a.settings.rays, "for each scene's geometry");
  app.add_option("--save", a.folder, "the folder that failing scenes are saved in");
  app.add_option("--keep", a.settings.keep_failures, "how many failing scenes are made small and saved");
  app.add_option("--print", a.print_only, "only prints the scene of this number");
  app.add_flag("--pairs", a.all_pairs, "prints how often each pair of features occurred");
  app.add_flag("--explained", a.lists_explained, "prints each pixel whose colour differs with an explanation");
  app.add_flag("-q,--quiet", a.is_quiet, "no progress");
}

int run(Arguments& a) {
  const oracle::Mode mode = a.mode == "color" ? oracle::Mode::color : oracle::Mode::geometry;
  if (a.print_only >= 0) {
    oracle::Dice dice(oracle::scene_seed(a.settings.seed, static_cast<std::uint64_t>(a.print_only)));
    print(oracle::print(oracle::random_scene(dice, mode)));
    return exit_fine;
  }
  if (!a.is_quiet && error_is_terminal())
    a.settings.on_progress = [&](std::size_t done) {
      if (done % 50 == 0) print_error(fmt::format("\r{} of {} scenes", done, a.settings.scenes));
    };
  a.settings.stop = &stop_flag();
  const oracle::RunResult result = mode == oracle::Mode::color ? run_colors(a.settings) : run_geometry(a.settings);
  throw_if_stopped();
  print(report(result, mode, a.all_pairs));
  if (a.lists_explained) print(list_explained(result));
  for (std::size_t i = 0; i < std::min(a.settings.keep_failures, result.failures.size()); ++i) {
    const oracle::Failure& f = result.failures[i];
    const std::string path = fmt::format("{}/{}_{}_{}.rtl", a.folder, a.mode, a.settings.seed, f.scene);
    rt::replace_file(
        path, fmt::format("// {} run, seed {}, scene {}: {}\n{}", a.mode, a.settings.seed, f.scene, f.what, f.text));
    print(fmt::format("saved {}\n", path));
  }
  return holds(result, mode) ? exit_fine : exit_scene_is_wrong;
}

} // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Random scenes against POV-Ray 3.7");
  declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  listen_to_signals();
  try {
    return run(arguments);
  } catch (const Interrupted&) {
    return exit_signal_base + stop_signal();
  } catch (const std::exception& error) {
    print_error(fmt::format("random_scenes: {}\n", error.what()));
    return exit_environment;
  }
}
