#include "tools/repl/repl.hpp"

#include "lang/session/session_text.hpp"
#include "lang/syntax/parse.hpp"
#include "lang/text/utf8.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/completion.hpp"
#include "tools/repl/key_reader.hpp"
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
#include <ctime>
#include <filesystem>
#include <istream>

namespace rt::tools {
namespace {

// libedit knows characters beyond ASCII only in a locale that has them. Numbers stay as they are in every locale.
void use_utf8() {
  if (!std::setlocale(LC_CTYPE, "") || MB_CUR_MAX == 1) std::setlocale(LC_CTYPE, "C.UTF-8");
}

bool is_complete_input(std::string_view text) {
  return is_command(text) || lang::is_complete(text);
}

std::string banner() {
  return fmt::format("rtlang {}: type a thing to add it, :show to see it, :help, Ctrl-D to quit.\n", version_number());
}

std::string inputs_text(const AbandonedSession& session) {
  return fmt::format("{} {}", session.entries.size(), session.entries.size() == 1 ? "input" : "inputs");
}

// The sessions that can be recovered, each identified by its last input.
std::string offer(const std::vector<AbandonedSession>& sessions) {
  if (sessions.empty()) return "";
  if (sessions.size() == 1)
    return fmt::format("The session of {:%Y-%m-%d %H:%M} was not saved ({}): :recover restores it.\n",
                       fmt::localtime(sessions[0].time), inputs_text(sessions[0]));
  std::string text = fmt::format("{} sessions were not saved; :recover N restores one:\n", sessions.size());
  for (std::size_t i = 0; i < sessions.size(); ++i)
    text += fmt::format("  {}  {:%Y-%m-%d %H:%M}, {}, the last: {}\n", i + 1, fmt::localtime(sessions[i].time),
                        inputs_text(sessions[i]), lang::shortened(sessions[i].entries.back()));
  return text;
}

ShellOptions shell_options(const ReplOptions& options, const std::string& state, bool moves_cursor) {
  return {options.load, std::filesystem::current_path().string(), state, true, moves_cursor};
}

void greet(Shell& shell, const ReplOptions& options) {
  print(banner());
  print(offer(shell.abandoned()));
  if (!options.scene.empty()) shell.run(fmt::format(":load \"{}\"", options.scene));
}

void take_leave(Shell& shell) {
  if (shell.has_unsaved_changes()) print("Not saved; the next session offers to recover it.\n");
  shell.close();
}

// The terminal side of a session.
class Terminal {
public:
  explicit Terminal(const ReplOptions& options)
      : state_(state_folder()), shell_(shell_options(options, state_, true), {print, print, terminal_takes_color()}),
        preview_(shell_.printer()), editor_(hooks(), state_.empty() ? "" : state_ + "/history") {}

  int run(const ReplOptions& options) {
    const QuietTerminal quiet;
    if (shell_.printer().wants_to_ask() && has_sixels(editor_.ask(attributes_query, 'c')))
      shell_.printer().use_sixels();
    greet(shell_, options);
    const std::string prompt = shell_.output().uses_color ? "\x1b[1mrtl>\x1b[0m " : "rtl> ";
    while (!shell_.wants_to_quit()) {
      show_preview();
      const LineEditor::Line line = editor_.read(prompt);
      preview_.cancel();
      if (line.end == LineEditor::End::end_of_input) break;
      if (line.end == LineEditor::End::line) shell_.run(line.text);
    }
    take_leave(shell_);
    return exit_fine;
  }

private:
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

// A line edited by the terminal itself. Nothing if Ctrl-C discarded it; `is_at_end` if there will be no
// more.
std::optional<std::string> read_plain(KeyReader& keys, bool& is_at_end) {
  std::string line;
  while (true) {
    const Key key = keys.read();
    switch (key.kind) {
    case Key::Kind::character:
      if (key.code == '\n') return line;
      lang::append_utf8(line, key.code);
      break;
    case Key::Kind::interrupt:
      return std::nullopt;
    case Key::Kind::end:
      is_at_end = true;
      return std::nullopt;
    default:
      break;
    }
  }
}

// On a terminal that cannot move its cursor: prompts and answers only.
int run_plain(const ReplOptions& options) {
  Shell shell(shell_options(options, state_folder(), false), {print, print, false});
  KeyReader keys(-1);
  greet(shell, options);
  std::string pending;
  for (bool is_at_end = false; !shell.wants_to_quit();) {
    print(pending.empty() ? "rtl> " : "...> ");
    const std::optional<std::string> line = read_plain(keys, is_at_end);
    if (is_at_end) break;
    if (!line) {
      print("\n");
      pending.clear();
      continue;
    }
    pending += pending.empty() ? *line : "\n" + *line;
    if (is_complete_input(pending)) shell.run(std::exchange(pending, ""));
  }
  take_leave(shell);
  return exit_fine;
}

// Reads standard input line by line, so that a program at the other end gets its answers immediately.
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
      {options.load, std::filesystem::current_path().string(), "", false, false},
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
  switch (console()) {
  case Console::none:
    return run_script(options);
  case Console::plain:
    return run_plain(options);
  case Console::full:
    break;
  }
  use_utf8();
  Terminal terminal(options);
  return terminal.run(options);
}

} // namespace rt::tools
