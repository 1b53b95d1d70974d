#include "tools/rtlang/scene_arguments.hpp"

#include "renderer/image/file.hpp"
#include "tools/rtlang/help.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"
#include "tools/terminal/quantity.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>

namespace rt::tools {
namespace {

/// Reads standard input to its end, unless a signal asks to stop.
std::string read_standard_input() {
  std::string text;
  std::vector<char> block(1 << 16);
  while (true) {
    throw_if_stopped();
    const ssize_t n = ::read(STDIN_FILENO, block.data(), block.size());
    if (n == 0) return text;
    if (n < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "cannot read standard input");
    if (n > 0) text.append(block.data(), static_cast<std::size_t>(n));
  }
}

std::pair<std::string, std::string> split_define(const std::string& define) {
  const std::size_t equals = define.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError(fmt::format("-D takes NAME=VALUE, as in -D width=3, not `{}`", define));
  return {define.substr(0, equals), define.substr(equals + 1)};
}

/// Like lang::load_file, with our own message for a file that cannot be read.
lang::Loaded load_named(const std::string& path, const lang::LoadOptions& options) {
  try {
    return lang::load_file(path, options);
  } catch (const std::system_error& error) {
    throw std::system_error(error.code(), fmt::format("cannot read `{}`", path));
  }
}

/// Another program's scene: as text in our language, with the line numbers of the file.
lang::Loaded load_import(const import::Format& format, const SceneArguments& arguments,
                         const lang::LoadOptions& options) {
  import::Imported imported = format.read(read_text(arguments), shown_name(arguments), arguments.import);
  if (!imported.has_errors()) return lang::load_text(std::move(imported.by_line), shown_name(arguments), ".", options);
  lang::Loaded wrong;
  wrong.diagnostics = std::move(imported.diagnostics);
  wrong.sources = std::move(imported.sources);
  return wrong;
}

/// Adds an option for a limit, as a quantity with powers of `thousand`.
template <class T>
void add_limit(CLI::App& app, const char* name, const char* type, T& limit, std::uint64_t thousand,
               const std::string& text) {
  app.add_option_function<std::string>(
         name,
         [&limit, thousand, name](const std::string& value) {
           const auto quantity = parse_quantity(value, thousand);
           if (!quantity || *quantity > static_cast<std::uint64_t>(std::numeric_limits<T>::max()))
             throw UsageError(fmt::format("{} takes a whole number, as in {}=20M, not `{}`", name, name, value));
           limit = static_cast<T>(*quantity);
         },
         text)
      ->type_name(type)
      ->group(further_options);
}

} // namespace

std::shared_ptr<SceneArguments> add_text_arguments(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments>();
  app.add_option("SCENE", arguments->path, "the scene file, - for standard input")->required()->group("Arguments");
  app.add_option_function<std::string>(
         "--diagnostics",
         [arguments = arguments.get()](const std::string& form) { arguments->json_diagnostics = form == "json"; },
         "format of diagnostics: text or json")
      ->type_name("FORM")
      ->check(one_of({"text", "json"}))
      ->group(further_options);
  return arguments;
}

std::shared_ptr<SceneArguments> add_scene_arguments(CLI::App& app) {
  auto arguments = add_text_arguments(app);
  lang::LoadOptions& options = arguments->options;
  options.stop = &stop_flag();
  app.add_option("-D", arguments->defines, "sets a `param` of the scene (repeatable)")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_flag("-q,--quiet", arguments->is_quiet, "reports only errors and warnings");
  app.add_option("--include-root", options.include_roots, "an additional folder that includes may read from")
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->group(further_options);
  app.add_flag("--lenient", arguments->import.is_lenient, "accepts common extensions of another program's scene format")
      ->group(further_options);
  const lang::Limits defaults;
  add_limit(app, "--max-steps", "N", options.limits.steps, 1000,
            fmt::format("limit on evaluation steps ({})", human(static_cast<double>(defaults.steps))));
  add_limit(app, "--max-recursion", "N", options.limits.recursion, 1000,
            fmt::format("limit on nested calls ({})", defaults.recursion));
  add_limit(app, "--max-objects", "N", options.limits.objects, 1000,
            fmt::format("limit on the number of objects ({})", human(static_cast<double>(defaults.objects))));
  add_limit(app, "--max-memory", "SIZE", options.limits.memory_bytes, 1024,
            fmt::format("limit on memory while loading ({}G)", defaults.memory_bytes >> 30));
  return arguments;
}

std::string shown_name(const SceneArguments& arguments) {
  return arguments.path == "-" ? "<stdin>" : arguments.path;
}

std::string read_text(const SceneArguments& arguments) {
  return arguments.path == "-" ? read_standard_input() : read_file(arguments.path);
}

void show(const std::vector<lang::Diagnostic>& diagnostics, const lang::SourceMap& sources,
          const SceneArguments& arguments) {
  if (arguments.json_diagnostics) return print_error(lang::render_json(diagnostics, sources) + '\n');
  const bool use_color = error_takes_color();
  std::string text;
  for (const lang::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != lang::Severity::note)
      text += lang::render(diagnostic, sources, use_color);
    else if (!arguments.is_quiet)
      text += fmt::format("note: {}\n", diagnostic.message);
  }
  print_error(text);
}

