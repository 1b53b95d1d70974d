#include "lang/syntax/parse.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace rt::tools {
namespace {

int run_ast(const SceneArguments& arguments) {
  lang::SourceMap sources;
  const lang::FileId file = sources.add(shown_name(arguments), "", read_text(arguments));
  lang::SymbolTable symbols;
  const lang::Parsed parsed = lang::parse(sources, file, symbols);
  show(parsed.diagnostics, sources, arguments);
  print(lang::dump(parsed.ast, sources, symbols));
  return parsed.diagnostics.empty() ? exit_fine : exit_scene_is_wrong;
}

} // namespace

Action declare_ast(CLI::App& app) {
  auto arguments = add_text_arguments(app);
  app.footer("The tree is printed even if there are syntax errors: they become error nodes, and the exit code is 1.");
  return [arguments] { return run_ast(*arguments); };
}

} // namespace rt::tools
