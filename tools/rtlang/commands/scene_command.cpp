#include "tools/inspect/scene_hash.hpp"
#include "tools/inspect/scene_json.hpp"
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

struct SceneCommandArguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
  bool wants_hash = false;
};

int run_scene(const SceneCommandArguments& arguments) {
  lang::Loaded loaded = load(*arguments.scene);
  if (!loaded.scene) return exit_scene_is_wrong;
  arguments.picture->apply_to(*loaded.scene);
  if (arguments.wants_hash)
    print(fmt::format("{}\n", scene_hash(*loaded.scene)));
  else
    write_scene_json(*loaded.scene, print);
  return exit_fine;
}

} // namespace

Action declare_scene(CLI::App& app) {
  auto arguments = std::make_shared<SceneCommandArguments>();
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.add_flag("--hash", arguments->wants_hash, "prints only the hash stored in pictures of the scene");
  app.footer(
      "Numbers are exact and colours linear. Materials, patterns, groups and combinations are referred to by index.\n"
      "`id` is an object's number in the layer object.id of an exr, `ids` the first and the last of a group's; "
      "`manifest`\n"
      "gives their names.");
  return [arguments] { return run_scene(*arguments); };
}

} // namespace rt::tools
