#include "lang/session/session_change.hpp"

#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/deep_stack.hpp"
#include "lang/session/session_text.hpp"
#include "lang/syntax/parse.hpp"
#include "lang/text/sort_unique.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace rt::lang {
namespace {

Symbol key_of(const Ast& ast, NodeId node) {
  switch (ast.kind(node)) {
  case Kind::bind:
    return ast.symbol(ast.bind_item(node).name);
  case Kind::def:
  case Kind::fn:
    return ast.symbol(ast.function(node).name);
  case Kind::use:
    return ast.symbol(ast.use_item(node).name);
  case Kind::param:
    return ast.symbol(ast.param_item(node).name);
  case Kind::property:
    return ast.named(node).symbol;
  default:
    return no_symbol;
  }
}

} // namespace

SessionCore::SessionCore(std::string folder, LoadOptions load_options)
    : options(std::move(load_options)), files(program, report, *options.files, folder, options.include_roots),
      evaluator(program, report, options.limits, options.stop, nullptr) {
  files.parse_library_and_defines(options.defines);
  check_library(program, files, report);
  run_on_deep_stack([this](const char* stack_limit) {
    evaluator.begin_session();
    evaluator.begin_input(0, stack_limit);
  });
}

SessionChange::SessionChange(SessionCore& core, const Document& document) : core_(core), old_(document) {
  core.evaluator.begin_change();
  entries_.reserve(document.size() + 1);
  for (std::uint32_t c = 0; c < old_.chunks().size(); ++c) {
    const Document::Chunk& chunk = *old_.chunks()[c];
    for (std::size_t i = 0; i < chunk.statements.size(); ++i)
      entries_.push_back({&chunk.statements[i], nullptr, c, chunk.traits[i]});
  }
}

std::uint64_t SessionChange::declared_bits(const RevisedStatement& entry) const {
  if (!entry.fresh) return chunk_of(entry).names[place_in_chunk(entry)];
  std::uint64_t bits = entry.fresh->declares() ? symbol_bit(entry.fresh->key) : 0;
  for (const TopName& name : entry.fresh->names) bits |= symbol_bit(name.name);
  return bits;
}

std::uint64_t SessionChange::used_bits(const RevisedStatement& entry) const {
  return entry.fresh ? ~std::uint64_t{0} : chunk_of(entry).uses[place_in_chunk(entry)];
}

Unit& SessionChange::add_unit(std::string text, const TextOrigin& origin, bool folds_repeats, bool is_typed) {
  const FileId file = core_.program.sources.add(origin.name, origin.path, std::move(text));
  ParseOptions options;
  options.folds_repeats = folds_repeats;
  options.is_session = is_typed;
  Parsed parsed = rt::lang::parse(core_.program.sources, file, core_.program.symbols, options);
  core_.report.take(std::move(parsed.diagnostics));
  Unit& unit = core_.program.units.emplace_back();
  unit.ast = std::move(parsed.ast);
  return unit;
}

SessionChange::Draft SessionChange::make_draft(Unit& unit, NodeId node, const std::string& text,
                                               const TextOrigin& origin) const {
  auto draft = std::make_shared<Statement>();
  draft->id = ++core_.last_id;
  draft->text = text;
  draft->origin = origin;
  draft->unit = &unit;
  if (node == no_node) return draft;
  draft->kind = unit.ast.kind(node);
  draft->key = key_of(unit.ast, node);
  draft->nodes.push_back(node);
  ++core_.counters.statements_parsed;
  return draft;
}

std::vector<SessionChange::Draft> SessionChange::parse(std::string text, const TextOrigin& origin, bool is_typed) {
  Unit& unit = add_unit(std::move(text), origin, !is_typed, is_typed);
  const std::string_view source = core_.program.sources.file(unit.ast.file).text;
  const NodeList items = unit.ast.children(unit.ast.root);
  std::vector<Draft> drafts;
  if (core_.report.has_errors()) return drafts;
  const std::vector<ItemText> texts = cut_items(source, unit.ast, items);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const NodeId node = i < items.size() ? items[i] : no_node;
    const TextOrigin place{origin.name, origin.path, origin.line + texts[i].line - 1};
    // Things that were folded into repeats are a single statement.
    const bool continues = node != no_node && unit.ast.kind(node) == Kind::repeat && !drafts.empty() &&
                           drafts.back()->nodes.front() == unit.ast.repeat(node).model;
    if (continues) {
      drafts.back()->nodes.push_back(node);
      drafts.back()->text += "\n" + texts[i].text;
      continue;
    }
    drafts.push_back(make_draft(unit, node, texts[i].text, place));
    drafts.back()->may_print = is_typed;
  }
  return drafts;
}

