#include "tools/rtlang/question_arguments.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace rt::tools {

std::shared_ptr<explain::QuestionText> add_question_arguments(CLI::App& app) {
  auto a = std::make_shared<explain::QuestionText>();
  app.add_option("--pixel", a->pixel, "the centre of a pixel; 0,0 is top left")->type_name("X,Y");
  app.add_option("--sample", a->sample, "with --pixel: one of its samples, from 0")->type_name("N");
  app.add_option("--at", a->at, "a point of the picture; pixel 0,0 has its centre at 0.5,0.5")->type_name("X,Y");
  app.add_option("--ray", a->ray, "any ray: where it starts, and its direction as given")
      ->expected(2)
      ->type_name("OX,OY,OZ DX,DY,DZ");
  return a;
}

} // namespace rt::tools
