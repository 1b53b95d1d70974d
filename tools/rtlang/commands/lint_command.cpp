#include "lang/check/lint/rules.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace rt::tools {
namespace {

struct LintArguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
  explain::LintOptions options;
  bool is_json = false;
  bool is_strict = false;
  bool lists_rules = false;
};

int list_rules() {
  std::string text;
  for (const lang::LintRule& rule : lang::lint_rules())
    text += fmt::format("{}  {:<17} {}\n", rule.code, rule.name, lang::find_code(rule.code)->title);
  print(text);
  return exit_fine;
}

// A summary: the number of warnings.
std::string conclusion(const std::vector<lang::Diagnostic>& warnings) {
  if (warnings.empty()) return "no warnings\n";
  const bool is_one = warnings.size() == 1;
  return fmt::format("{} warning{}; see `rtlang explain {}`\n", warnings.size(), is_one ? "" : "s",
                     warnings.front().code);
}

int run_lint(LintArguments& arguments) {
  if (arguments.lists_rules) return list_rules();
  explain::require_rules(arguments.options.allowed);
  arguments.scene->options.lint = true;
  show_import_warnings(*arguments.scene);
  lang::Loaded loaded = load_in_silence(*arguments.scene);
  std::erase_if(loaded.diagnostics, [](const lang::Diagnostic& d) { return d.severity != lang::Severity::error; });
  show(loaded.diagnostics, loaded.sources, *arguments.scene);
  const live::Document document(std::move(loaded), shown_name(*arguments.scene), *arguments.picture);
  if (!document.has_scene()) return exit_scene_is_wrong;
  arguments.options.stop = &stop_flag();
  const std::vector<lang::Diagnostic> warnings = document.lint(arguments.options);
  throw_if_stopped();
  if (arguments.is_json)
    print(lang::render_json(warnings, document.sources()) + '\n');
  else
    print(explain::lint_text(warnings, document.sources(), output_takes_color()) +
          (arguments.scene->is_quiet ? "" : conclusion(warnings)));
  return arguments.is_strict && !warnings.empty() ? exit_scene_is_wrong : exit_fine;
}

} // namespace

Action declare_lint(CLI::App& app) {
  auto arguments = std::make_shared<LintArguments>();
  app.add_flag("--strict", arguments->is_strict, "exits with 1 if there are warnings");
  app.add_flag("--json", arguments->is_json, "prints JSON");
  app.add_option("--allow", arguments->options.allowed, "silences a rule (repeatable)")
      ->type_name("RULE")
      ->allow_extra_args(false);
  app.add_option("--depth-share", arguments->options.depth_share,
                 "percentage of pixels that may lose light at max_depth (5)")
      ->type_name("PERCENT")
      ->check(number_between(0, 100));
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.add_flag_callback(
      "--rules",
      [&arguments = *arguments, scene = app.get_option("SCENE")] {
        arguments.lists_rules = true;
        scene->required(false);
      },
      "lists the rules");
  app.footer("A comment `// lint: allow RULE` silences the rule for its line.");
  return [arguments] { return run_lint(*arguments); };
}

} // namespace rt::tools