std::vector<SessionChange::Draft> SessionChange::parse_file(std::string text, const TextOrigin& origin) {
  return parse(std::move(text), origin, false);
}

// The lines above it are padding, so that its own have the right numbers.
SessionChange::Draft SessionChange::parse_again(const Statement& old, std::string text) {
  const std::string lines(old.origin.line - 1, '\n');
  Unit& unit = add_unit(lines + text, old.origin, true, false);
  const NodeList items = unit.ast.children(unit.ast.root);
  if (core_.report.has_errors()) return nullptr;
  if (items.empty()) return nullptr;
  Draft draft = make_draft(unit, items.front(), text, old.origin);
  draft->nodes.assign(items.begin(), items.end());
  draft->id = old.id;
  draft->may_print = old.may_print;
  return draft;
}

SessionChange::Draft SessionChange::redraft(const Statement& old) {
  return parse_again(old, old.text);
}

void SessionChange::append(Draft draft) {
  entries_.push_back({.fresh = std::move(draft)});
}

void SessionChange::clear() {
  entries_.clear();
}

std::optional<std::size_t> SessionChange::find(Symbol name) const {
  for (std::size_t i = entries_.size(); i-- > 0;) {
    if ((declared_bits(entries_[i]) & symbol_bit(name)) == 0) continue;
    const Statement& statement = entries_[i].get();
    if (statement.declares() && statement.key == name) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> SessionChange::find_id(std::uint64_t id) const {
  for (std::size_t i = entries_.size(); i-- > 0;)
    if (entries_[i].get().id == id) return i;
  return std::nullopt;
}

std::vector<std::size_t> SessionChange::users(std::size_t at) const {
  std::vector<std::size_t> found;
  for (const TopName& name : entries_[at].get().names) {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if ((used_bits(entries_[i]) & symbol_bit(name.name)) == 0) continue;
      const std::vector<Symbol>& uses = entries_[i].get().uses;
      if (i != at && std::binary_search(uses.begin(), uses.end(), name.name)) found.push_back(i);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void SessionChange::place(Draft draft) {
  std::optional<std::size_t> old;
  if (draft->declares()) {
    old = find(draft->key);
  } else if (draft->kind == Kind::property) {
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if ((entries_[i].traits() & trait_sets_property) != 0 && entries_[i].get().key == draft->key) old = i;
  }
  if (!old) return append(std::move(draft));
  replace(*old, std::move(draft));
}

void SessionChange::place_and_tell(Draft draft) {
  const std::size_t size = entries_.size();
  const Draft placed = draft;
  place(std::move(draft));
  reported_.push_back({placed->id, entries_.size() == size});
}

// Sorted.
std::vector<Symbol> SessionChange::mentioned(const Statement& statement) const {
  std::vector<Symbol> symbols;
  const Ast& ast = statement.unit->ast;
  for (const NodeId item : statement.nodes) {
    const Node& whole = ast[item];
    for (const Node& node : ast.nodes) {
      const bool is_inside = node.begin >= whole.begin && node.end <= whole.end;
      if (is_inside && node.kind == Kind::name) symbols.push_back(Symbol{node.a});
    }
  }
  sort_unique(symbols);
  return symbols;
}

// What the new statement needs must precede it; if that came later than the old one, it moves there.
void SessionChange::replace(std::size_t at, Draft draft) {
  const Statement& old = entries_[at].get();
  draft->id = old.id;
  mark_changed(old, at);
  const std::vector<Symbol> symbols = mentioned(*draft);
  std::uint64_t bits = 0;
  for (const Symbol symbol : symbols) bits |= symbol_bit(symbol);
  std::size_t needed = at;
  for (std::size_t i = at + 1; i < entries_.size(); ++i) {
    if ((entries_[i].traits() & trait_declares) == 0 || (declared_bits(entries_[i]) & bits) == 0) continue;
    const Statement& later = entries_[i].get();
    if (draft->is_function() && later.is_function()) continue;
    if (std::binary_search(symbols.begin(), symbols.end(), later.key)) needed = i;
  }
  if (needed > at) return move_behind(at, needed, std::move(draft));
  entries_[at] = {.fresh = std::move(draft)};
}

void SessionChange::move_behind(std::size_t at, std::size_t needed, Draft draft) {
  const std::vector<Symbol> symbols = mentioned(*draft);
  std::set<Symbol> moved_names;
  for (const TopName& name : entries_[at].get().names) moved_names.insert(name.name);
  std::vector<RevisedStatement> before(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(at)), moved;
  for (std::size_t i = at + 1; i <= needed; ++i) {
    const Statement& statement = entries_[i].get();
    const bool moves =
        std::any_of(statement.uses.begin(), statement.uses.end(), [&](Symbol s) { return moved_names.contains(s); });
    if (moves && statement.declares() && std::binary_search(symbols.begin(), symbols.end(), statement.key)) {
      const std::string_view name = core_.program.symbols.name(draft->key),
                             other = core_.program.symbols.name(statement.key);
      core_.report.add(errors::no_value_yet(draft->unit->ast.span(draft->nodes.front()),
                                            fmt::format("`{}` would depend on itself: `{}` uses it", name, other),
                                            fmt::format("this uses `{}`", other)));
    }
    for (const TopName& name : statement.names)
      if (moves) moved_names.insert(name.name);
    (moves ? moved : before).push_back(entries_[i]);
  }
  before.push_back({.fresh = std::move(draft)});
  before.insert(before.end(), moved.begin(), moved.end());
  before.insert(before.end(), entries_.begin() + static_cast<std::ptrdiff_t>(needed) + 1, entries_.end());
  entries_ = std::move(before);
}

void SessionChange::split(std::size_t at) {
  const StatementRef old = entries_[at].fresh ? entries_[at].fresh : *entries_[at].done;
  if (old->nodes.size() == 1 && old->kind != Kind::repeat) return;
  std::vector<RevisedStatement> parts;
  for (const Draft& draft : parse(old->text, old->origin, true)) {
    draft->may_print = old->may_print;
    parts.push_back({.fresh = draft});
  }
  const auto place = entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(at));
  entries_.insert(place, parts.begin(), parts.end());
}

void SessionChange::erase(std::size_t at) {
  mark_changed(entries_[at].get(), at);
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(at));
}

void SessionChange::mark_changed(const Statement& statement, std::size_t position) {
  const auto mark = [&](Symbol name, bool is_function) {
    changed_bits_ |= symbol_bit(name);
    const auto [found, is_new] =
        changed_.try_emplace(static_cast<std::uint32_t>(name), ChangedName{is_function, position});
    found->second.is_function |= is_function;
    found->second.position = std::min(found->second.position, position);
  };
  if (statement.declares()) mark(statement.key, statement.is_function());
  for (const TopName& name : statement.names) mark(name.name, name.meaning == Meaning::function);
}

// Whether it uses changed names of other statements, or names that would now mean something else.
bool SessionChange::is_affected(const Statement& statement, std::size_t position) const {
  const auto is_changed = [&](Symbol name, bool was_global) {
    const auto found = changed_.find(static_cast<std::uint32_t>(name));
    if (found == changed_.end()) return false;
    return !was_global || found->second.is_function || found->second.position < position;
  };
  return std::any_of(statement.uses.begin(), statement.uses.end(), [&](Symbol s) { return is_changed(s, false); }) ||
         std::any_of(statement.globals.begin(), statement.globals.end(), [&](Symbol s) { return is_changed(s, true); });
}

void SessionChange::renew_dependents() {
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (entries_[i].fresh) mark_changed(*entries_[i].fresh, i);
  if (changed_.empty()) return;
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      RevisedStatement& entry = entries_[i];
      if (entry.fresh || (used_bits(entry) & changed_bits_) == 0) continue;
      const Statement& done = **entry.done;
      if (!is_affected(done, i)) continue;
      entry.fresh = redraft(done);
      if (!entry.fresh) return; // impossible: it was read before
      mark_changed(done, i);
      renewed_.push_back(shortened(done.text));
      goes_on = true;
    }
  }
}

} // namespace rt::lang
