#include "lang/session/session_submission.hpp"

#include "lang/session/session_text.hpp"
#include "lang/syntax/errors/syntax_codes.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace rt::lang {
namespace {

// All but the last of the statement's things, and the last.
std::pair<std::string, std::string> split_last(SessionChange& change, const Statement& statement) {
  const std::vector<SessionChange::Draft> parts = change.parse(statement.text, statement.origin, true);
  if (parts.empty()) return {};
  std::string head;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) head += (i == 0 ? "" : "\n") + parts[i]->text;
  return {head, parts.back()->text};
}

} // namespace

void Submission::run(std::string_view text) {
  const TextOrigin origin{fmt::format("input {}", ++core_.inputs), "", 1};
  const std::vector<SessionChange::Draft> drafts = change_.parse(std::string(text), origin, true);
  for (const SessionChange::Draft& draft : drafts) {
    if (core_.report.has_errors()) return;
    take(draft);
  }
}

void Submission::take(const SessionChange::Draft& draft) {
  if (draft->is_comment()) return change_.append(draft);
  const Ast& ast = draft->unit->ast;
  const NodeId item = draft->nodes.front();
  const bool is_thing = draft->kind == Kind::bind ||
                        (!draft->declares() && draft->kind != Kind::property && draft->kind != Kind::include);
  if (is_thing && draft->kind != Kind::bind && draft->kind != Kind::for_ && draft->kind != Kind::if_ &&
      edits_previous(ast, item))
    return edit(draft, item);
  if (draft->kind == Kind::bind) {
    if (const SessionChange::Draft rewritten = without_itself(draft)) {
      change_.place(rewritten);
      last_id_ = rewritten->id;
      return;
    }
    if (core_.report.has_errors()) return;
  }
  change_.place_and_tell(draft);
  if (is_thing) last_id_ = draft->id;
}

// `.move(x: 1)`: continues the text of the last thing.
void Submission::edit(const SessionChange::Draft& draft, NodeId item) {
  const auto at = change_.find_id(last_id_);
  if (!at) {
    core_.report.add(errors::line_begins_with_operator(draft->unit->ast.span(item),
                                                       "there is no thing before this line that it could change",
                                                       "a line that begins with `.` continues the previous one"));
    return;
  }
  const Statement& old = change_[*at];
  std::string text = old.text;
  const bool is_last_of_many = old.nodes.size() > 1;
  if (is_last_of_many) {
    const auto [head, last] = split_last(change_, old);
    text = last;
    if (const SessionChange::Draft first = change_.parse_again(old, head)) change_.replace(*at, first);
  }
  const std::string_view added = draft->text;
  const TextOrigin origin{draft->origin.name, "", 1};
  // After a comment it needs a line of its own.
  const bool has_comment = text.find("//") != std::string::npos;
  std::vector<SessionChange::Draft> made =
      change_.parse(text + (has_comment ? "\n" : "") + std::string(added.substr(added.find('.'))), origin, true);
  if (made.size() != 1) return;
  change_.changes.push_back("now: " + shortened(made.front()->text));
  if (is_last_of_many)
    change_.append(made.front());
  else
    change_.replace(*at, made.front());
  last_id_ = made.front()->id;
}

// `ball = ball { radius: 2 }` refers to the previous ball; the document spells out what that is.
SessionChange::Draft Submission::without_itself(const SessionChange::Draft& draft) {
  const auto at = change_.find(draft->key);
  if (!at || change_[*at].kind != Kind::bind) return nullptr;
  const Ast& ast = draft->unit->ast;
  const NodeId value = ast.bind_item(draft->nodes.front()).value;
  const std::string_view source = core_.program.sources.file(ast.file).text;
  const Statement& old = change_[*at];
  const Ast& old_ast = old.unit->ast;
  const NodeId old_value = old_ast.bind_item(old.nodes.front()).value;
  const Kind kind = old_ast.kind(old_value);
  std::string replacement(core_.program.sources.text(old_ast.span(old_value)));
  const bool is_postfix = kind == Kind::name || kind == Kind::override_ || kind == Kind::call || kind == Kind::member ||
                          kind == Kind::number || kind == Kind::numbers || kind == Kind::list || kind == Kind::color;
  if (!is_postfix) replacement = "(" + replacement + ")";
  const std::string rewritten = with_name_replaced(source, ast, value, draft->key, replacement);
  if (rewritten == source) return nullptr;
  // Of an input of several statements only this one.
  const std::size_t growth = rewritten.size() - source.size();
  const Node& whole = ast[draft->nodes.front()];
  const std::string statement = rewritten.substr(whole.begin, whole.end - whole.begin + growth);
  const std::size_t comments = draft->text.find(source.substr(whole.begin, whole.end - whole.begin));
  const std::string above = comments == std::string::npos ? "" : draft->text.substr(0, comments);
  const std::vector<SessionChange::Draft> made = change_.parse(above + statement, draft->origin, true);
  if (made.size() != 1) return nullptr;
  change_.changes.push_back("now: " + shortened(made.front()->text));
  return made.front();
}

} // namespace rt::lang
