#include "renderer/image/file.hpp"
#include "renderer/image/image.hpp"
#include "tools/inspect/scene_hash.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/shell.hpp"
#include "tools/terminal/quantity.hpp"
#include "tools/terminal/swatch.hpp"
#include "tools/terminal/terminal.hpp"
#include "tools/terminal/version.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <system_error>

namespace rt::tools {
namespace {

constexpr int spare_rows = 2; // for the prompt, and the command above the picture

bool show(Shell& shell, std::string_view) {
  const scene::Scene& scene = shell.session().scene();
  const PictureExtent extent = shell.printer().fit(scene.size, terminal_size(), spare_rows);
  const InterruptScope interrupt;
  const Rendered rendered =
      shell.render({scene::Resolution{extent.width, extent.height}, {}, false}, &interrupt.stop());
  if (!rendered.is_complete) return shell.fail("stopped");
  shell.tell_assumptions();
  shell.print(shell.printer().print(rendered.film, extent));
  return true;
}

struct RenderCommand {
  std::string path;
  Shell::PictureSettings settings;
  std::string problem;
};

RenderCommand parse_render(std::string_view arguments) {
  RenderCommand command;
  const std::vector<std::string> words = words_of(arguments);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string value = i + 1 < words.size() ? words[i + 1] : "";
    if (word == "--size") {
      const auto size = parse_numbers(value, 'x', 2);
      if (!size || (*size)[0] < 1 || (*size)[1] < 1)
        command.problem = "--size takes a size such as 800x600";
      else
        command.settings.size = scene::Resolution{(*size)[0], (*size)[1]};
      ++i;
    } else if (word == "--samples") {
      int samples = 0;
      std::from_chars(value.data(), value.data() + value.size(), samples);
      if (!scene::sample_grid(samples))
        command.problem = "--samples takes a square number: 1, 4, 9, 16";
      else
        command.settings.samples = samples;
      ++i;
    } else if (word.starts_with("--"))
      command.problem = fmt::format("there is no option `{}`; only --size and --samples", word);
    else if (command.path.empty())
      command.path = word;
    else
      command.problem = fmt::format("one file at a time: what is `{}`?", word);
  }
  if (command.problem.empty() && command.path.empty()) command.problem = "as in `:render picture.png --size 1600x1200`";
  return command;
}

// A line that is overwritten while the picture is made; it goes when it is done.
class ProgressLine {
public:
  explicit ProgressLine(const Shell& shell) : shell_(shell), is_shown_(shell.options().is_interactive) {}
  ~ProgressLine() {
    if (was_shown_) shell_.print("\r\x1b[K");
  }
  void show(const Progress& progress) {
    if (!is_shown_ || progress.seconds < 0.5) return;
    was_shown_ = true;
    shell_.print(fmt::format("\r\x1b[K{:3.0f} %  {} rays/s", progress.fraction * 100,
                             human(static_cast<double>(progress.rays) / progress.seconds)));
  }

private:
  const Shell& shell_;
  bool is_shown_, was_shown_ = false;
};

bool render(Shell& shell, std::string_view arguments) {
  RenderCommand command = parse_render(arguments);
  if (!command.problem.empty()) return shell.fail(command.problem);
  if (command.path.find('.', command.path.rfind('/') + 1) == std::string::npos) command.path += ".png";
  const auto format = format_of(command.path);
  if (!format) return shell.fail(fmt::format("`{}` does not end in .png, .exr, .ppm or .pfm", command.path));
  command.settings.layers = *format == ImageFormat::exr;
  try {
    require_writable(command.path);
    Rendered rendered;
    std::optional<scene::Scene> scene; // as the saved file would give it: the same bytes
    {
      ProgressLine line(shell);
      const InterruptScope interrupt;
      scene = shell.document_scene();
      if (!scene) return shell.fail("stopped; nothing was written");
      scene->size = command.settings.size.value_or(scene->size);
      scene->samples = command.settings.samples.value_or(scene->samples);
      RenderOptions options;
      options.layers = command.settings.layers;
      options.stop = &interrupt.stop();
      options.on_progress = [&line](const Progress& p) { line.show(p); };
      rendered = rt::render(*scene, options);
    }
    shell.tell_assumptions();
    if (!rendered.is_complete) return shell.fail("stopped; nothing was written");
    const bool is_exr = *format == ImageFormat::exr;
    const EncodeOptions options{8,
                                {{is_exr ? "software" : "Software", fmt::format("rtlang {}", version_number())},
                                 {is_exr ? "sceneHash" : "Scene-Hash", scene_hash(*scene)}}};
    replace_file(command.path, encode(rendered.film, *format, options));
    const RenderStatistics& statistics = rendered.statistics;
    shell.print(dim(fmt::format("{}: {}x{} in {:.2f} s", command.path, rendered.film.width, rendered.film.height,
                                statistics.build_seconds + statistics.trace_seconds),
                    shell.output().uses_color) +
                "\n");
  } catch (const std::system_error& error) {
    return shell.fail(error.what());
  }
  return true;
}

bool set_auto(Shell& shell, std::string_view arguments) {
  if (arguments != "on" && arguments != "off" && !arguments.empty()) return shell.fail("`:auto on` or `:auto off`");
  if (!shell.options().is_interactive) return shell.fail(":auto needs a terminal");
  if (!arguments.empty()) shell.set_previews(arguments == "on");
  shell.print(shell.shows_previews() ? "a preview after each change\n" : "no previews\n");
  return true;
}

} // namespace

std::span<const ShellCommand> picture_commands() {
  static constexpr ShellCommand table[] = {
      {"show", "", "the picture, here in the terminal", ArgumentKind::none, show},
      {"render", "FILE", "the picture as a file; --size WxH, --samples N", ArgumentKind::file, render},
      {"auto", "on|off", "shows a preview after each change, or not", ArgumentKind::none, set_auto},
  };
  return table;
}

} // namespace rt::tools
