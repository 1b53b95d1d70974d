#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/question_arguments.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <limits>

namespace rt::tools {
namespace {

struct Arguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
  std::shared_ptr<explain::QuestionText> question;
  live::WhyOptions options;
};

int run_why(const Arguments& arguments) {
  const explain::Question question = explain::parse(*arguments.question);
  live::Document document = load_document(*arguments.scene, *arguments.picture);
  if (!document.has_scene()) return exit_scene_is_wrong;
  print(document.why(question, arguments.options));
  return exit_fine;
}

} // namespace

Action declare_why(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  arguments->question = add_question_arguments(app);
  app.add_option("--depth", arguments->options.depth, "expands rays down to this depth; deeper ones are summarised")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<int>::max()));
  app.add_flag("--json", arguments->options.as_json, "prints JSON");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("The numbers are the renderer's own; each hit is shown with its derivation. Colours are linear.");
  return [arguments] { return run_why(*arguments); };
}

} // namespace rt::tools
