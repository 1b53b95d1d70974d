#pragma once

#include "tools/rtlang/subcommand.hpp"

/// The subcommands' declarations, each in a file of its own (`render_command.cpp`, …).
namespace rt::tools {

Action declare_probe(CLI::App& app);
Action declare_why(CLI::App& app);
Action declare_test(CLI::App& app);
Action declare_render(CLI::App& app);
Action declare_view(CLI::App& app);
Action declare_ast(CLI::App& app);
Action declare_scene(CLI::App& app);
Action declare_doc(CLI::App& app);
Action declare_explain(CLI::App& app);
Action declare_export(CLI::App& app);
Action declare_convert(CLI::App& app);
Action declare_check(CLI::App& app);
Action declare_diff(CLI::App& app);
Action declare_merge(CLI::App& app);
Action declare_lint(CLI::App& app);
Action declare_repl(CLI::App& app);
Action declare_lsp(CLI::App& app);
Action declare_fmt(CLI::App& app);

} // namespace rt::tools