void show_printed(const lang::Loaded& loaded, const SceneArguments& arguments) {
  if (arguments.json_diagnostics) return; // `show` includes them in its array
  std::string text;
  for (const lang::Diagnostic& line : loaded.printed) text += lang::render_line(line, loaded.sources);
  print_error(text);
}

lang::Loaded load_in_silence(const SceneArguments& arguments) {
  lang::LoadOptions options = arguments.options;
  for (const std::string& define : arguments.defines) options.defines.push_back(split_define(define));
  const import::Format* const format = import::format_of(arguments.path);
  lang::Loaded loaded = format ? load_import(*format, arguments, options)
                        : arguments.path == "-"
                            ? lang::load_text(read_text(arguments), shown_name(arguments), ".", options)
                            : load_named(arguments.path, options);
  throw_if_stopped();
  return loaded;
}

void show_import_warnings(const SceneArguments& arguments) {
  const import::Format* const format = import::format_of(arguments.path);
  if (!format) return;
  const import::Imported imported = format->read(read_text(arguments), shown_name(arguments), arguments.import);
  if (!imported.has_errors() && !imported.diagnostics.empty()) show(imported.diagnostics, imported.sources, arguments);
}

lang::Loaded load(const SceneArguments& arguments) {
  show_import_warnings(arguments);
  lang::Loaded loaded = load_in_silence(arguments);
  show_printed(loaded, arguments);
  if (arguments.json_diagnostics)
    loaded.diagnostics.insert(loaded.diagnostics.begin(), loaded.printed.begin(), loaded.printed.end());
  show(loaded.diagnostics, loaded.sources, arguments);
  return loaded;
}

std::shared_ptr<live::PictureSettings> add_picture_arguments(CLI::App& app) {
  auto settings = std::make_shared<live::PictureSettings>();
  const auto add = [&](const std::string& option, const char* field, const char* type, const char* text) {
    return app
        .add_option_function<std::string>(
            option, [settings = settings.get(), field](const std::string& value) { settings->set(field, value); }, text)
        ->type_name(type)
        ->check([field](const std::string& value) { return live::PictureSettings().set(field, value); });
  };
  add("--size", "size", "WxH", "overrides the scene's width and height");
  add("--mode", "mode", "NAME", "rendering mode: whitted, path or occlusion");
  add("--samples", "samples", "N", "samples per pixel; in whitted mode a square number");
  add("--noise", "noise", "N", "not in whitted mode: samples until the noise is below N")->group(further_options);
  add("--seed", "seed", "N", "not in whitted mode: random seed")->group(further_options);
  add("--max-depth", "max_depth", "N", "limit on successive reflections and refractions");
  add("--min-weight", "min_weight", "W",
      "how much untraced weak rays may change a pixel, as a fraction of white; 0 traces all")
      ->group(further_options);
  return settings;
}

live::Document load_document(const SceneArguments& arguments, const live::PictureSettings& settings) {
  return {load(arguments), shown_name(arguments), settings};
}

std::function<std::string(const std::string&)> one_of(std::vector<std::string> words) {
  return [words = std::move(words)](const std::string& word) -> std::string {
    if (std::find(words.begin(), words.end(), word) != words.end()) return "";
    return fmt::format("takes one of {}, not `{}`", fmt::join(words, ", "), word);
  };
}

std::function<std::string(const std::string&)> whole_number(int least, int greatest) {
  return [=](const std::string& word) -> std::string {
    const auto number = live::parse_numbers(word, ',', 1);
    if (number && number->front() >= least && number->front() <= greatest) return "";
    return fmt::format("takes a whole number from {} to {}, not `{}`", least, greatest, word);
  };
}

std::function<std::string(const std::string&)> number_between(double least, double greatest) {
  return [=](const std::string& word) -> std::string {
    const auto given = live::parse_numbers(word, ',', 1);
    if (given && given->front() >= least && given->front() <= greatest) return "";
    return fmt::format("takes a number from {} to {}, not `{}`", least, greatest, word);
  };
}

} // namespace rt::tools
