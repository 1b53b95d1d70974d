#include "tools/lsp/server.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <unistd.h>

#include <memory>

namespace rt::tools {

Action declare_lsp(CLI::App& app) {
  auto options = std::make_shared<lsp::ServerOptions>();
  app.add_option("--include-root", options->include_roots, "an additional folder that includes may read from")
      ->type_name("DIR")
      ->allow_extra_args(false);
  app.footer(
      "Editors start it: it speaks the Language Server Protocol over standard input and output. The exit code is "
      "0 after the client's `shutdown`, else 1.");
  return [options] {
    if (::isatty(STDIN_FILENO) != 0) throw UsageError("`lsp` is started by an editor, not typed into");
    return lsp::run_server(*options);
  };
}

} // namespace rt::tools
