#include "lang/session/session_search.hpp"

#include "lang/session/session_text.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace rt::lang {
namespace {

// Whether the statement places a thing with this `name`.
bool places(const SessionCore& core, const Statement& statement, std::string_view name) {
  const Ast& ast = statement.unit->ast;
  const Node& whole = ast[statement.nodes.front()];
  return std::any_of(ast.nodes.begin(), ast.nodes.end(), [&](const Node& node) {
    if (node.kind != Kind::property || core.program.symbols.name(Symbol{node.a}) != "name") return false;
    const NodeId value{node.b};
    const bool is_inside = node.begin >= whole.begin && node.end <= whole.end;
    return is_inside && ast.kind(value) == Kind::string && ast.text(value) == name;
  });
}

bool is_copy_of(const SessionCore& core, const Statement& statement, std::string_view type) {
  const Ast& ast = statement.unit->ast;
  const NodeId base = innermost(ast, statement.nodes.front());
  return ast.kind(base) == Kind::name && core.program.symbols.name(ast.symbol(base)) == type;
}

std::string nothing_called(const SessionCore& core, const SessionChange& change, std::string_view name) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < change.size(); ++i)
    for (const TopName& top : change[i].names) names.push_back(core.program.symbols.name(top.name));
  const auto guess = nearest(name, names);
  return fmt::format("there is nothing called `{}`{}", name, guess ? fmt::format("; did you mean `{}`?", *guess) : "");
}

} // namespace

Search find_thing(const SessionCore& core, const SessionChange& change, std::string_view name) {
  if (const Symbol symbol = core.program.symbols.find(name); symbol != no_symbol)
    if (const auto at = change.find(symbol)) return {at, ""};
  std::vector<std::size_t> copies;
  std::size_t count = 0;
  for (std::size_t i = change.size(); i-- > 0;) {
    const Statement& statement = change[i];
    if (statement.declares() || statement.is_comment()) continue;
    if (statement.nodes.size() == 1 && places(core, statement, name)) return {i, ""};
    if (!is_copy_of(core, statement, name)) continue;
    copies.push_back(i);
    count += statement.nodes.size();
  }
  if (count == 1) return {copies.front(), ""};
  if (count == 0) return {std::nullopt, nothing_called(core, change, name)};
  return {std::nullopt, fmt::format("there are {} of `{}`; which one?", count, name)};
}

} // namespace rt::lang
