#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/question_arguments.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace rt::tools {
namespace {

struct ProbeArguments : QuestionArguments {
  live::ProbeOptions options;
};

} // namespace

Action declare_probe(CLI::App& app) {
  auto arguments = std::make_shared<ProbeArguments>();
  arguments->question = add_question_arguments(app);
  app.add_flag("--all", arguments->options.all, "lists all hits in order, not just the nearest");
  app.add_flag("--json", arguments->options.as_json, "prints JSON");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("t is in multiples of the direction vector, the distance in scene units. A miss is a valid result, not an "
             "error.");
  return [arguments] {
    return answer_question(*arguments, [&](live::Document& document, const explain::Question& question) {
      return document.probe(question, arguments->options);
    });
  };
}

} // namespace rt::tools
