#include "tools/explain/observer.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt::tools {
namespace {

struct TestArguments {
  std::shared_ptr<SceneArguments> scene;
  std::vector<std::string> paths;
  bool is_json = false;
};

using json = nlohmann::ordered_json;

bool is_error(const lang::Diagnostic& diagnostic) {
  return diagnostic.severity == lang::Severity::error;
}

/// Errors and failures; remarks about a valid scene are not the concern of its tests.
void report(const lang::Loaded& loaded, const SceneArguments& arguments) {
  std::vector<lang::Diagnostic> wrong;
  std::copy_if(loaded.diagnostics.begin(), loaded.diagnostics.end(), std::back_inserter(wrong), is_error);
  wrong.insert(wrong.end(), loaded.expectations.failures.begin(), loaded.expectations.failures.end());
  if (!wrong.empty()) show(wrong, loaded.sources, arguments);
}

json to_json(const std::string& path, const lang::Loaded& loaded) {
  const lang::Expectations& e = loaded.expectations;
  std::vector<lang::Diagnostic> errors;
  std::copy_if(loaded.diagnostics.begin(), loaded.diagnostics.end(), std::back_inserter(errors), is_error);
  return {{"scene", path},
          {"passed", e.passed},
          {"failed", e.failed},
          {"failures", json::parse(lang::render_json(e.failures, loaded.sources))},
          {"errors", json::parse(lang::render_json(errors, loaded.sources))}};
}

int run_test(const TestArguments& arguments) {
  std::size_t passed = 0, failed = 0, broken = 0;
  json scenes = json::array();
  SceneArguments one = *arguments.scene;
  one.options.observe = explain::tracing_observer();
  for (const std::string& path : arguments.paths) {
    one.path = path;
    const lang::Loaded loaded = load_in_silence(one);
    show_printed(loaded, one);
    passed += loaded.expectations.passed;
    failed += loaded.expectations.failed;
    if (!loaded.scene) ++broken;
    if (arguments.is_json)
      scenes.push_back(to_json(shown_name(one), loaded));
    else
      report(loaded, one);
  }
  if (arguments.is_json)
    print(json{{"passed", passed}, {"failed", failed}, {"scenes", std::move(scenes)}}.dump(2) + "\n");
  else
    print(fmt::format(
        "{} passed, {} failed{}\n", passed, failed,
        broken == 0 ? "" : fmt::format(", {} in error", broken == 1 ? "1 scene" : fmt::format("{} scenes", broken))));
  return failed == 0 && broken == 0 ? exit_fine : exit_scene_is_wrong;
}

} // namespace

Action declare_test(CLI::App& app) {
  auto arguments = std::make_shared<TestArguments>();
  app.add_flag("--json", arguments->is_json, "prints JSON");
  arguments->scene = add_scene_arguments(app);
  CLI::Option* scene = app.get_option("SCENE");
  app.remove_option(scene);
  app.add_option("SCENES", arguments->paths, "scene files, - for standard input")->required()->group("Arguments");
  app.footer(
      "Checks every `expect` statement. A failure is reported with what was expected, what was found and where;\n"
      "the exit code is 0 if all hold, 1 if one fails or a scene has errors.");
  return [arguments] { return run_test(*arguments); };
}

} // namespace rt::tools
