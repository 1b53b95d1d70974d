#include "tools/repl/shell.hpp"

#include "renderer/math/color.hpp"
#include "tools/repl/commands.hpp"
#include "tools/terminal/interrupt.hpp"
#include "tools/terminal/swatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>

namespace rt::tools {
namespace {

using Clock = std::chrono::steady_clock;

lang::LoadOptions stoppable(lang::LoadOptions options) {
  options.stop = &stop_flag();
  return options;
}

// The command that words without a colon look like: `quit`, `load scene.rtl`.
const ShellCommand* meant_command(std::string_view input) {
  input = trimmed(input);
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto end = static_cast<std::size_t>(std::find_if_not(input.begin(), input.end(), is_letter) - input.begin());
  std::string_view word = input.substr(0, end);
  if (input == "?")
    word = "help";
  else if (end < input.size() && (input[end] != ' ' || (!is_letter(input[end + 1]) && input[end + 1] != '/')))
    return nullptr;
  if (word == "exit") word = "quit";
  for (const auto table : {picture_commands(), document_commands(), question_commands(), general_commands()})
    for (const ShellCommand& command : table)
      if (command.name == word) return &command;
  return nullptr;
}

} // namespace

Shell::Shell(const ShellOptions& options, ShellOutput output)
    : options_(options), output_(std::move(output)), session_(options.folder, stoppable(options.load)),
      scene_(session_, stoppable(options.load)), printer_(options.moves_cursor), journal_(options.journal_folder),
      abandoned_(find_abandoned_sessions(options.journal_folder)) {}

bool Shell::fail(std::string_view text) const {
  output_.complain(fmt::format("{}\n", text));
  return false;
}

bool Shell::run(std::string_view input) {
  const Clock::time_point start = Clock::now();
  bool is_fine = true;
  if (is_command(input)) {
    const CommandLine line = split_command(input);
    const std::vector<ShellCommand> commands = shell_commands();
    const CommandChoice choice = choose_command(line.word, commands);
    is_fine = choice.command ? choice.command->run(*this, line.arguments) : fail(choice.problem);
  } else {
    is_fine = run_statements(input);
  }
  last_seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
  remember(input);
  return is_fine;
}

bool Shell::run_statements(std::string_view input) {
  if (trimmed(input).empty()) return true;
  const InterruptScope interrupt;
  const lang::SessionResult result = session_.submit(input);
  if (!result.is_accepted)
    if (const ShellCommand* command = meant_command(input))
      return fail(fmt::format("that is a command, and a command begins with a colon: `:{}` ({})", command->name,
                              command->summary));
  return report(result);
}

// The journal contains the inputs that changed the document, from which it can be restored.
void Shell::remember(std::string_view input) {
  if (session_.version() == journaled_version_) return;
  has_changed_ = true;
  journal_.add(trimmed(input));
  journaled_version_ = session_.version();
}

void Shell::report_assumptions() {
  if (!options_.is_interactive || reported_version_ == session_.version()) return;
  reported_version_ = session_.version();
  for (const lang::Diagnostic& note : session_.assumptions()) print(dim(note.message, output_.uses_color) + "\n");
}

bool Shell::report(const lang::SessionResult& result) {
  std::string problems;
  for (const lang::Diagnostic& line : result.printed) problems += lang::render_line(line, session_.sources());
  if (!result.problem.empty()) problems += result.problem + "\n";
  for (const std::string& line : result.advice) problems += "  " + line + "\n";
  for (const lang::Diagnostic& diagnostic : result.diagnostics)
    problems += lang::render(diagnostic, session_.sources(), output_.uses_color);
  if (!problems.empty()) output_.complain(problems);
  std::string answer;
  for (const lang::PrintedValue& value : result.values) {
    if (value.color && output_.uses_color) answer += swatch(*value.color) + " ";
    answer += value.text + "\n";
  }
  if (options_.is_interactive)
    for (const std::string& change : result.changes) answer += dim(change, output_.uses_color) + "\n";
  if (!answer.empty()) print(answer);
  return result.is_accepted;
}

void Shell::became_saved(const std::string& path) {
  path_ = path;
  saved_version_ = session_.version();
  journal_.clear(fmt::format(":load \"{}\"", std::filesystem::absolute(path).string()));
  journaled_version_ = saved_version_;
  has_changed_ = true;
}

bool Shell::recover(std::size_t number) {
  if (abandoned_.empty()) return fail("there is no session to recover");
  if (number < 1 || number > abandoned_.size())
    return fail(fmt::format("which one? `:recover 1` to `{}`", abandoned_.size()));
  const auto place = abandoned_.begin() + static_cast<std::ptrdiff_t>(number) - 1;
  const AbandonedSession session = std::move(*place);
  abandoned_.erase(place);
  std::error_code error;
  std::filesystem::current_path(session.working_folder, error);
  // The responses to the inputs were read when they were typed.
  const auto print_answers = std::exchange(output_.print, [](std::string_view) {});
  const bool are_fine = std::all_of(session.entries.begin(), session.entries.end(),
                                    [this](const std::string& entry) { return run(entry); });
  output_.print = print_answers;
  if (!are_fine)
    return fail(fmt::format("the session continues from before that input; its journal is kept in {}", session.path));
  std::filesystem::remove(session.path, error);
  print(dim(fmt::format("{} {} restored", session.entries.size(), session.entries.size() == 1 ? "input" : "inputs"),
            output_.uses_color) +
        "\n");
  return true;
}

void Shell::close() {
  if (!has_unsaved_changes()) journal_.clear();
}

} // namespace rt::tools
