#include "tools/explain/lint/lint.hpp"

#include "lang/check/lint/rules.hpp"
#include "lang/text/suggest.hpp"
#include "lang/text/tokens.hpp"
#include "tools/explain/lint/lint_parts.hpp"
#include "tools/explain/naming.hpp"
#include "tools/explain/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace rt::tools::explain {

lang::Span Findings::span(Line line) const {
  if (line.number == 0 || line.file >= sources_.size()) return {};
  const std::string_view whole = sources_.line(line.file, line.number);
  std::string_view text = whole.substr(0, whole.find("//"));
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  text = text.substr(0, text.find_last_not_of(" \t") + 1);
  const std::uint32_t start = sources_.file(line.file).line_starts[line.number - 1];
  return {line.file, start + static_cast<std::uint32_t>(first), start + static_cast<std::uint32_t>(text.size())};
}

lang::Diagnostic& Findings::warn(const lang::LintRule& rule, Line line, std::string message) {
  lang::Diagnostic& d = found_.emplace_back();
  d.severity = lang::Severity::warning;
  d.code = rule.code;
  d.message = std::move(message);
  d.span = span(line);
  return d;
}

lang::Note Findings::note(Line line, std::string message) const {
  const lang::Span place = span(line);
  if (place.begin == place.end) return {std::nullopt, std::move(message)};
  return {place, std::move(message)};
}

std::string Findings::place(Line line) const {
  return namer_.place({line.file, line.number});
}

std::string Findings::name(const scene::Object& object) const {
  const std::string name = namer_.object(object);
  return name.starts_with('`') ? name : "the " + name;
}

int workers_of(const LintOptions& options) {
  constexpr unsigned most = 64;
  const unsigned wanted =
      options.threads > 0 ? static_cast<unsigned>(options.threads) : std::thread::hardware_concurrency();
  return static_cast<int>(std::clamp(wanted, 1U, most));
}

void for_each_row(const LintOptions& options, int rows, const std::function<void(int row, int worker)>& work) {
  const int workers = workers_of(options);
  std::vector<std::jthread> threads;
  for (int worker = 0; worker < workers; ++worker) {
    threads.emplace_back([&, worker] {
      for (int row = worker; row < rows && !is_stopped(options); row += workers) work(row, worker);
    });
  }
}

std::string Findings::subject(const std::string& name, std::uint64_t count) {
  if (count > 1) return fmt::format("each {} of this line ({} of them)", name, count);
  return name.starts_with('`') ? name : "this " + name;
}

namespace {

/// A scene without things may consist of questions only.
bool has_expectations(const lang::SourceMap& sources) {
  const std::string_view text = sources.file(0).text;
  lang::Token token{};
  for (std::uint32_t at = 0; (token = lang::next_token(text, at)).kind != lang::TokenKind::end; at = token.end)
    if (token.kind == lang::TokenKind::name && lang::text_of(text, token) == "expect") return true;
  return false;
}

/// A scene with a camera, and nothing to look at.
void find_emptiness(const scene::Scene& scene, const lang::SourceMap& sources, Findings& findings) {
  const Line camera = line_of(scene.camera_origin);
  if (camera.number == 0 || has_expectations(sources)) return;
  lang::Diagnostic& d = findings.warn(lang::lint_rule::nothing_in_view, camera, "nothing is in view");
  d.label = "the scene has nothing to look at";
  d.notes.push_back({std::nullopt, "place a thing on a line of its own, as in `sphere {}`"});
}

void find_all(const scene::Scene& scene, const LintOptions& options, Findings& findings) {
  const RayQuery query(scene, options.threads);
  LintContext context{scene, query, options, {}, {}, {}, findings, false, {}};
  context.view = view_of(context);
  context.survey = survey_of(context, survey_rays);
  context.around_eye = solids_around(context, query.camera().ray(scene.size[0] / 2.0, scene.size[1] / 2.0).origin);
  for (const auto rule : {find_small_scales, find_insides, find_empty_view, find_unseen, find_coincidences,
                          find_overlaps, find_dark_lights, find_exposure, find_cut_off_rays}) {
    if (is_stopped(options)) break;
    rule(context);
  }
}

} // namespace

std::vector<lang::Diagnostic> lint(const lang::Loaded& loaded, const LintOptions& options) {
  std::vector<lang::Diagnostic> found = loaded.remarks;
  if (loaded.scene) {
    Findings findings(*loaded.scene, loaded.sources);
    if (loaded.scene->objects.empty())
      find_emptiness(*loaded.scene, loaded.sources, findings);
    else
      find_all(*loaded.scene, options, findings);
    for (lang::Diagnostic& d : findings.take()) found.push_back(std::move(d));
  }
  return lang::without_allowed(std::move(found), loaded.sources, options.allowed);
}

void require_rules(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (lang::find_lint_rule(word)) continue;
    std::vector<std::string_view> names;
    for (const lang::LintRule& rule : lang::lint_rules()) names.push_back(rule.name);
    const auto guess = lang::nearest(word, names);
    throw QuestionError(
        fmt::format("there is no lint rule `{}`{}", word,
                    guess ? fmt::format(": did you mean `{}`?", *guess) : "; `rtlang lint --rules` lists them"));
  }
}

std::string lint_text(const std::vector<lang::Diagnostic>& warnings, const lang::SourceMap& sources, bool use_color) {
  std::string text;
  for (const lang::Diagnostic& d : warnings) text += lang::render(d, sources, use_color) + '\n';
  return text;
}

} // namespace rt::tools::explain
