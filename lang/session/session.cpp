#include "lang/session/session.hpp"

#include "lang/builtins/builtins.hpp"
#include "lang/format/format.hpp"
#include "lang/session/session_change.hpp"
#include "lang/session/session_scene.hpp"
#include "lang/session/session_search.hpp"
#include "lang/session/session_submission.hpp"
#include "lang/session/session_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace rt::lang {

struct Session::State {
  State(std::string folder, LoadOptions options)
      : core(std::move(folder), std::move(options)), scene(core.evaluator, core.program) {
    versions.push_back({"", 0});
    documents.push_back({std::make_shared<const Document>(), 0});
  }

  struct Kept {
    std::shared_ptr<const Document> document;
    std::uint64_t last_id = 0; ///< the statement that a line beginning with `.` edits
  };

  const Document& document() const { return *documents[current].document; }

  /// The outcome of a change: a new version unless there is an error, or nothing has changed.
  SessionResult finish(SessionChange& change, std::string description, std::uint64_t last_id) {
    SessionResult result;
    std::optional<Document> made = change.finish();
    result.diagnostics = core.report.diagnostics();
    result.printed = core.evaluator.take_printed();
    if (!made) {
      scene.show(document()); // evaluation may have left its own settings in it
      return result;
    }
    result.is_accepted = true;
    result.changes = std::move(change.changes);
    result.values = std::move(change.values);
    if (*made != document()) keep(std::make_shared<const Document>(std::move(*made)), std::move(description), last_id);
    scene.show(document());
    return result;
  }

  void keep(std::shared_ptr<const Document> made, std::string description, std::uint64_t last_id) {
    versions.push_back({std::move(description), current});
    documents.push_back({std::move(made), last_id});
    current = versions.size() - 1;
    undone.clear();
  }

  void go_to(std::size_t version) {
    current = version;
    scene.show(document());
  }

  SessionCore core;
  SessionScene scene;
  std::vector<SessionVersion> versions;
  std::vector<Kept> documents;     // by version
  std::vector<std::size_t> undone; // versions that redo leads to, the next one last
  std::size_t current = 0;
};

