#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace rt::tools {

/// What a subcommand does once its command line is read; the result is the exit code.
using Action = std::function<int()>;

/// A subcommand: one file, and one line in the table of `subcommands`.
struct Subcommand {
  std::string_view name;
  std::string_view arguments; ///< for the usage line: "SCENE [OPTIONS]"
  std::string_view summary;   ///< one line
  /// Declares the options. What they are read into lives as long as the action does (a std::shared_ptr that it holds).
  Action (*declare)(CLI::App& app);
};

/// All of them, in the order of --help. The first is what runs when the command line names none.
std::span<const Subcommand> subcommands();
const Subcommand* find_subcommand(std::string_view name);

} // namespace rt::tools
