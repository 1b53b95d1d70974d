#include "tools/repl/repl.hpp"
#include "tools/rtlang/commands.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <memory>

namespace rt::tools {

Action declare_repl(CLI::App& app) {
  auto options = std::make_shared<ReplOptions>();
  app.add_option("SCENE", options->scene, "a scene file to start from");
  app.add_flag("--keep-going", options->keeps_going, "continues after an error if the input is not a terminal");
  app.footer("If the input is not a terminal it is read as a script: no prompt, and the first error ends the session.");
  return [options] { return run_repl(*options); };
}

} // namespace rt::tools
