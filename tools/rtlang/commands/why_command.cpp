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
  explain::Detail& detail = arguments->options.detail;
  app.add_flag("--all", detail.all, "shows the whole ray tree, not just the path that carries most of the light");
  app.add_option("--depth", detail.depth, "the tree down to this depth; deeper rays are summed up")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<int>::max()));
  app.add_option("--least", detail.least,
                 "the tree's rays with at least this weight, 0 to 1; weaker ones are summed up")
      ->type_name("WEIGHT")
      ->check(number_between(0, 1));
  app.add_flag("--json", arguments->options.as_json, "prints JSON");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("The numbers are the renderer's own; with --all each hit has its derivation. Colours are linear.");
  return [arguments] {
    return answer_question(*arguments, [&](live::Document& document, const explain::Question& question) {
      return document.why(question, arguments->options);
    });
  };
}

} // namespace rt::tools
