#include "lang/ide/reference.hpp"
#include "lang/text/suggest.hpp"
#include "lang/values/css_colors.hpp"
#include "renderer/image/file.hpp"
#include "tools/explain/lint/lint.hpp"
#include "tools/live/povray.hpp"
#include "tools/repl/commands.hpp"
#include "tools/repl/options.hpp"
#include "tools/repl/shell.hpp"
#include "tools/terminal/progress_bar.hpp"
#include "tools/terminal/swatch.hpp"
#include "tools/terminal/terminal.hpp"
#include "tools/terminal/wrap.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <atomic>
#include <exception>
#include <new>
#include <optional>

namespace rt::tools {
namespace {

// The result of a question.
struct Reply {
  std::string text;
  bool is_fine = true;
};

std::string without_notes(const live::Document& document, bool use_color) {
  std::string text;
  for (const lang::Diagnostic& d : document.diagnostics())
    if (d.severity != lang::Severity::note) text += lang::render(d, document.sources(), use_color);
  return text;
}

// Asks about the document as it would be saved; `ask` may take long, until `stop`. Nothing if there is no answer, which
// has been reported.
template <class Ask>
std::optional<Reply> reply_of(Shell& shell, const live::PictureSettings& settings, const Ask& ask) {
  const InterruptScope interrupt;
  std::string problem;
  try {
    live::Document& document = shell.scene().document(settings);
    if (const std::string text = without_notes(document, shell.output().uses_color); !text.empty())
      shell.output().complain(text);
    if (document.has_scene()) {
      Reply reply = ask(document, interrupt.stop());
      if (!interrupt.stop()) return reply;
    }
  } catch (const std::bad_alloc&) {
    problem = "out of memory";
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (interrupt.stop()) problem = "stopped";
  if (!problem.empty()) shell.fail(problem);
  return std::nullopt;
}

template <class Ask>
bool answer(Shell& shell, const live::PictureSettings& settings, const Ask& ask) {
  const std::optional<Reply> reply = reply_of(shell, settings, ask);
  if (!reply) return false;
  shell.print(reply->text);
  return reply->is_fine;
}

// The options and the question of a command about a pixel: X Y or X,Y, or --at, or --ray.
struct PixelQuestion {
  live::PictureSettings settings;
  explain::QuestionText question;
  std::string problem;
};

PixelQuestion pixel_question(std::string_view command, std::string_view arguments, std::vector<CommandOption> options) {
  PixelQuestion q;
  std::vector<std::string> words = words_of(arguments);
  if (words.empty()) return {{}, {}, fmt::format("as in `:{} 400 300`, a pixel from the top left", command)};
  const std::vector<CommandOption> own{{"pixel", &q.question.pixel},
                                       {"sample", &q.question.sample},
                                       {"at", &q.question.at},
                                       {"ray", &q.question.ray, 2}};
  options.insert(options.end(), own.begin(), own.end());
  const std::vector<CommandOption> picture = picture_options(q.settings);
  options.insert(options.end(), picture.begin(), picture.end());
  q.problem = take_options(words, options);
  if (!q.problem.empty() || words.empty()) return q;
  if (words.size() > 2) q.problem = fmt::format("unexpected argument `{}`", words[2]);
  q.question.pixel = words[0];
  if (words.size() == 2) q.question.pixel += (words[0].ends_with(',') ? "" : ",") + words[1];
  return q;
}

bool probe(Shell& shell, std::string_view arguments) {
  live::ProbeOptions options;
  const PixelQuestion q = pixel_question("probe", arguments, {{"all", &options.all}, {"json", &options.as_json}});
  if (!q.problem.empty()) return shell.fail(q.problem);
  return answer(shell, q.settings, [&](live::Document& document, const std::atomic<bool>&) {
    return Reply{document.probe(explain::parse(q.question), options)};
  });
}

bool why(Shell& shell, std::string_view arguments) {
  live::WhyOptions options;
  explain::Detail& detail = options.detail;
  const PixelQuestion q = pixel_question(
      "why", arguments,
      {{"all", &detail.all}, {"depth", &detail.depth}, {"least", &detail.least}, {"json", &options.as_json}});
  if (!q.problem.empty()) return shell.fail(q.problem);
  return answer(shell, q.settings, [&](live::Document& document, const std::atomic<bool>&) {
    return Reply{document.why(explain::parse(q.question), options)};
  });
}

// Parses all of a command's arguments as options; false after an error, which has been reported.
bool read_options(Shell& shell, std::string_view arguments, std::vector<CommandOption> options,
                  live::PictureSettings& settings) {
  const std::vector<CommandOption> picture = picture_options(settings);
  options.insert(options.end(), picture.begin(), picture.end());
  std::vector<std::string> words = words_of(arguments);
  const std::string problem = take_options(words, options);
  if (!problem.empty()) return shell.fail(problem);
  return words.empty() || shell.fail(fmt::format("unexpected argument `{}`", words.front()));
}

bool lint(Shell& shell, std::string_view arguments) {
  live::PictureSettings settings;
  explain::LintOptions options;
  bool as_json = false, is_strict = false;
  if (!read_options(shell, arguments, {{"allow", &options.allowed}, {"json", &as_json}, {"strict", &is_strict}},
                    settings))
    return false;
  return answer(shell, settings, [&](const live::Document& document, const std::atomic<bool>& stop) {
    explain::require_rules(options.allowed);
    options.stop = &stop;
    const std::vector<lang::Diagnostic> warnings = document.lint(options);
    return Reply{as_json ? lang::render_json(warnings, document.sources()) + '\n'
                         : explain::lint_text(warnings, document.sources(), shell.output().uses_color),
                 !is_strict || warnings.empty()};
  });
}

std::unique_ptr<const live::Check> check_with_progress(const Shell& shell, live::Document& document,
                                                       const std::atomic<bool>& stop) {
  ProgressBar bar;
  live::CheckOptions options;
  options.stop = &stop;
  if (shell.options().moves_cursor) {
    options.on_progress = [&bar](const Progress& progress) { bar.show(progress); };
    options.on_wait = [&bar](double seconds) { bar.show(live::waiting_text(seconds), seconds); };
  }
  return live::check(document, options);
}

bool check(Shell& shell, std::string_view arguments) {
  live::PictureSettings settings;
  std::string page;
  bool as_json = false;
  if (!read_options(shell, arguments, {{"report", &page}, {"json", &as_json}}, settings)) return false;
  return answer(shell, settings, [&](live::Document& document, const std::atomic<bool>& stop) {
    if (!page.empty()) require_writable(page);
    const auto check = check_with_progress(shell, document, stop);
    if (!check) return Reply{};
    if (!page.empty()) replace_file(page, povray::report_html(check->report));
    return Reply{as_json ? povray::report_json(check->report) : povray::report_text(check->report),
                 check->report.holds()};
  });
}

bool export_scene(Shell& shell, std::string_view arguments) {
  live::PictureSettings settings;
  bool has_no_comments = false;
  std::vector<CommandOption> options = picture_options(settings);
  options.push_back({"no-comments", &has_no_comments});
  std::vector<std::string> words = words_of(arguments);
  const std::string problem = take_options(words, options);
  if (!problem.empty()) return shell.fail(problem);
  if (words.size() != 2 || words[0] != "pov") return shell.fail("as in `:export pov scene.pov`");
  return answer(shell, settings, [&](const live::Document& document, const std::atomic<bool>&) {
    const live::PovrayExport exported = live::export_povray(document, !has_no_comments);
    if (!exported.problems.empty()) {
      shell.output().complain(exported.problems);
      return Reply{"", false};
    }
    replace_file(words[1], exported.text);
    return Reply{dim(fmt::format("written to {}", words[1]), shell.output().uses_color) + "\n"};
  });
}

// A name of the document, with what it refers to.
std::string describe_own(Shell& shell, std::string_view name) {
  const std::string text = shell.session().text_of(name);
  if (text.empty()) return "";
  const std::vector<std::string> properties = shell.session().properties_of(name);
  if (properties.empty()) return text + "\n";
  return fmt::format("{}\n  takes {}\n", text, fmt::join(properties, ", "));
}

std::string describe_word(Shell& shell, std::string_view word) {
  const auto color = lang::find_css_color(word);
  const std::string sample = color && shell.output().uses_color ? swatch(lang::from_srgb8(*color)) + " " : "";
  return describe_own(shell, word) + sample + lang::describe_name(word);
}

bool doc(Shell& shell, std::string_view arguments) {
  if (arguments.empty()) return shell.fail("as in `:doc sphere`, `:doc radius` or `:doc clamp`");
  if (arguments.front() == ':') return shell.run(fmt::format(":help {}", arguments));
  const std::string text = describe_word(shell, arguments);
  if (!text.empty()) {
    shell.print(shell.options().is_interactive ? wrapped(text, static_cast<std::size_t>(terminal_size().columns))
                                               : text);
    return true;
  }
  std::vector<std::string> names = shell.session().names();
  for (std::string& name : lang::reference_names()) names.push_back(std::move(name));
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto nearest = lang::nearest(arguments, views);
  return shell.fail(fmt::format("the language has no `{}`{}", arguments,
                                nearest ? fmt::format("; did you mean `{}`?", *nearest) : ""));
}

bool time(Shell& shell, std::string_view arguments) {
  if (!arguments.empty()) {
    const bool is_fine = shell.run(arguments);
    shell.print(fmt::format("{:.1f} ms\n", shell.last_seconds() * 1e3));
    return is_fine;
  }
  const lang::SessionCounters& counters = shell.session().counters();
  shell.print(fmt::format("{:.1f} ms for the last input; {} statements parsed and {} evaluated in this session\n",
                          shell.last_seconds() * 1e3, counters.statements_parsed, counters.statements_evaluated));
  return true;
}

} // namespace

std::span<const ShellCommand> question_commands() {
  static constexpr ShellCommand table[] = {
      {"probe", "X Y", "shows what a pixel sees", ArgumentKind::none, probe},
      {"why", "X Y", "explains a pixel's colour; --all, --depth N, --least WEIGHT", ArgumentKind::none, why},
      {"lint", "", "warns about likely mistakes", ArgumentKind::none, lint},
      {"check", "", "compares the picture with POV-Ray's", ArgumentKind::none, check},
      {"export", "pov FILE", "exports the scene to POV-Ray", ArgumentKind::file, export_scene},
      {"doc", "NAME", "explains a thing, a property or a function", ArgumentKind::word, doc},
      {"time", "[INPUT]", "times the last input, or the given one", ArgumentKind::statement, time},
  };
  return table;
}

} // namespace rt::tools
