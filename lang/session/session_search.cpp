#include "lang/session/session_search.hpp"

#include "lang/session/session_listing.hpp"
#include "lang/session/session_text.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <string>
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

Search find_number(SessionCore& core, const SessionChange& change, std::uint64_t number) {
  Numbering numbering(core.evaluator.scene(), core.program);
  std::uint64_t last = 0;
  for (std::size_t i = 0; i < change.size(); ++i) {
    const Numbering::Range range = numbering.next(change[i]);
    if (range.holds(number)) return {i, number - range.first, "", ""};
    if (range.count > 0) last = range.first + range.count - 1;
  }
  return {std::nullopt, 0, fmt::format("there is no thing number {}", number),
          last == 0 ? "only things without a name have a number, and everything has a name"
                    : fmt::format(":list goes up to {}", last)};
}

// How to say which of several is meant.
std::string numbers_of(SessionCore& core, const SessionChange& change, const std::vector<std::size_t>& statements) {
  constexpr std::size_t most = 5;
  Numbering numbering(core.evaluator.scene(), core.program);
  std::vector<std::string> numbers;
  bool are_more = false;
  for (std::size_t i = 0; i < change.size(); ++i) {
    const Numbering::Range range = numbering.next(change[i]);
    if (std::find(statements.begin(), statements.end(), i) == statements.end()) continue;
    for (std::uint64_t n = 0; n < range.count; ++n) {
      are_more = numbers.size() == most;
      if (are_more) break;
      numbers.push_back(std::to_string(range.first + n));
    }
  }
  if (numbers.empty()) return "";
  return fmt::format("use its number from :list instead of the name: {}{}", fmt::join(numbers, ", "),
                     are_more ? ", …" : "");
}

constexpr std::string_view how_to_name =
    "a thing has a name when it is bound with `=`, or by its property `name`; what "
    "has none has a number that :list shows";

} // namespace

std::optional<std::uint64_t> list_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

Search find_thing(SessionCore& core, const SessionChange& change, std::string_view name) {
  if (const auto number = list_number(name)) return find_number(core, change, *number);
  if (const Symbol symbol = core.program.symbols.find(name); symbol != no_symbol)
    if (const auto at = change.find(symbol)) return {at, 0, "", ""};
  std::vector<std::size_t> copies;
  std::size_t count = 0;
  for (std::size_t i = 0; i < change.size(); ++i) {
    const Statement& statement = change[i];
    if (statement.declares() || statement.is_comment()) continue;
    if (statement.nodes.size() == 1 && places(core, statement, name)) return {i, 0, "", ""};
    if (!is_copy_of(core, statement, name)) continue;
    copies.push_back(i);
    count += statement.nodes.size();
  }
  if (count == 1) return {copies.front(), 0, "", ""};
  if (count == 0) return {std::nullopt, 0, nothing_called(core, change, name), std::string(how_to_name)};
  return {std::nullopt, 0, fmt::format("there are {} of `{}`; which one?", count, name),
          numbers_of(core, change, copies)};
}

} // namespace rt::lang
