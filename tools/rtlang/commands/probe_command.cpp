#include "tools/explain/probe.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/question_arguments.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <nlohmann/json.hpp>

namespace rt::tools {
namespace {

struct Arguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<PictureArguments> picture;
  std::shared_ptr<QuestionArguments> question;
  bool wants_all = false;
  bool is_json = false;
};

int run_probe(const Arguments& arguments) {
  const explain::Question question = question_of(*arguments.question);
  lang::Loaded loaded = load(*arguments.scene);
  if (!loaded.scene) return exit_scene_is_wrong;
  apply(*arguments.picture, *loaded.scene);
  const RayQuery query(*loaded.scene);
  const explain::NamedRay ray = explain::resolve(question, *loaded.scene, query.camera());
  const std::vector<HitReport> hits = explain::find_hits(query, ray.ray, arguments.wants_all);
  print(arguments.is_json ? explain::probe_json(*loaded.scene, ray, hits).dump(2) + "\n"
                          : explain::probe_text(*loaded.scene, ray, hits, arguments.wants_all));
  return exit_fine;
}

} // namespace

Action declare_probe(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  arguments->question = add_question_arguments(app);
  app.add_flag("--all", arguments->wants_all, "every hit in order, not the nearest only");
  app.add_flag("--json", arguments->is_json, "for machines");
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("t counts lengths of the direction; the distance is Euclidean. A miss is an answer, not an error.");
  return [arguments] { return run_probe(*arguments); };
}

} // namespace rt::tools
