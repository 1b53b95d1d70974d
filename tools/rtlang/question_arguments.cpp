#include "tools/rtlang/question_arguments.hpp"

#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <cmath>

namespace rt::tools {

std::shared_ptr<QuestionArguments> add_question_arguments(CLI::App& app) {
  auto a = std::make_shared<QuestionArguments>();
  app.add_option("--pixel", a->pixel, "the centre of a pixel; 0,0 is top left")->type_name("X,Y");
  app.add_option("--sample", a->sample, "with --pixel: one of its samples, from 0")->type_name("N");
  app.add_option("--at", a->at, "a point of the picture; pixel 0,0 has its centre at 0.5,0.5")->type_name("X,Y");
  app.add_option("--ray", a->ray, "any ray: where it starts, and its direction as given")
      ->expected(2)
      ->type_name("OX,OY,OZ DX,DY,DZ");
  return a;
}

explain::Question question_of(const QuestionArguments& a) {
  explain::Question q;
  if (!a.pixel.empty()) {
    const auto xy = explain::numbers_of(a.pixel, 2, "--pixel");
    if (xy[0] != std::trunc(xy[0]) || xy[1] != std::trunc(xy[1]) || std::abs(xy[0]) > 1e9 || std::abs(xy[1]) > 1e9)
      throw UsageError("--pixel takes whole numbers; for a point between pixel centres there is --at");
    q.pixel = {static_cast<int>(xy[0]), static_cast<int>(xy[1])};
  }
  if (a.sample >= 0) q.sample = a.sample;
  if (!a.at.empty()) {
    const auto xy = explain::numbers_of(a.at, 2, "--at");
    q.at = {xy[0], xy[1]};
  }
  if (!a.ray.empty()) {
    const auto o = explain::numbers_of(a.ray[0], 3, "--ray"), d = explain::numbers_of(a.ray[1], 3, "--ray");
    q.ray = Ray{{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
  }
  return q;
}

} // namespace rt::tools
