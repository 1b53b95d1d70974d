#include "renderer/image/file.hpp"
#include "tools/live/povray.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace rt::tools {
namespace {

struct ExportArguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
  std::string output;
  bool has_comments = true;
};

int run_export(const ExportArguments& arguments) {
  const live::Document document = load_document(*arguments.scene, *arguments.picture);
  if (!document.has_scene()) return exit_scene_is_wrong;
  const live::PovrayExport exported = live::export_povray(document, arguments.has_comments);
  print_error(exported.problems);
  if (!exported.problems.empty()) return exit_scene_is_wrong;
  if (arguments.output.empty() || arguments.output == "-")
    print(exported.text);
  else
    replace_file(arguments.output, exported.text);
  return exit_fine;
}

} // namespace

Action declare_export(CLI::App& app) {
  auto arguments = std::make_shared<ExportArguments>();
  app.add_option("-o,--output", arguments->output, "output file (standard output if omitted)")->type_name("FILE");
  app.add_flag("!--no-comments", arguments->has_comments, "omits the comments with names and lines");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer(
      "POV-Ray 3.7 renders the same picture from it. If the scene has something that POV-Ray cannot compute exactly, "
      "that is reported, nothing is written, and the exit code is 1.");
  return [arguments] { return run_export(*arguments); };
}

} // namespace rt::tools
