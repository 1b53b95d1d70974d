#include "tools/repl/repl.hpp"
#include "tools/rtlang/commands.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <memory>

namespace rt::tools {

Action declare_repl(CLI::App& app) {
  auto options = std::make_shared<ReplOptions>();
  app.add_option("SCENE", options->scene, "a scene file to begin with");
  app.add_flag("--keep-going", options->keeps_going, "goes on after an error where input is no terminal");
  app.footer("Where input is no terminal it reads a session as a script: no prompt, and the first error ends it.");
  return [options] { return run_repl(*options); };
}

} // namespace rt::tools
