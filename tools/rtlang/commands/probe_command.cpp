#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/question_arguments.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace rt::tools {
namespace {

struct Arguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
  std::shared_ptr<explain::QuestionText> question;
  live::ProbeOptions options;
};

int run_probe(const Arguments& arguments) {
  const explain::Question question = explain::parse(*arguments.question);
  live::Document document = load_document(*arguments.scene, *arguments.picture);
  if (!document.has_scene()) return exit_scene_is_wrong;
  print(document.probe(question, arguments.options));
  return exit_fine;
}

} // namespace

Action declare_probe(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  arguments->question = add_question_arguments(app);
  app.add_flag("--all", arguments->options.all, "lists all hits in order, not only the nearest");
  app.add_flag("--json", arguments->options.as_json, "prints JSON");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("t is in lengths of the direction, the distance in scene units. A miss is an answer, not an error.");
  return [arguments] { return run_probe(*arguments); };
}

} // namespace rt::tools
