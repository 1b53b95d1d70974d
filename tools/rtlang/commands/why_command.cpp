#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/question_arguments.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <limits>

namespace rt::tools {
namespace {

struct WhyArguments : QuestionArguments {
  live::WhyOptions options;
};

} // namespace

Action declare_why(CLI::App& app) {
  auto arguments = std::make_shared<WhyArguments>();
  arguments->question = add_question_arguments(app);
  app.add_option("--depth", arguments->options.depth, "expands rays down to this depth; deeper ones are summarised")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<int>::max()));
  app.add_flag("--json", arguments->options.as_json, "prints JSON");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("The numbers are the renderer's own; each hit is shown with its derivation. Colours are linear.");
  return [arguments] {
    return answer_question(*arguments, [&](live::Document& document, const explain::Question& question) {
      return document.why(question, arguments->options);
    });
  };
}

} // namespace rt::tools
