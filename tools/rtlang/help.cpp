#include "tools/rtlang/help.hpp"

#include <sstream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace rt::tools {
namespace {

constexpr std::size_t column = 28; ///< where explanations begin

/// A line of two columns.
std::string row(std::string_view left, std::string_view right) {
  // A name that is too long for its column takes a line of its own.
  const bool fits = left.size() + 4 <= column;
  return fmt::format("  {}{}{}\n", left, fits ? std::string(column - 2 - left.size(), ' ') : '\n' + std::string(column, ' '), right);
}

std::string option_row(const CLI::Option& option) {
  const auto& letters = option.get_snames();
  const auto& words = option.get_lnames();
  std::string names = letters.empty() ? "    " : '-' + letters.front();
  if (!letters.empty() && !words.empty()) names += ", ";
  if (!words.empty()) names += "--" + words.front();
  const std::string value = option.get_type_name(); // CLI11 adds its checks to it, after a colon
  if (!value.empty()) names += ' ' + value.substr(0, value.find(':'));
  return row(names, option.get_description());
}

/// Text in lines of up to 80 characters, broken at spaces.
std::string wrapped(const std::string& text) {
  constexpr std::size_t width = 80;
  std::string result, word;
  std::size_t length = 0; // of the line
  std::istringstream words(text);
  while (words >> word) {
    const bool fits = length == 0 || length + 1 + word.size() <= width;
    if (length > 0) result += fits ? ' ' : '\n';
    length = fits && length > 0 ? length + 1 + word.size() : word.size();
    result += word;
  }
  return result + '\n';
}

/// The options of a group under a heading; nothing where there are none. Positional ones are in the usage line.
std::string options_of(const CLI::App& app, const std::string& group, const std::string& heading) {
  std::string text;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() == group && option->nonpositional()) text += option_row(*option);
  return text.empty() ? text : fmt::format("\n{}:\n{}", heading, text);
}

} // namespace

std::string_view version_number() { return RTLANG_VERSION; }

std::string version() { return fmt::format("rtlang {}\n", version_number()); }

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
  app.set_help_flag("-h,--help", "prints this, or a command's own help");
  const Action unused = first.declare(app);
  std::string text = fmt::format("rtlang {}: from a scene's text to its picture\n\n"
                                 "Usage: rtlang {}\n"
                                 "       rtlang COMMAND ...\n",
                                 version_number(), first.arguments);
  text += options_of(app, "Options", fmt::format("Options (rtlang {} --help lists all)", first.name));
  text += row("    --version", "prints the program's version");
  text += "\nCommands (rtlang COMMAND --help tells more):\n";
  for (const Subcommand& subcommand : subcommands()) text += row(subcommand.name, subcommand.summary);
  text += "\nExit code: 0 fine, 1 the scene is wrong, 2 the command line is wrong,\n"
          "3 the machine fails (disk, memory), 130 stopped by Ctrl-C\n";
  return text;
}

} // namespace rt::tools
