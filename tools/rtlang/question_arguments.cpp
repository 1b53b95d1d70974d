#include "tools/rtlang/question_arguments.hpp"

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

} // namespace rt::tools
