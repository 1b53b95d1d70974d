#include "renderer/image/file.hpp"
#include "renderer/image/image.hpp"
#include "tools/preview/window.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace rt::tools {
namespace {

struct ViewArguments {
  std::shared_ptr<SceneArguments> scene;
  std::shared_ptr<live::PictureSettings> picture;
};

/// A scene that can no longer be read is no reason to close the window.
std::unique_ptr<live::Document> load_again(const ViewArguments& arguments) {
  try {
    return std::make_unique<live::Document>(load_document(*arguments.scene, *arguments.picture));
  } catch (const std::system_error& error) {
    print_error(fmt::format("rtlang: {}\n", error.what()));
    return std::make_unique<live::Document>(lang::Loaded{}, shown_name(*arguments.scene));
  }
}

int view(const ViewArguments& arguments) {
  auto document = std::make_unique<live::Document>(load_document(*arguments.scene, *arguments.picture));
  if (!document->has_scene()) return exit_scene_is_wrong;
  const std::string picture = std::filesystem::path(shown_name(*arguments.scene)).stem().string() + ".png";
  preview::WindowHost host;
  host.name = shown_name(*arguments.scene);
  host.load = [&] { return load_again(arguments); };
  host.tell = [](const std::string& text) { print(text); };
  host.save = [&](const Film& film) {
    replace_file(picture, encode(film, ImageFormat::png, {8, {}}));
    return picture;
  };
  host.stop = &stop_flag();
  try {
    preview::show_window(std::move(document), host);
  } catch (const preview::NoWindow& error) {
    print_error(fmt::format("rtlang: {}\n", error.what()));
    return exit_environment;
  }
  throw_if_stopped();
  return exit_fine;
}

} // namespace

Action declare_view(CLI::App& app) {
  auto arguments = std::make_shared<ViewArguments>();
  arguments->picture = add_picture_arguments(app);
  arguments->scene = add_scene_arguments(app);
  app.footer("The file is reloaded whenever it is saved. Keys:\n" + std::string(preview::window_help()));
  return [arguments] { return view(*arguments); };
}

} // namespace rt::tools
