#include "tools/repl/repl.hpp"

#include "lang/syntax/parse.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/completion.hpp"
#include "tools/repl/line_editor.hpp"
#include "tools/repl/preview.hpp"
#include "tools/repl/shell.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"
#include "tools/terminal/swatch.hpp"
#include "tools/terminal/terminal.hpp"
#include "tools/terminal/version.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <istream>

namespace rt::tools {
namespace {

bool takes_color() {
  const char* no_color = std::getenv("NO_COLOR");
  return !(no_color && *no_color);
}

// libedit knows characters beyond ASCII only in a locale that has them. Numbers stay as they are in every locale.
void use_utf8() {
  if (!std::setlocale(LC_CTYPE, "") || MB_CUR_MAX == 1) std::setlocale(LC_CTYPE, "C.UTF-8");
}

bool is_complete_input(std::string_view text) {
  return is_command(text) || lang::is_complete(text);
}

std::string banner() {
  return fmt::format("rtlang {}: type a thing to add it, :show to see it, :help for help, Ctrl-D to quit.\n",
                     version_number());
}

std::string offer(const AbandonedSession& session) {
  return fmt::format("A session of {:%Y-%m-%d %H:%M} was not saved ({} {}): :recover brings it back.\n",
                     fmt::localtime(session.time), session.entries.size(),
                     session.entries.size() == 1 ? "input" : "inputs");
}

// The terminal's side of a session.
class Terminal {
public:
  explicit Terminal(const ReplOptions& options)
      : state_(state_folder()), shell_(shell_options(options, state_), {print, print, takes_color()}),
        preview_(shell_.printer()), editor_(hooks(), state_.empty() ? "" : state_ + "/history") {}

  int run(const ReplOptions& options) {
    const QuietTerminal quiet;
    if (shell_.printer().wants_to_ask() && has_sixels(editor_.ask(attributes_query, 'c')))
      shell_.printer().use_sixels();
    print(banner());
    if (shell_.abandoned()) print(offer(*shell_.abandoned()));
    if (!options.scene.empty()) shell_.run(fmt::format(":load \"{}\"", options.scene));
    const std::string prompt = shell_.output().uses_color ? "\x1b[1mrtl>\x1b[0m " : "rtl> ";
    while (!shell_.wants_to_quit()) {
      show_preview();
      const LineEditor::Line line = editor_.read(prompt);
      preview_.cancel();
      if (line.end == LineEditor::End::end_of_input) break;
      if (line.end == LineEditor::End::line) shell_.run(line.text);
    }
    if (shell_.has_unsaved_changes()) print("Not saved; the next session offers to recover it.\n");
    shell_.close();
    return exit_fine;
  }

private:
  static ShellOptions shell_options(const ReplOptions& options, const std::string& state) {
    return {options.load, std::filesystem::current_path().string(), state, true};
  }

  LineEditorHooks hooks() {
    LineEditorHooks hooks;
    hooks.is_complete = is_complete_input;
    hooks.complete = [this](std::string_view text, std::size_t cursor) { return complete(shell_, text, cursor); };
    hooks.on_key = [this] { preview_.cancel(); };
    hooks.wake_fd = preview_.wake_fd();
    hooks.on_wake = [this] { return preview_.take(); };
    return hooks;
  }

  void show_preview() {
    const bool has_changed = shell_.take_change();
    if (!has_changed || !shell_.shows_previews()) return;
    const PictureExtent extent = shell_.printer().fit(shell_.session().scene().size, terminal_size(), 3);
    preview_.start(extent, [this](scene::Resolution size, const std::atomic<bool>& stop) -> std::optional<Film> {
      RenderOptions options;
      options.stop = &stop;
      Rendered rendered = shell_.scene().render({size, 1, {}}, options);
      if (!rendered.is_complete) return std::nullopt;
      return std::move(rendered.film);
    });
  }

  std::string state_;
  Shell shell_;
  PreviewPrinter preview_;
  LineEditor editor_;
};

// Reads standard input line by line, so that a program at its other end is answered as it goes.
class LineInput {
public:
  std::optional<std::string> next() {
    while (true) {
      const std::size_t end = buffer_.find('\n');
      if (end != std::string::npos) {
        std::string line = buffer_.substr(0, end);
        buffer_.erase(0, end + 1);
        if (!line.empty() && line.back() == '\r') line.pop_back();
        return line;
      }
      std::array<char, 1 << 16> block;
      const ssize_t n = ::read(STDIN_FILENO, block.data(), block.size());
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw std::system_error(errno, std::generic_category(), "cannot read standard input");
      if (n == 0) {
        if (buffer_.empty()) return std::nullopt;
        return std::exchange(buffer_, "");
      }
      buffer_.append(block.data(), static_cast<std::size_t>(n));
    }
  }

private:
  std::string buffer_;
};

int run_script(const ReplOptions& options) {
  Shell shell(
      {options.load, std::filesystem::current_path().string(), "", false},
      {[](std::string_view text) { rt::tools::print(text); }, [](std::string_view text) { print_error(text); }, false});
  bool is_fine = options.scene.empty() || shell.run(fmt::format(":load \"{}\"", options.scene));
  LineInput input;
  std::string pending;
  while ((is_fine || options.keeps_going) && !shell.wants_to_quit()) {
    throw_if_stopped();
    const std::optional<std::string> line = input.next();
    if (!line && pending.empty()) break;
    if (line) pending += pending.empty() ? *line : "\n" + *line;
    if (line && !is_complete_input(pending)) continue;
    is_fine = shell.run(std::exchange(pending, "")) && is_fine;
  }
  return is_fine ? exit_fine : exit_scene_is_wrong;
}

} // namespace

int run_repl(const ReplOptions& options) {
  if (!is_interactive()) return run_script(options);
  use_utf8();
  Terminal terminal(options);
  return terminal.run(options);
}

} // namespace rt::tools
