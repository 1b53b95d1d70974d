#pragma once

#include "tools/rtlang/subcommand.hpp"

#include <string>

namespace rt::tools {

/// Options in this group appear in the help of their subcommand, but not in that of the program.
inline constexpr const char* further_options = "Further options";

/// What `rtlang NAME --help` prints; `app` is what the subcommand declared.
std::string help(const Subcommand& subcommand, const CLI::App& app);
/// What `rtlang --help` prints: one screen.
std::string help();
/// What `rtlang --version` prints.
std::string version();

} // namespace rt::tools
