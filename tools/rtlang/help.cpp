#include "tools/rtlang/help.hpp"

#include "tools/terminal/version.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <sstream>

namespace rt::tools {
namespace {

// The column where explanations begin.
constexpr std::size_t option_column = 28;
constexpr std::size_t command_column = 12;

/// Text in lines of up to 80 characters, broken at spaces; all but the first begin with `indent` spaces, and the first
/// is shorter by as many.
std::string wrapped(const std::string& text, std::size_t indent = 0) {
  constexpr std::size_t width = 80;
  std::string result, word;
  std::size_t length = indent; // of the current line
  std::istringstream words(text);
  while (words >> word) {
    const bool is_first = length == indent, fits = is_first || length + 1 + word.size() <= width;
    if (!is_first) result += fits ? " " : '\n' + std::string(indent, ' ');
    length = (fits ? length + (is_first ? 0 : 1) : indent) + word.size();
    result += word;
  }
  return result + '\n';
}

/// Two columns, the right one wrapped over as many lines as it takes.
std::string row(std::string_view left, const std::string& right, std::size_t column) {
  const bool fits = left.size() + 4 <= column;
  return fmt::format("  {}{}{}", left,
                     fits ? std::string(column - 2 - left.size(), ' ') : '\n' + std::string(column, ' '),
                     wrapped(right, column));
}

std::string option_row(const CLI::Option& option) {
  const auto& letters = option.get_snames();
  const auto& words = option.get_lnames();
  std::string names = letters.empty() ? "    " : '-' + letters.front();
  if (!letters.empty() && !words.empty()) names += ", ";
  if (!words.empty()) names += "--" + words.front();
  const std::string value = option.get_type_name(); // CLI11 appends its checks to it, after a colon
  if (!value.empty()) names += ' ' + value.substr(0, value.find(':'));
  return row(names, option.get_description(), option_column);
}

/// The options of a group under a heading; nothing if there are none. Positional ones are in the usage line.
std::string options_of(const CLI::App& app, const std::string& group, const std::string& heading) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() == group && option->nonpositional()) text += option_row(*option);
  return text.empty() ? text : fmt::format("\n{}:\n{}", heading, text);
}

} // namespace

std::string version() {
  return fmt::format("rtlang {}\n", version_number());
}

std::string help(const Subcommand& subcommand, const CLI::App& app) {
  std::string text = fmt::format("rtlang {}: {}\n\nUsage: rtlang {} {}\n", subcommand.name, subcommand.summary,
                                 subcommand.name, subcommand.arguments);
  for (const std::string& group : app.get_groups())
    if (!group.empty()) text += options_of(app, group, group);
  if (!app.get_footer().empty()) text += '\n' + wrapped(app.get_footer());
  return text;
}

std::string help() {
  const Subcommand& first = subcommands().front();
  CLI::App app;
  app.set_help_flag("-h,--help", "prints this help, or a command's");
  const Action unused = first.declare(app);
  std::string text = fmt::format("rtlang {}: a scene language and its ray tracer\n\n"
                                 "Usage: rtlang {}\n"
                                 "       rtlang COMMAND ...\n",
                                 version_number(), first.arguments);
  text += options_of(app, "Options", fmt::format("Options (rtlang {} --help lists all)", first.name));
  text += row("    --version", "prints the version", option_column);
  text += "\nCommands (see rtlang COMMAND --help):\n";
  for (const Subcommand& subcommand : subcommands())
    text += row(subcommand.name, std::string(subcommand.summary), command_column);
  text += "\nExit status: 0 success, 1 error in the scene, 2 usage error, 3 system error\n"
          "(disk, memory), 130 interrupted by Ctrl-C\n";
  return text;
}

} // namespace rt::tools
