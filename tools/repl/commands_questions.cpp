#include "lang/ide/reference.hpp"
#include "lang/text/suggest.hpp"
#include "lang/values/css_colors.hpp"
#include "renderer/image/file.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/shell.hpp"
#include "tools/rtlang/program.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/swatch.hpp"
#include "tools/terminal/terminal.hpp"
#include "tools/terminal/wrap.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace rt::tools {
namespace {

namespace fs = std::filesystem;

// The document as a file, for as long as a subcommand of the program looks at it.
class DocumentFile {
public:
  explicit DocumentFile(const lang::Session& session) {
    std::string pattern = (fs::temp_directory_path() / "rtlang-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::system_error(errno, std::generic_category(), pattern);
    folder_ = pattern;
    replace_file(path(), session.formatted());
  }
  ~DocumentFile() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  DocumentFile(const DocumentFile&) = delete;
  DocumentFile& operator=(const DocumentFile&) = delete;
  std::string path() const { return (folder_ / "session.rtl").string(); }

private:
  fs::path folder_;
};

// Asks what the command line's subcommand of that name answers.
bool ask(Shell& shell, const std::string& subcommand, const std::vector<std::string>& arguments) {
  try {
    const DocumentFile document(shell.session());
    std::vector<std::string> words{subcommand,    document.path(),         "--quiet", "--shown-as", "session",
                                   "--seen-from", shell.session().folder()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const InterruptScope interrupt;
    const int result = run_for_session(std::move(words));
    if (interrupt.stop()) return shell.fail("stopped");
    return result == exit_fine;
  } catch (const std::system_error& error) {
    return shell.fail(error.what());
  }
}

// X Y or X,Y, or the options that the subcommand takes.
bool ask_about_pixel(Shell& shell, const std::string& subcommand, std::string_view arguments) {
  std::vector<std::string> words = words_of(arguments);
  if (words.empty()) return shell.fail(fmt::format("as in `:{} 400 300`, a pixel from the top left", subcommand));
  const auto is_option = [&words](std::size_t i) { return i >= words.size() || words[i].starts_with('-'); };
  if (!is_option(0)) {
    if (!is_option(1)) {
      words[0] += (words[0].ends_with(',') ? "" : ",") + words[1];
      words.erase(words.begin() + 1);
    }
    words.insert(words.begin(), "--pixel");
  }
  return ask(shell, subcommand, words);
}

bool probe(Shell& shell, std::string_view arguments) {
  return ask_about_pixel(shell, "probe", arguments);
}
bool why(Shell& shell, std::string_view arguments) {
  return ask_about_pixel(shell, "why", arguments);
}
bool lint(Shell& shell, std::string_view arguments) {
  return ask(shell, "lint", words_of(arguments));
}
bool check(Shell& shell, std::string_view arguments) {
  return ask(shell, "check", words_of(arguments));
}

bool export_scene(Shell& shell, std::string_view arguments) {
  std::vector<std::string> words = words_of(arguments);
  if (words.size() < 2 || words[0] != "pov") return shell.fail("as in `:export pov scene.pov`");
  words[0] = "-o";
  if (!ask(shell, "export", words)) return false;
  shell.print(dim(fmt::format("written to {}", words[1]), shell.output().uses_color) + "\n");
  return true;
}

std::string describe_property(std::string_view name) {
  std::string text;
  for (const lang::ReferenceEntry& entry : lang::reference()) {
    for (const auto* properties : {&entry.properties, &entry.common_properties}) {
      for (const lang::PropertyEntry& property : *properties) {
        if (property.name != name) continue;
        const std::string otherwise = property.default_text.empty() ? "" : fmt::format(" ({})", property.default_text);
        text += fmt::format("{}.{}: {}{}  {}\n", entry.name, name, property.type, otherwise, property.help);
      }
    }
  }
  return text;
}

// A name of the document, with what it stands for.
std::string describe_own(Shell& shell, std::string_view name) {
  const std::string text = shell.session().text_of(name);
  if (text.empty()) return "";
  const std::vector<std::string> properties = shell.session().properties_of(name);
  if (properties.empty()) return text + "\n";
  return fmt::format("{}\n  takes {}\n", text, fmt::join(properties, ", "));
}

std::string describe_color(const Shell& shell, std::string_view name) {
  const auto rgb = lang::find_css_color(name);
  if (!rgb) return "";
  const std::string sample = shell.output().uses_color ? swatch(lang::from_srgb8(*rgb)) + " " : "";
  return fmt::format("{}{}: the colour #{:06x}\n", sample, name, *rgb);
}

std::string describe_word(Shell& shell, std::string_view word) {
  std::string text = describe_own(shell, word);
  if (const auto entry = lang::find_entry(word)) return text + lang::describe(*entry);
  if (text.empty()) text = describe_property(word);
  if (text.empty()) text = describe_color(shell, word);
  if (text.empty()) text = lang::describe_keyword(word);
  return text;
}

bool doc(Shell& shell, std::string_view arguments) {
  if (arguments.empty()) return shell.fail("as in `:doc sphere`, `:doc radius` or `:doc clamp`");
  if (arguments.front() == ':') return shell.run(fmt::format(":help {}", arguments));
  const std::string text = describe_word(shell, arguments);
  if (!text.empty()) {
    shell.print(shell.options().is_interactive ? wrapped(text, static_cast<std::size_t>(terminal_size().columns))
                                               : text);
    return true;
  }
  std::vector<std::string> names = shell.session().names();
  for (const lang::ReferenceEntry& e : lang::reference()) names.push_back(e.name);
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto nearest = lang::nearest(arguments, views);
  return shell.fail(fmt::format("the language has no `{}`{}", arguments,
                                nearest ? fmt::format("; did you mean `{}`?", *nearest) : ""));
}

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
      {"probe", "X Y", "what is seen in a pixel", ArgumentKind::none, probe},
      {"why", "X Y", "why a pixel has its colour", ArgumentKind::none, why},
      {"lint", "", "what may be a slip", ArgumentKind::none, lint},
      {"check", "", "compares the picture with POV-Ray's", ArgumentKind::none, check},
      {"export", "pov FILE", "the scene for POV-Ray", ArgumentKind::file, export_scene},
      {"doc", "NAME", "explains a thing, a property or a function", ArgumentKind::word, doc},
      {"time", "[INPUT]", "how long the last input took, or runs one and tells", ArgumentKind::statement, time},
  };
  return table;
}

} // namespace rt::tools
