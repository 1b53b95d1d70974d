#pragma once

#include "tools/explain/question.hpp"

#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rt::tools {

/// --pixel, --sample, --at and --ray.
struct QuestionArguments {
  std::string pixel, at;
  int sample = -1;
  std::vector<std::string> ray; ///< origin and direction
};

std::shared_ptr<QuestionArguments> add_question_arguments(CLI::App& app);

/// Throws UsageError for what is not a pixel, a point or a ray.
explain::Question question_of(const QuestionArguments& arguments);

} // namespace rt::tools
