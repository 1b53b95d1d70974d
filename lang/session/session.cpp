#include "lang/session/session.hpp"

#include "lang/format/format.hpp"
#include "lang/session/session_state.hpp"
#include "lang/session/session_submission.hpp"
#include "lang/session/session_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace rt::lang {

namespace {

std::string join_lines(const Document& document) {
  std::string text;
  for (const StatementRef& statement : document) text += statement->text + "\n";
  return text;
}

} // namespace

Session::Session(std::string folder, LoadOptions options)
    : state_(std::make_unique<State>(std::move(folder), std::move(options))) {
  state_->scene.show(state_->document());
}

Session::~Session() = default;

SessionResult Session::submit(std::string_view text) {
  SessionCore& core = state_->core;
  core.report = Report();
  SessionChange change(core, state_->document());
  Submission submission(core, change, state_->documents[state_->current].last_id);
  submission.run(text);
  if (core.report.has_errors()) return state_->failed();
  return state_->finish(change, shortened(text), submission.last_id());
}

SessionResult Session::load(const std::string& path) {
  SessionCore& core = state_->core;
  const FileSystem& disk = *core.options.files;
  std::string text = disk.read(path);
  const std::filesystem::path whole = disk.canonical(path);
  core.report = Report();
  core.files.set_folder(whole.parent_path());
  SessionChange change(core, {});
  const TextOrigin origin{path, whole.string(), 1};
  std::uint64_t last_id = 0;
  for (const SessionChange::Draft& draft : change.parse_file(std::move(text), origin)) {
    change.append(draft);
    if (!draft->is_comment()) last_id = draft->id;
  }
  return state_->finish(change, ":load " + path, last_id);
}

SessionResult Session::reset() {
  SessionCore& core = state_->core;
  core.report = Report();
  SessionChange change(core, {});
  return state_->finish(change, ":reset", 0);
}

bool Session::undo() {
  if (state_->current == 0) return false;
  state_->undone.push_back(state_->current);
  state_->go_to(state_->versions[state_->current].parent);
  return true;
}

bool Session::redo() {
  if (state_->undone.empty()) return false;
  const std::size_t next = state_->undone.back();
  state_->undone.pop_back();
  state_->go_to(next);
  return true;
}

bool Session::go_to(std::size_t version) {
  if (version >= state_->versions.size()) return false;
  state_->undone.clear();
  state_->go_to(version);
  return true;
}

std::size_t Session::version() const {
  return state_->current;
}
const std::vector<SessionVersion>& Session::versions() const {
  return state_->versions;
}
std::string Session::folder() const {
  return state_->core.files.folder();
}
bool Session::includes_files() const {
  const Document& document = state_->document();
  return std::any_of(document.begin(), document.end(), [](const StatementRef& statement) {
    return statement->kind == Kind::use || statement->kind == Kind::include;
  });
}
bool Session::is_empty() const {
  return state_->document().empty();
}
std::string Session::text(std::size_t version) const {
  return join_lines(*state_->documents[version].document);
}

std::string Session::formatted() const {
  SourceMap sources;
  return format(sources, sources.add("", "", text())).text;
}

std::string Session::diff(std::size_t from, std::size_t to) const {
  const auto statements_at = [this](std::size_t version) {
    const Document& document = *state_->documents[version].document;
    return std::vector<StatementRef>(document.begin(), document.end());
  };
  const std::vector<StatementRef> before = statements_at(from), after = statements_at(to);
  std::set<std::string_view> texts_before, texts_after;
  for (const StatementRef& statement : before) texts_before.insert(statement->text);
  for (const StatementRef& statement : after) texts_after.insert(statement->text);
  std::string out;
  const auto put = [&out](char mark, std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      out += fmt::format("{} {}\n", mark, text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  };
  std::size_t i = 0, j = 0;
  while (i < before.size() || j < after.size()) {
    if (i < before.size() && !texts_after.contains(before[i]->text))
      put('-', before[i++]->text);
    else if (j < after.size() && !texts_before.contains(after[j]->text))
      put('+', after[j++]->text);
    else
      i += i < before.size(), j += j < after.size();
  }
  return out;
}

const scene::Scene& Session::scene() {
  return state_->scene.scene();
}
const std::vector<Diagnostic>& Session::assumptions() {
  return state_->scene.assumptions();
}
std::vector<SceneRange> Session::ranges() {
  return state_->scene.ranges();
}

const Program& Session::program() const {
  return state_->core.program;
}
const SourceMap& Session::sources() const {
  return state_->core.program.sources;
}
const SessionCounters& Session::counters() const {
  return state_->core.counters;
}

} // namespace rt::lang
