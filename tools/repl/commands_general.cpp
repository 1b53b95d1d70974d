#include "tools/repl/commands.hpp"
#include "tools/repl/shell.hpp"

#include <fmt/format.h>

#include <charconv>

namespace rt::tools {
namespace {

bool help(Shell& shell, std::string_view arguments) {
  const std::vector<ShellCommand> commands = shell_commands();
  if (!arguments.empty()) {
    if (arguments.front() == ':') arguments.remove_prefix(1);
    const CommandChoice choice = choose_command(arguments, commands);
    if (!choice.command) return shell.fail(choice.problem);
    shell.print(
        fmt::format(":{} {}\n  {}\n", choice.command->name, choice.command->arguments, choice.command->summary));
    return true;
  }
  std::string text =
      "Type a thing to add it to the scene, or an expression to see its value. `.move(x: 1)` changes the last\n"
      "thing; binding a name again updates everything that uses it. Commands, which may be abbreviated:\n";
  for (const ShellCommand& command : commands) {
    const std::string usage = fmt::format(":{} {}", command.name, command.arguments);
    text += fmt::format("  {:<24} {}\n", usage, command.summary);
  }
  text += "Tab completes, the arrow keys recall earlier input, Ctrl-C clears the line or stops rendering.\n";
  shell.print(text);
  return true;
}

bool recover(Shell& shell, std::string_view arguments) {
  if (arguments.empty()) return shell.recover(1);
  std::size_t number = 0;
  std::from_chars(arguments.data(), arguments.data() + arguments.size(), number);
  return shell.recover(number);
}

bool quit(Shell& shell, std::string_view) {
  shell.quit();
  return true;
}

} // namespace

std::span<const ShellCommand> general_commands() {
  static constexpr ShellCommand table[] = {
      {"recover", "[N]", "restores an unsaved session, without N the last", ArgumentKind::none, recover},
      {"help", "[COMMAND]", "lists the commands", ArgumentKind::command, help},
      {"quit", "", "ends the session", ArgumentKind::none, quit},
  };
  return table;
}

} // namespace rt::tools
