#include "tools/explain/why.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/question_arguments.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

#include <limits>

namespace rt::tools {
namespace {

struct Arguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<PictureArguments> picture;
  std::shared_ptr<QuestionArguments> question;
  int depth = std::numeric_limits<int>::max();
  bool is_json = false;
};

int run_why(const Arguments& arguments) {
  const explain::Question question = question_of(*arguments.question);
  lang::Loaded loaded = load(*arguments.scene);
  if (!loaded.scene) return exit_scene_is_wrong;
  apply(*arguments.picture, *loaded.scene);
  const RayQuery query(*loaded.scene);
  const std::string file = shown_name(*arguments.scene);
  const explain::Answer answer(*loaded.scene, file, query, question);
  print(arguments.is_json ? explain::why_json(answer, arguments.depth).dump(2) + "\n"
                          : explain::why_text(answer, arguments.depth));
  return exit_fine;
}

} // namespace

Action declare_why(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  arguments->question = add_question_arguments(app);
  app.add_option("--depth", arguments->depth, "tells rays down to this depth; of deeper ones only what they bring")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<int>::max()));
  app.add_flag("--json", arguments->is_json, "for machines");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("The numbers are the tracer's own; beside each hit stands its derivation. Colours are linear.");
  return [arguments] { return run_why(*arguments); };
}

} // namespace rt::tools
