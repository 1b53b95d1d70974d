#include "renderer/image/file.hpp"
#include "renderer/image/image.hpp"
#include "tools/inspect/object_ids.hpp"
#include "tools/inspect/scene_hash.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/options.hpp"
#include "tools/repl/shell.hpp"
#include "tools/terminal/progress_bar.hpp"
#include "tools/terminal/swatch.hpp"
#include "tools/terminal/terminal.hpp"
#include "tools/terminal/version.hpp"

#include <fmt/format.h>

#include <chrono>
#include <system_error>

namespace rt::tools {
namespace {

constexpr int spare_rows = 2; // for the prompt, and the command above the picture

bool show(Shell& shell, std::string_view) {
  const scene::Scene& scene = shell.session().scene();
  const PictureExtent extent = shell.printer().fit(scene.size, terminal_size(), spare_rows);
  const InterruptScope interrupt;
  RenderOptions options;
  options.stop = &interrupt.stop();
  const Rendered rendered = shell.scene().render({.size = scene::Resolution{extent.width, extent.height}}, options);
  if (!rendered.is_complete) return shell.fail("stopped");
  shell.report_assumptions();
  shell.print(shell.printer().print(rendered.film, extent));
  return true;
}

struct RenderCommand {
  std::string path;
  live::PictureSettings settings;
  std::string problem;
};

RenderCommand parse_render(std::string_view arguments) {
  RenderCommand command;
  std::vector<std::string> words = words_of(arguments);
  command.problem = take_options(words, picture_options(command.settings));
  if (!command.problem.empty()) return command;
  if (words.empty()) return {{}, {}, "as in `:render picture.png --size 1600x1200`"};
  if (words.size() > 1) return {{}, {}, fmt::format("one file at a time: what is `{}`?", words[1])};
  command.path = words[0];
  if (command.path.find('.', command.path.rfind('/') + 1) == std::string::npos) command.path += ".png";
  return command;
}

void write(const std::string& path, const Film& film, ImageFormat format, const scene::Scene& scene) {
  const bool is_exr = format == ImageFormat::exr;
  const EncodeOptions options{8,
                              {{is_exr ? "software" : "Software", fmt::format("rtlang {}", version_number())},
                               {is_exr ? "sceneHash" : "Scene-Hash", scene_hash(scene)}},
                              [ids = ObjectIds(scene)](std::uint32_t id) { return ids.name(id); }};
  replace_file(path, encode(film, format, options));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool render(Shell& shell, std::string_view arguments) {
  const RenderCommand command = parse_render(arguments);
  if (!command.problem.empty()) return shell.fail(command.problem);
  const auto format = format_of(command.path);
  if (!format) return shell.fail(fmt::format("`{}` does not end in .png, .exr, .ppm or .pfm", command.path));
  try {
    require_writable(command.path);
    Rendered rendered;
    const InterruptScope interrupt;
    live::Document& document = shell.scene().document(command.settings);
    if (!document.has_scene()) return shell.fail("stopped; nothing was written");
    const auto start = std::chrono::steady_clock::now();
    {
      ProgressBar bar;
      RenderOptions options;
      options.layers = *format == ImageFormat::exr;
      options.stop = &interrupt.stop();
      if (shell.options().moves_cursor) options.on_progress = [&bar](const Progress& p) { bar.show(p); };
      rendered = document.render(options);
    }
    const double seconds = seconds_since(start);
    shell.report_assumptions();
    if (!rendered.is_complete) return shell.fail("stopped; nothing was written");
    write(command.path, rendered.film, *format, document.scene());
    shell.print(
        dim(fmt::format("{}: {}x{} in {:.2f} s", command.path, rendered.film.width, rendered.film.height, seconds),
            shell.output().uses_color) +
        "\n");
  } catch (const std::system_error& error) {
    return shell.fail(error.what());
  } catch (const live::SettingsError& error) {
    return shell.fail(error.what());
  }
  return true;
}

bool set_auto(Shell& shell, std::string_view arguments) {
  if (arguments != "on" && arguments != "off" && !arguments.empty()) return shell.fail("`:auto on` or `:auto off`");
  if (!shell.options().moves_cursor) return shell.fail(":auto needs a terminal that can move its cursor");
  if (!arguments.empty()) shell.set_previews(arguments == "on");
  shell.print(shell.shows_previews() ? "previews are on\n" : "previews are off\n");
  return true;
}

} // namespace

std::span<const ShellCommand> picture_commands() {
  static constexpr ShellCommand table[] = {
      {"show", "", "shows the picture in the terminal", ArgumentKind::none, show},
      {"render", "FILE", "renders to a file; --size WxH, --mode path, --samples N", ArgumentKind::file, render},
      {"auto", "on|off", "turns previews after each change on or off", ArgumentKind::none, set_auto},
  };
  return table;
}

} // namespace rt::tools
