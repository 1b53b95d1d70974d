#include "tools/rtlang/program.hpp"

#include "lang/text/suggest.hpp"
#include "tools/explain/question.hpp"
#include "tools/live/picture_settings.hpp"
#include "tools/rtlang/help.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"
#include "tools/terminal/quantity.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <regex>
#include <system_error>

namespace rt::tools {
namespace {

int usage_error(std::string_view message, std::string_view help_of) {
  print_error(fmt::format("rtlang: {}\nSee `rtlang {}--help`.\n", message, help_of));
  return exit_usage;
}

/// CLI11 treats an option's value as optional only if it is joined to it.
void join_optional_values(std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] != "--stats" || (arguments[i + 1] != "json" && arguments[i + 1] != "text")) continue;
    arguments[i] += '=' + arguments[i + 1];
    arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  const std::vector<std::string_view> views(candidates.begin(), candidates.end());
  const auto nearest = lang::nearest(word, views);
  return nearest ? fmt::format(": did you mean `{}`?", *nearest) : "";
}

/// What to say about words that are neither options nor arguments; `first` is the command line's first word.
std::string about_extras(const std::vector<std::string>& extras, const CLI::App& app, const std::string& first) {
  for (const std::string& extra : extras) {
    if (!extra.starts_with('-') || extra == "-") continue;
    const std::string name = extra.substr(0, extra.find('='));
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
      for (const std::string& word : option->get_lnames()) names.push_back("--" + word);
    return fmt::format("unknown option `{}`{}", name, did_you_mean(name, names));
  }
  // The first word may have been meant as a command.
  std::vector<std::string> names;
  for (const Subcommand& subcommand : subcommands()) names.emplace_back(subcommand.name);
  if (find_subcommand(first) == nullptr && !std::filesystem::exists(first)) {
    if (const std::string hint = did_you_mean(first, names); !hint.empty())
      return fmt::format("unknown command `{}`{}", first, hint);
  }
  return fmt::format("unexpected argument `{}`", extras.front());
}

/// CLI11 puts a colon between an option and our checks' message, and has its own wording for a missing value.
std::string as_sentence(const std::string& message) {
  static const std::regex missing("^(\\S+): 1 required (\\S+) missing$"), colon("^(\\S+): (takes|cannot) ");
  return std::regex_replace(std::regex_replace(message, missing, "$1 takes a value: $1 $2"), colon, "$1 $2 ");
}

/// Whether standard input is a pipe or a file.
bool input_is_given() {
  struct stat status {};
  return ::fstat(STDIN_FILENO, &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISREG(status.st_mode));
}

/// What to say if arguments are missing: all of them.
std::string about_missing(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    if (option->get_required() && option->count() == 0) names.push_back(option->get_single_name());
  const bool wants_scene = std::find(names.begin(), names.end(), "SCENE") != names.end();
  const CLI::Option* question = app.get_option_no_throw("--ray");
  if (question != nullptr && question->count() + app.count("--pixel") + app.count("--at") == 0)
    names.push_back("--pixel X,Y");
  const bool is_one = names.size() == 1 && !names.front().ends_with('S'); // SCENE, but FILES
  return fmt::format("{} {} missing{}", fmt::join(names, " and "), is_one ? "is" : "are",
                     wants_scene && input_is_given()
                         ? ": a scene from standard input is called `-`, as in `rtlang - < scene.rtl`"
                         : "");
}

/// `first` is the command line's first word: the subcommand's name, unless it was omitted.
int run_subcommand(const Subcommand& subcommand, std::vector<std::string> arguments, const std::string& first) {
  const std::string name_given = first == subcommand.name ? first + ' ' : "";
  CLI::App app;
  app.set_help_flag("-h,--help", "prints this help");
  const Action action = subcommand.declare(app);
  join_optional_values(arguments);
  try {
    std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
    app.parse(std::move(arguments));
    return action();
  } catch (const CLI::CallForHelp&) {
    print(help(subcommand, app));
    return exit_fine;
  } catch (const CLI::ExtrasError&) {
    return usage_error(about_extras(app.remaining(), app, first), name_given);
  } catch (const CLI::RequiredError&) {
    return usage_error(about_missing(app), name_given);
  } catch (const CLI::ParseError& error) {
    return usage_error(as_sentence(error.what()), name_given);
  } catch (const UsageError& error) {
    return usage_error(error.what(), name_given);
  } catch (const live::SettingsError& error) {
    return usage_error(error.what(), name_given);
  } catch (const explain::QuestionError& error) {
    return usage_error(error.what(), name_given);
  }
}

int dispatch(std::vector<std::string> arguments) {
  if (arguments.empty() && input_is_given())
    return usage_error("what is on standard input? A scene is `rtlang -`, as in `rtlang - -o picture.png < scene.rtl`; "
                       "what would be typed at the prompt is `rtlang repl < FILE`",
                       "");
  if (arguments.empty()) return run_subcommand(*find_subcommand("repl"), {}, "repl ");
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
    return run_subcommand(*subcommand, std::move(arguments), first);
  }
  return run_subcommand(subcommands().front(), std::move(arguments), first);
}

} // namespace

int run(std::vector<std::string> arguments) {
  listen_to_signals();
  try {
    return dispatch(std::move(arguments));
  } catch (const Interrupted&) {
    say_stopped();
    return exit_signal_base + stop_signal();
  } catch (const std::bad_alloc&) {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    print_error(fmt::format("rtlang: out of memory: {}B were in use\n",
                            human(1024 * static_cast<double>(usage.ru_maxrss)))); // in KiB on Linux
  } catch (const std::system_error& error) {
    // It was waiting for a file that is a pipe.
    if (error.code() == std::errc::interrupted && stop_signal() != 0) {
      say_stopped();
      return exit_signal_base + stop_signal();
    }
    // The reader of our output has had enough: `rtlang ast scene.rtl | head`.
    if (error.code() == std::errc::broken_pipe) return exit_broken_pipe;
    print_error(fmt::format("rtlang: {}\n", error.what()));
  } catch (const std::exception& error) {
    print_error(fmt::format("rtlang: {}\n", error.what()));
  }
  return exit_environment;
}

} // namespace rt::tools
