#include "renderer/image/file.hpp"
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

struct ConvertArguments {
  std::shared_ptr<SceneArguments> scene;
  std::string output;
};

std::string known_formats() {
  std::string list;
  for (const import::Format& format : import::formats())
    list += fmt::format("{}{}'s end in {}", list.empty() ? "" : ", ", format.name, format.extension);
  return list;
}

int convert(const ConvertArguments& arguments) {
  const SceneArguments& scene = *arguments.scene;
  const import::Format* const format = import::format_of(scene.path);
  if (!format)
    throw UsageError(fmt::format("`{}` is of no format that can be converted: {}", scene.path, known_formats()));
  const import::Imported imported = format->read(read_text(scene), shown_name(scene), scene.import);
  if (!imported.diagnostics.empty() || scene.json_diagnostics) show(imported.diagnostics, imported.sources, scene);
  if (imported.has_errors()) return exit_scene_is_wrong;
  if (arguments.output.empty() || arguments.output == "-")
    print(imported.text);
  else
    replace_file(arguments.output, imported.text);
  return exit_fine;
}

} // namespace

Action declare_convert(CLI::App& app) {
  auto arguments = std::make_shared<ConvertArguments>();
  app.add_option("-o,--output", arguments->output, "the scene in our language; else standard output")
      ->type_name("FILE");
  arguments->scene = add_text_arguments(app);
  import::Options& options = arguments->scene->import;
  app.add_flag("--lenient", options.is_lenient, "accepts common extensions of the format");
  app.add_flag("--cylinders-on-foot", options.cylinders_stand_on_foot,
               "miniRT: a cylinder's point is the centre of its base, not of the cylinder");
  app.footer("Every command takes such a file directly too: `rtlang scene.rt -o out.png`.");
  return [arguments] { return convert(*arguments); };
}

} // namespace rt::tools
