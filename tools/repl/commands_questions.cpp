#include "tools/repl/commands.hpp"
#include "tools/repl/shell.hpp"

#include <fmt/format.h>

namespace rt::tools {
namespace {

bool time(Shell& shell, std::string_view arguments) {
  if (!arguments.empty()) {
    const bool is_fine = shell.run(arguments);
    shell.print(fmt::format("{:.1f} ms\n", shell.last_seconds() * 1e3));
    return is_fine;
  }
  const lang::SessionCounters& counters = shell.session().counters();
  shell.print(fmt::format("{:.1f} ms for the last input; since the beginning {} statements parsed, {} evaluated\n",
                          shell.last_seconds() * 1e3, counters.statements_parsed, counters.statements_evaluated));
  return true;
}

} // namespace

std::span<const ShellCommand> question_commands() {
  static constexpr ShellCommand table[] = {
      {"time", "[INPUT]", "how long the last input took, or runs one and tells", ArgumentKind::statement, time},
  };
  return table;
}

} // namespace rt::tools
