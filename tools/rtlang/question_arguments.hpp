#pragma once

#include "tools/explain/question.hpp"

#include <memory>

namespace CLI {
class App;
}

namespace rt::tools {

/// Adds --pixel, --sample, --at and --ray.
std::shared_ptr<explain::QuestionText> add_question_arguments(CLI::App& app);

} // namespace rt::tools
