#include "lang/diagnostics/diagnostic.hpp"
#include "lang/text/suggest.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <cctype>
#include <memory>

namespace rt::tools {
namespace {

int list_codes() {
  std::string text;
  for (const lang::Code& code : lang::all_codes()) text += fmt::format("{}  {}\n", code.code, code.title);
  print(text);
  return exit_fine;
}

int run_explain(std::string name) {
  if (name.empty()) return list_codes();
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (const auto code = lang::find_code(name)) {
    print(lang::explain(*code));
    return exit_fine;
  }
  const std::vector<lang::Code> codes = lang::all_codes();
  std::vector<std::string_view> names;
  for (const lang::Code& code : codes) names.push_back(code.code);
  const auto nearest = lang::nearest(name, names);
  throw UsageError(
      fmt::format("there is no code `{}`{}", name, nearest ? fmt::format(": did you mean {}?", *nearest) : ""));
}

} // namespace

Action declare_explain(CLI::App& app) {
  auto name = std::make_shared<std::string>();
  app.add_option("CODE", *name, "as in error[E0204]")->group("Arguments");
  return [name] { return run_explain(*name); };
}

} // namespace rt::tools
