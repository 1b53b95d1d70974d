#pragma once

#include "lang/load.hpp"
#include "tools/import/import.hpp"
#include "tools/live/document.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rt::tools {

/// The arguments of every subcommand that reads a scene: SCENE, -D, --include-root, the limits, --lenient, --quiet and
/// --diagnostics.
struct SceneArguments {
  std::string path; ///< "-" is standard input; another program's scene by its extension
  std::vector<std::string> defines;
  lang::LoadOptions options; ///< without the defines
  import::Options import;    ///< for another program's scene
  bool is_quiet = false;
  bool json_diagnostics = false;
};

std::shared_ptr<SceneArguments> add_scene_arguments(CLI::App& app);

/// Only SCENE and --diagnostics, for subcommands that only read the text.
std::shared_ptr<SceneArguments> add_text_arguments(CLI::App& app);

/// The name under which diagnostics show the scene, and its text. Throws as `load` does.
std::string shown_name(const SceneArguments& arguments);
std::string read_text(const SceneArguments& arguments);

/// Writes diagnostics to standard error: notes on a line each unless quiet, all of them as one array for JSON.
void show(const std::vector<lang::Diagnostic>& diagnostics, const lang::SourceMap& sources,
          const SceneArguments& arguments);

/// Text to scene description, with the diagnostics on standard error. If one of them is an error, `scene` is empty and
/// the exit code is exit_scene_is_wrong. Throws Interrupted if a signal asked to stop, UsageError for a define without
/// `=`, std::system_error for a scene that cannot be read.
lang::Loaded load(const SceneArguments& arguments);

/// Reports on standard error what is interpreted differently than in another program's scene. `load` does it by itself.
void show_import_warnings(const SceneArguments& arguments);

/// The same as `load`, with nothing on standard error.
lang::Loaded load_in_silence(const SceneArguments& arguments);
/// Writes what the scene printed to standard error, each line with its place; nothing if diagnostics are JSON: `load`
/// includes it in those.
void show_printed(const lang::Loaded& loaded, const SceneArguments& arguments);

/// Adds --size, --mode, --samples, --noise, --seed and --max-depth, validated like the scene's fields.
std::shared_ptr<live::PictureSettings> add_picture_arguments(CLI::App& app);

/// The scene as a document with these settings, with the diagnostics on standard error. Throws like `load`.
live::Document load_document(const SceneArguments& arguments, const live::PictureSettings& settings);

/// A CLI11 validator for an option that takes one of these words.
std::function<std::string(const std::string&)> one_of(std::vector<std::string> words);
/// The same for an integer from `least` to `greatest`.
std::function<std::string(const std::string&)> whole_number(int least, int greatest);
/// And for any number.
std::function<std::string(const std::string&)> number_between(double least, double greatest);

} // namespace rt::tools
