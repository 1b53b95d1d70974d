#include "lang/session/session_search.hpp"
#include "lang/session/session_state.hpp"
#include "lang/session/session_text.hpp"

#include <fmt/format.h>

#include <utility>

// Changes by name or number to statements of the document.
namespace rt::lang {
namespace {

SessionResult failed(std::string problem, std::vector<std::string> advice = {}) {
  SessionResult result;
  result.problem = std::move(problem);
  std::erase(advice, "");
  result.advice = std::move(advice);
  return result;
}

// Splits off what was found as a statement of its own.
std::size_t single_out(SessionChange& change, const Search& search) {
  change.split(*search.found);
  return *search.found + search.item;
}

std::string line_of(const Statement& statement) {
  return fmt::format("`{}`", shortened(statement.text));
}

// Whether a line `name = …` can be typed again.
bool is_bound(const SessionCore& core, const SessionChange& change, std::string_view name) {
  const Symbol symbol = core.program.symbols.find(name);
  const auto at = symbol == no_symbol ? std::nullopt : change.find(symbol);
  return at && change[*at].kind == Kind::bind;
}

} // namespace

SessionResult Session::set(std::string_view target, std::string_view value) {
  SessionCore& core = state_->core;
  const std::size_t dot = target.find('.');
  if (dot == std::string_view::npos) {
    const bool is_own = is_bound(core, SessionChange(core, state_->document()), target);
    return submit(fmt::format("{}{} {}", target, is_own ? " =" : ":", value));
  }
  const std::string_view name = target.substr(0, dot), property = target.substr(dot + 1);
  core.report = Report();
  SessionChange change(core, state_->document());
  const Search search = find_thing(core, change, name);
  if (!search.found) return failed(search.problem, {search.advice});
  const std::size_t at = single_out(change, search);
  const Statement& statement = change[at];
  const Ast& ast = statement.unit->ast;
  if (statement.is_function() || statement.kind == Kind::use || statement.kind == Kind::include)
    return failed(fmt::format("`{}` is a declaration, not a thing", name),
                  {"set what it makes, where that is placed, by its name or its number in :list"});
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
  if (!draft) return state_->failed();
  const std::uint64_t id = statement.id;
  change.changes.push_back("now: " + before);
  change.replace(at, std::move(draft));
  return state_->finish(change, fmt::format(":set {} {}", target, value), id);
}

SessionResult Session::remove(std::string_view name) {
  SessionCore& core = state_->core;
  core.report = Report();
  SessionChange change(core, state_->document());
  Search search = find_thing(core, change, name);
  if (!search.found) {
    const Symbol symbol = core.program.symbols.find(name);
    for (std::size_t i = 0; i < change.size(); ++i)
      if (symbol != no_symbol && change[i].kind == Kind::property && change[i].key == symbol) search.found = i;
  }
  if (!search.found) return failed(search.problem, {search.advice});
  const std::size_t at = single_out(change, search);
  const std::vector<std::size_t> users = change.users(at);
  if (!users.empty()) {
    std::vector<std::string> advice;
    for (const std::size_t user : users) advice.push_back("by " + line_of(change[user]));
    return failed(fmt::format("`{}` cannot be removed: it is used", name), std::move(advice));
  }
  change.changes.push_back("removed: " + shortened(change[at].text));
  change.erase(at);
  return state_->finish(change, fmt::format(":remove {}", name), state_->documents[state_->current].last_id);
}

} // namespace rt::lang
