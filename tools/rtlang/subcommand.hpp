#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace rt::tools {

/// Runs a subcommand after its command line has been parsed; the result is the exit code.
using Action = std::function<int()>;

/// A subcommand: one file, and one line in the table of `subcommands`.
struct Subcommand {
  std::string_view name;
  std::string_view arguments; ///< for the usage line: "SCENE [OPTIONS]"
  std::string_view summary;   ///< one line
  /// Declares the options. Their destination lives as long as the action (a std::shared_ptr that it owns).
  Action (*declare)(CLI::App& app);
};

/// All of them, in the order of --help. The first one runs if the command line names none.
std::span<const Subcommand> subcommands();
const Subcommand* find_subcommand(std::string_view name);

} // namespace rt::tools
