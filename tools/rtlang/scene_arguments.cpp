#include "tools/rtlang/scene_arguments.hpp"

#include "renderer/image/file.hpp"
#include "tools/rtlang/console.hpp"
#include "tools/rtlang/exit_code.hpp"
#include "tools/rtlang/help.hpp"
#include "tools/rtlang/interrupt.hpp"
#include "tools/rtlang/quantity.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>
#include <system_error>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace rt::tools {
namespace {

/// Standard input to its end, unless a signal asks to stop.
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

/// Adds an option for a limit, as a quantity with powers of `thousand`.
template <class T>
void add_limit(CLI::App& app, const char* name, const char* type, T& limit, std::uint64_t thousand, const std::string& text) {
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

/// "" for one of the words `known`, otherwise what CLI11 is to say.
std::string check_word(const std::string& word, std::initializer_list<std::string_view> known) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return "";
  return fmt::format("`{}` is not one of {}", word, fmt::join(known, ", "));
}

} // namespace

std::shared_ptr<SceneArguments> add_text_arguments(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments>();
  app.add_option("SCENE", arguments->path, "the scene's file, - for standard input")->required()->group("");
  app.add_option_function<std::string>(
         "--diagnostics",
         [arguments = arguments.get()](const std::string& form) { arguments->json_diagnostics = form == "json"; },
         "how mistakes are told: text or json")
      ->type_name("FORM")
      ->check([](const std::string& form) { return check_word(form, {"text", "json"}); });
  return arguments;
}

std::shared_ptr<SceneArguments> add_scene_arguments(CLI::App& app) {
  auto arguments = add_text_arguments(app);
  lang::LoadOptions& options = arguments->options;
  options.stop = &stop_flag();
  app.add_option("-D", arguments->defines, "sets a `param` of the scene; can be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_flag("-q,--quiet", arguments->is_quiet, "only errors and warnings on standard error");
  app.add_option("--include-root", options.include_roots, "a further folder that `include` and `use` may read")
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->group(further_options);
  const lang::Limits defaults;
  add_limit(app, "--max-steps", "N", options.limits.steps, 1000,
            fmt::format("steps that evaluation may take ({})", human(static_cast<double>(defaults.steps))));
  add_limit(app, "--max-recursion", "N", options.limits.recursion, 1000,
            fmt::format("calls within calls ({})", defaults.recursion));
  add_limit(app, "--max-objects", "N", options.limits.objects, 1000,
            fmt::format("objects of the scene ({})", human(static_cast<double>(defaults.objects))));
  add_limit(app, "--max-memory", "SIZE", options.limits.memory_bytes, 1024,
            fmt::format("memory for loading the scene ({}G)", defaults.memory_bytes >> 30));
  return arguments;
}

std::string shown_name(const SceneArguments& arguments) { return arguments.path == "-" ? "<stdin>" : arguments.path; }

std::string read_text(const SceneArguments& arguments) {
  return arguments.path == "-" ? read_standard_input() : read_file(arguments.path);
}

void show(const std::vector<lang::Diagnostic>& diagnostics, const lang::SourceMap& sources, const SceneArguments& arguments) {
  if (arguments.json_diagnostics) return print_error(lang::render_json(diagnostics, sources) + '\n');
  const bool use_color = error_takes_color();
  std::string text;
  for (const lang::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != lang::Severity::note) text += lang::render(diagnostic, sources, use_color);
    else if (!arguments.is_quiet) text += fmt::format("note: {}\n", diagnostic.message);
  }
  print_error(text);
}

lang::Loaded load(const SceneArguments& arguments) {
  lang::LoadOptions options = arguments.options;
  for (const std::string& define : arguments.defines) options.defines.push_back(split_define(define));
  lang::Loaded loaded = arguments.path == "-" ? lang::load_text(read_standard_input(), shown_name(arguments), ".", options)
                                              : lang::load_file(arguments.path, options);
  throw_if_stopped();
  show(loaded.diagnostics, loaded.sources, arguments);
  return loaded;
}

std::shared_ptr<PictureArguments> add_picture_arguments(CLI::App& app) {
  auto arguments = std::make_shared<PictureArguments>();
  app.add_option("--size", arguments->size, "width and height in pixels, in place of the scene's")->type_name("WxH");
  app.add_option("--samples", arguments->samples, "rays for each pixel, a square number")->type_name("N");
  app.add_option("--max-depth", arguments->max_depth, "how often a ray may be mirrored or refracted")->type_name("N");
  return arguments;
}

namespace {

/// Sets a number of the scene through its field, whose constraint it must meet.
void set(scene::Scene& scene, std::string_view field_name, const std::string& option, const std::vector<int>& numbers) {
  const auto table = scene::fields(static_cast<const scene::Scene*>(nullptr));
  const auto field = std::find_if(table.begin(), table.end(), [&](const scene::Field& f) { return f.name == field_name; });
  for (const int number : numbers) {
    if (number < field->constraint.min || number > field->constraint.max)
      throw UsageError(fmt::format("{} takes whole numbers from {:.0f} to {:.0f}, not {}", option, field->constraint.min,
                                   field->constraint.max, number));
  }
  if (field->type == scene::FieldType::resolution) field->set(&scene, scene::Resolution{numbers[0], numbers[1]});
  else field->set(&scene, static_cast<double>(numbers[0]));
}

} // namespace

void apply(const PictureArguments& arguments, scene::Scene& scene) {
  if (!arguments.size.empty()) {
    const auto numbers = parse_numbers(arguments.size, 'x', 2);
    if (!numbers) throw UsageError(fmt::format("--size takes width and height, as in 800x600, not `{}`", arguments.size));
    set(scene, "size", "--size", *numbers);
  }
  if (arguments.samples) set(scene, "samples", "--samples", {*arguments.samples});
  if (arguments.max_depth) set(scene, "max_depth", "--max-depth", {*arguments.max_depth});
  if (const auto problem = check(scene)) throw UsageError(problem->message);
}

} // namespace rt::tools
