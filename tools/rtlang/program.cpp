#include "tools/rtlang/program.hpp"

#include "lang/suggest.hpp"
#include "tools/rtlang/console.hpp"
#include "tools/rtlang/exit_code.hpp"
#include "tools/rtlang/help.hpp"
#include "tools/rtlang/interrupt.hpp"

#include <algorithm>
#include <filesystem>
#include <new>
#include <system_error>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace rt::tools {
namespace {

int usage_error(std::string_view message, std::string_view help_of) {
  print_error(fmt::format("rtlang: {}\n`rtlang {}--help` tells what can be said.\n", message, help_of));
  return exit_usage;
}

/// CLI11 takes an option's value for optional only when it is joined to it.
void join_optional_values(std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] != "--stats" || (arguments[i + 1] != "json" && arguments[i + 1] != "text")) continue;
    arguments[i] += '=' + arguments[i + 1];
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
}

/// For a word that is neither a subcommand nor a file, perhaps with the subcommand that was meant.
std::string advice(const std::vector<std::string>& arguments) {
  if (arguments.size() < 2 || arguments[0].starts_with('-') || std::filesystem::exists(arguments[0])) return "";
  std::vector<std::string_view> names;
  for (const Subcommand& subcommand : subcommands()) names.push_back(subcommand.name);
  const auto nearest = lang::nearest(arguments[0], names);
  return nearest ? fmt::format(" (did you mean the command `{}`?)", *nearest) : "";
}

int run_subcommand(const Subcommand& subcommand, std::vector<std::string> arguments, const std::string& name_given) {
  CLI::App app;
  app.set_help_flag();
  bool wants_help = false;
  const Action action = subcommand.declare(app);
  app.add_flag("-h,--help", wants_help, "print this help");
  const std::string hint = advice(arguments);
  join_optional_values(arguments);
  if (std::find(arguments.begin(), arguments.end(), "--help") != arguments.end() ||
      std::find(arguments.begin(), arguments.end(), "-h") != arguments.end()) {
    print(help(subcommand, app));
    return exit_fine;
  }
  try {
    std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
    app.parse(std::move(arguments));
    return action();
  } catch (const CLI::ParseError& error) {
    return usage_error(error.what() + hint, name_given);
  } catch (const UsageError& error) {
    return usage_error(error.what(), name_given);
  }
}

int dispatch(std::vector<std::string> arguments) {
  if (arguments.empty()) {
    print_error(help());
    return exit_usage;
  }
  const std::string first = arguments.front();
  if (arguments.size() == 1 && (first == "--help" || first == "-h" || first == "help")) {
    print(help());
    return exit_fine;
  }
  if (arguments.size() == 1 && first == "--version") {
    print(version());
    return exit_fine;
  }
  if (const Subcommand* subcommand = find_subcommand(first)) {
    arguments.erase(arguments.begin());
    return run_subcommand(*subcommand, std::move(arguments), first + ' ');
  }
  return run_subcommand(subcommands().front(), std::move(arguments), "");
}

} // namespace

int run(std::vector<std::string> arguments) {
  listen_to_signals();
  try {
    return dispatch(std::move(arguments));
  } catch (const Interrupted&) {
    return exit_signal_base + stop_signal();
  } catch (const std::bad_alloc&) {
    print_error("rtlang: there is not enough memory\n");
  } catch (const std::system_error& error) {
    // Whoever read our output has enough: `rtlang ast scene.rtl | head`.
    if (error.code() == std::errc::broken_pipe) return exit_broken_pipe;
    print_error(fmt::format("rtlang: {}\n", error.what()));
  } catch (const std::exception& error) {
    print_error(fmt::format("rtlang: {}\n", error.what()));
  }
  return exit_environment;
}

} // namespace rt::tools
