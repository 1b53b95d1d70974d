#include "tools/rtlang/help.hpp"

#include <algorithm>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace rt::tools {
namespace {

constexpr std::size_t column = 24; ///< where explanations begin

std::string row(std::string_view left, std::string_view right) {
  // A name that is too long for its column takes a line of its own.
  const std::string gap = left.size() + 3 > column ? '\n' + std::string(column, ' ') : std::string(column - 2 - left.size(), ' ');
  return fmt::format("  {}{}{}\n", left, gap, right);
}

std::string option_row(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
  if (option.get_snames().empty() && !option.get_positional()) names = "    ";
  else if (!option.get_lnames().empty()) names += ", ";
  for (const std::string& name : option.get_lnames()) names += "--" + name;
  if (option.get_positional()) names = option.get_name();
  const std::string value = option.get_type_name();
  if (!value.empty() && !option.get_positional()) names += ' ' + value;
  return row(names, option.get_description());
}

/// The options of a group under a heading; nothing where there are none.
std::string options_of(const CLI::App& app, const std::string& group, const std::string& heading) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() == group) text += option_row(*option);
  return text.empty() ? text : fmt::format("\n{}:\n{}", heading, text);
}

} // namespace

std::string_view version_number() { return RTLANG_VERSION; }

std::string version() { return fmt::format("rtlang {}\n", version_number()); }

std::string help(const Subcommand& subcommand, const CLI::App& app) {
  std::string text = fmt::format("rtlang {}: {}\n\nUsage: rtlang {} {}\n", subcommand.name, subcommand.summary,
                                 subcommand.name, subcommand.arguments);
  for (const std::string& group : app.get_groups()) text += options_of(app, group, group);
  if (!app.get_footer().empty()) text += fmt::format("\n{}\n", app.get_footer());
  return text;
}

std::string help() {
  const Subcommand& first = subcommands().front();
  CLI::App app;
  const Action unused = first.declare(app);
  std::string text = fmt::format("rtlang {}: from a scene's text to its picture\n\n"
                                 "Usage: rtlang {}\n"
                                 "       rtlang COMMAND ...\n",
                                 version_number(), first.arguments);
  text += options_of(app, "Options", fmt::format("Options (rtlang {} --help lists all)", first.name));
  text += row("    --version", "print the program's version");
  text += "\nCommands (rtlang COMMAND --help tells more):\n";
  for (const Subcommand& subcommand : subcommands()) text += row(subcommand.name, subcommand.summary);
  text += "\nExit code: 0 fine, 1 the scene is wrong, 2 the command line is, 3 disk or machine, 130 stopped by Ctrl-C\n";
  return text;
}

} // namespace rt::tools
