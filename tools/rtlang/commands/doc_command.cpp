#include "lang/ide/reference.hpp"
#include "lang/text/suggest.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace rt::tools {
namespace {

struct DocArguments {
  std::string name;
  std::string section;
  bool only_names = false;
};

int list_names() {
  std::string text, section;
  for (const lang::ReferenceEntry& e : lang::reference()) {
    if (e.section != section) text += fmt::format("{}{}:\n", section.empty() ? "" : "\n", e.section);
    section = e.section;
    text += fmt::format("  {:<16} {}\n", e.name, e.help);
  }
  print(text);
  return exit_fine;
}

int list_names_only() {
  std::string text;
  for (const std::string& name : lang::reference_names()) text += name + "\n";
  print(text);
  return exit_fine;
}

int describe(const std::string& name) {
  const std::string text = lang::describe_name(name);
  if (!text.empty()) {
    print(text);
    return exit_fine;
  }
  const std::vector<std::string> owned = lang::reference_names();
  const std::vector<std::string_view> names(owned.begin(), owned.end());
  const auto nearest = lang::nearest(name, names);
  throw UsageError(
      fmt::format("the language has no `{}`{}", name, nearest ? fmt::format(": did you mean `{}`?", *nearest) : ""));
}

int run_doc(const DocArguments& arguments) {
  if (!arguments.section.empty()) {
    if (std::ranges::find(lang::reference_sections(), arguments.section) == lang::reference_sections().end())
      throw UsageError(fmt::format("the reference has no section `{}`", arguments.section));
    print(lang::markdown(arguments.section));
    return exit_fine;
  }
  if (arguments.only_names) return list_names_only();
  return arguments.name.empty() ? list_names() : describe(arguments.name);
}

} // namespace

Action declare_doc(CLI::App& app) {
  auto arguments = std::make_shared<DocArguments>();
  app.add_option("NAME", arguments->name, "a thing, property, function or material")->group("Arguments");
  app.add_option("--markdown", arguments->section, "prints a section of the language reference")->type_name("SECTION");
  app.add_flag("--names", arguments->only_names, "prints every name that can be asked for, one a line");
  return [arguments] { return run_doc(*arguments); };
}

} // namespace rt::tools
