#include "renderer/image/file.hpp"
#include "tools/povray/export/export.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace rt::tools {
namespace {

struct Arguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<PictureArguments> picture;
  std::string output;
  bool has_comments = true;
};

int run_export(const Arguments& arguments) {
  lang::Loaded loaded = load(*arguments.scene);
  if (!loaded.scene) return exit_scene_is_wrong;
  apply(*arguments.picture, *loaded.scene);
  const povray::Exported exported = povray::export_povray(*loaded.scene, {.comments = arguments.has_comments});
  for (const povray::Inexact& inexact : exported.inexact) {
    const std::string place = povray::place_text(*loaded.scene, inexact.origin);
    print_error(fmt::format("error: {}\n{}", inexact.message, place.empty() ? "" : fmt::format("  --> {}\n", place)));
  }
  if (!exported.inexact.empty()) return exit_scene_is_wrong;
  if (arguments.output.empty() || arguments.output == "-")
    print(exported.text);
  else
    replace_file(arguments.output, exported.text);
  return exit_fine;
}

} // namespace

Action declare_export(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  app.add_option("-o,--output", arguments->output, "the file to write, standard output if none is given")
      ->type_name("FILE");
  app.add_flag("!--no-comments", arguments->has_comments, "without the scene's names and lines");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("Writes the scene for POV-Ray 3.7, which computes the same picture from it. Nothing is written, and the "
             "exit code\n"
             "is 1, if the scene has something that POV-Ray cannot compute exactly; it is named.");
  return [arguments] { return run_export(*arguments); };
}

} // namespace rt::tools