namespace {

SessionResult failed(SessionCore& core) {
  SessionResult result;
  result.diagnostics = core.report.diagnostics();
  return result;
}

SessionResult failed(std::string problem, std::vector<std::string> advice = {}) {
  SessionResult result;
  result.problem = std::move(problem);
  result.advice = std::move(advice);
  return result;
}

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
  if (core.report.has_errors()) return failed(core);
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

namespace {

constexpr const char* how_to_name = "a thing has a name when it is bound with `=`, or by its property `name`";

std::string line_of(const Statement& statement) {
  return fmt::format("`{}`", shortened(statement.text));
}

} // namespace

SessionResult Session::set(std::string_view target, std::string_view value) {
  SessionCore& core = state_->core;
  const std::size_t dot = target.find('.');
  if (dot == std::string_view::npos) return submit(fmt::format("{}: {}", target, value));
  const std::string_view name = target.substr(0, dot), property = target.substr(dot + 1);
  core.report = Report();
  SessionChange change(core, state_->document());
  const auto [at, problem] = find_thing(core, change, name);
  if (!at) return failed(problem, {how_to_name});
  const Statement& statement = change[*at];
  const Ast& ast = statement.unit->ast;
  if (statement.is_function() || statement.kind == Kind::use || statement.kind == Kind::include)
    return failed(fmt::format("`{}` is no thing, but a declaration", name));
  NodeId node = statement.nodes.front();
  if (statement.kind == Kind::bind) node = ast.bind_item(node).value;
  const std::string_view source = core.program.sources.file(ast.file).text;
  const auto edited = with_property(source, ast, node, core.program.symbols.intern(property), property, value);
  if (!edited) return failed(fmt::format("{} has no properties", line_of(statement)));
  const Node& whole = ast[statement.nodes.front()];
  const std::string old_item(source.substr(whole.begin, whole.end - whole.begin));
  const std::string item = edited->substr(whole.begin, old_item.size() + edited->size() - source.size());
  std::string text = statement.text;
  const std::size_t place = text.find(old_item);
  if (place == std::string::npos)
    text = item;
  else
    text.replace(place, old_item.size(), item);
  const std::string before = shortened(text);
  SessionChange::Draft draft = change.parse_again(statement, text);
  if (!draft) return failed(core);
  const std::uint64_t id = statement.id;
  change.changes.push_back("now: " + before);
  change.replace(*at, std::move(draft));
  return state_->finish(change, fmt::format(":set {} {}", target, value), id);
}

SessionResult Session::remove(std::string_view name) {
  SessionCore& core = state_->core;
  core.report = Report();
  SessionChange change(core, state_->document());
  auto [at, problem] = find_thing(core, change, name);
  if (!at) {
    const Symbol symbol = core.program.symbols.find(name);
    for (std::size_t i = 0; i < change.size(); ++i)
      if (symbol != no_symbol && change[i].kind == Kind::property && change[i].key == symbol) at = i;
  }
  if (!at) return failed(problem, {how_to_name});
  const std::vector<std::size_t> users = change.users(*at);
  if (!users.empty()) {
    std::vector<std::string> advice;
    for (const std::size_t user : users) advice.push_back("by " + line_of(change[user]));
    return failed(fmt::format("`{}` cannot be removed: it is used", name), std::move(advice));
  }
  change.changes.push_back("removed: " + shortened(change[*at].text));
  change.erase(*at);
  return state_->finish(change, fmt::format(":remove {}", name), state_->documents[state_->current].last_id);
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

std::vector<ListedObject> Session::objects() {
  return list_objects(state_->document(), state_->scene.scene(), state_->core.program);
}

std::vector<std::string> Session::names() const {
  std::vector<std::string> names;
  for (const StatementRef& statement : state_->document())
    for (const TopName& name : statement->names) names.emplace_back(state_->core.program.symbols.name(name.name));
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

const TopName* find_name(const Document& document, Symbol symbol) {
  if (symbol == no_symbol) return nullptr;
  const TopName* found = nullptr; // the last one counts
  for (const auto& chunk : document.chunks()) {
    for (std::size_t i = 0; i < chunk->statements.size(); ++i) {
      if ((chunk->names[i] & symbol_bit(symbol)) == 0) continue;
      for (const TopName& name : chunk->statements[i]->names)
        if (name.name == symbol) found = &name;
    }
  }
  return found;
}

} // namespace

std::string Session::text_of(std::string_view name) const {
  const Symbol symbol = state_->core.program.symbols.find(name);
  if (symbol == no_symbol) return "";
  for (const StatementRef& statement : state_->document())
    if (statement->declares() && statement->key == symbol) return statement->text;
  return "";
}

const NodeType* Session::noun_of(std::string_view name) const {
  SessionCore& core = state_->core;
  if (const TopName* found = find_name(state_->document(), core.program.symbols.find(name))) {
    if (found->meaning == Meaning::function) return found->known.is_thing() ? found->known.type : nullptr;
    const Value& value = core.evaluator.session_value(found->slot);
    return value.is(ValueKind::thing) ? value.thing().type : nullptr;
  }
  for (const Program::LibraryName& entry : core.program.library_names)
    if (core.program.symbols.name(entry.name) == name) return &core.program.types.material();
  return core.program.types.find(name);
}

std::vector<std::string> Session::properties_of(std::string_view name) const {
  std::vector<std::string> words;
  const Program& program = state_->core.program;
  const NodeType* type = noun_of(name);
  if (!type) return words;
  for (const Property& property : type->properties) words.emplace_back(property.name);
  if (const TopName* found = find_name(state_->document(), program.symbols.find(name))) {
    const FunctionInfo* def = found->known.function;
    if (found->meaning != Meaning::function) {
      const Value& value = state_->core.evaluator.session_value(found->slot);
      def = value.is(ValueKind::thing) ? value.thing().def : nullptr;
    }
    if (def)
      for (const FunctionInfo::Parameter& parameter : def->parameters)
        words.emplace_back(program.symbols.name(parameter.name));
  }
  std::sort(words.begin(), words.end());
  return words;
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
