#include "tools/rtlang/question_arguments.hpp"

#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace rt::tools {

std::shared_ptr<explain::QuestionText> add_question_arguments(CLI::App& app) {
  auto a = std::make_shared<explain::QuestionText>();
  app.add_option("--pixel", a->pixel, "the ray through a pixel's centre; 0,0 is top left")->type_name("X,Y");
  app.add_option("--sample", a->sample, "with --pixel: one of its samples, from 0")->type_name("N");
  app.add_option("--at", a->at, "the ray through a point; pixel 0,0 has its centre at 0.5,0.5")->type_name("X,Y");
  app.add_option("--ray", a->ray, "any ray: its origin and direction")->expected(2)->type_name("OX,OY,OZ DX,DY,DZ");
  return a;
}

int answer_question(const QuestionArguments& arguments,
                    const std::function<std::string(live::Document&, const explain::Question&)>& answer) {
  const explain::Question question = explain::parse(*arguments.question);
  live::Document document = load_document(*arguments.scene, *arguments.picture);
  if (!document.has_scene()) return exit_scene_is_wrong;
  print(answer(document, question));
  return exit_fine;
}

} // namespace rt::tools
