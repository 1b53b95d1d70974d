#pragma once

#include "tools/explain/question.hpp"
#include "tools/rtlang/scene_arguments.hpp"

#include <functional>
#include <memory>
#include <string>

namespace rt::tools {

/// The arguments of subcommands that ask about one ray.
struct QuestionArguments {
  std::shared_ptr<explain::QuestionText> question;
  std::shared_ptr<live::PictureSettings> picture;
  std::shared_ptr<SceneArguments> scene;
};

/// Adds --pixel, --sample, --at and --ray.
std::shared_ptr<explain::QuestionText> add_question_arguments(CLI::App& app);

/// Loads the scene and prints the result of `answer`; returns the exit code.
int answer_question(const QuestionArguments& arguments,
                    const std::function<std::string(live::Document&, const explain::Question&)>& answer);

} // namespace rt::tools
