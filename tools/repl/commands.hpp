#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools {

class Shell;

/// The kind of a command's argument, for completion.
enum class ArgumentKind : std::uint8_t { none, file, thing, property, word, statement, command };

/// One command of the session. A new one is a row of a table.
struct ShellCommand {
  std::string_view name; ///< without the colon
  std::string_view arguments;
  std::string_view summary; ///< one line
  ArgumentKind argument = ArgumentKind::none;
  /// False if it failed, which it has reported.
  bool (*run)(Shell& shell, std::string_view arguments) = nullptr;
};

/// All of this program's commands, in the order of :help.
std::vector<ShellCommand> shell_commands();

/// The command that a word (without the colon) means: its name, or an unambiguous prefix. Otherwise `problem` says what
/// is wrong with it.
struct CommandChoice {
  const ShellCommand* command = nullptr;
  std::string problem;
};
CommandChoice choose_command(std::string_view word, std::span<const ShellCommand> commands);

/// Input that begins with a colon, parsed.
struct CommandLine {
  std::string_view word;      ///< without the colon
  std::string_view arguments; ///< without surrounding spaces
};
CommandLine split_command(std::string_view input);
bool is_command(std::string_view input);

std::string_view trimmed(std::string_view text);
/// The words of a text; a word in double quotes may contain spaces.
std::vector<std::string> words_of(std::string_view text);

// The tables, by topic.
std::span<const ShellCommand> document_commands();
std::span<const ShellCommand> picture_commands();
std::span<const ShellCommand> question_commands();
std::span<const ShellCommand> general_commands();

} // namespace rt::tools
