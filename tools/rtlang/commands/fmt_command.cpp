#include "lang/format/format.hpp"
#include "renderer/image/file.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/scene_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"
#include "tools/terminal/interrupt.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace rt::tools {
namespace {

struct FmtArguments {
  std::shared_ptr<SceneArguments> scene;
  std::vector<std::string> paths;
  bool only_checks = false;
};

// All files of one run. One that cannot be formatted does not prevent the others from being formatted; the exit code is
// the worst of their results.
class Run {
public:
  explicit Run(const FmtArguments& arguments) : arguments_(arguments), one_(*arguments.scene) {}

  int all() {
    for (const std::string& path : arguments_.paths) {
      throw_if_stopped();
      one_.path = path;
      try {
        one();
      } catch (const std::system_error& error) {
        if (error.code() == std::errc::broken_pipe) throw;
        print_error(fmt::format("rtlang: {}\n", error.what()));
        ends_with(exit_environment);
      }
    }
    if (one_.json_diagnostics || !wrong_.empty()) show(wrong_, sources_, one_);
    return exit_code_;
  }

private:
  void one() {
    const std::string text = read_text(one_);
    const lang::FileId file = sources_.add(shown_name(one_), "", text);
    lang::Formatted formatted = lang::format(sources_, file);
    if (!formatted.diagnostics.empty()) {
      wrong_.insert(wrong_.end(), formatted.diagnostics.begin(), formatted.diagnostics.end());
      return ends_with(exit_scene_is_wrong);
    }
    const bool has_changed = formatted.text != text;
    if (arguments_.only_checks) {
      if (!has_changed) return;
      print(shown_name(one_) + "\n");
      ends_with(exit_scene_is_wrong);
    } else if (one_.path == "-") {
      print(formatted.text);
    } else if (has_changed) {
      replace_file(one_.path, formatted.text);
    }
  }

  void ends_with(int code) { exit_code_ = std::max(exit_code_, code); }

  const FmtArguments& arguments_;
  SceneArguments one_; // with the path of the current file
  lang::SourceMap sources_;
  std::vector<lang::Diagnostic> wrong_;
  int exit_code_ = exit_fine;
};

} // namespace

Action declare_fmt(CLI::App& app) {
  auto arguments = std::make_shared<FmtArguments>();
  app.add_flag("--check", arguments->only_checks, "writes nothing; lists the files that would change");
  arguments->scene = add_text_arguments(app);
  app.remove_option(app.get_option("SCENE"));
  app.add_option("FILES", arguments->paths, "scene files, - for standard input")->required()->group("Arguments");
  app.footer(
      "Each file is replaced by its formatted text, completely or not at all; - formats standard input to standard "
      "output. "
      "Comments and the meaning of the scene are kept. A file with syntax errors is left alone. The exit code is 1 for "
      "such a file, and with --check if any file would change.");
  return [arguments] { return Run(*arguments).all(); };
}

} // namespace rt::tools
