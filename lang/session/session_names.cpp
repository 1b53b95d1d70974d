#include "lang/session/session_listing.hpp"
#include "lang/session/session_search.hpp"
#include "lang/session/session_state.hpp"
#include "lang/session/session_text.hpp"

#include <algorithm>
#include <utility>

// What a session's things and names are.
namespace rt::lang {

std::vector<ListedObject> Session::objects() {
  const SessionCore& core = state_->core;
  const scene::Scene& scene = state_->scene.scene();
  Numbering numbering(scene, core.program);
  std::vector<ListedObject> all;
  for (const StatementRef& statement : state_->document()) {
    const Numbering::Range range = numbering.next(*statement);
    for (ListedObject& object : list_objects(*statement, scene, core.program)) {
      object.first_number = range.count > 0 && object.name.empty() ? range.first : 0;
      object.last_number = object.first_number > 0 ? range.first + range.count - 1 : 0;
      all.push_back(std::move(object));
    }
  }
  return all;
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
  const TopName* found = nullptr; // the last one wins
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

std::string Session::model_of(std::string_view number) const {
  const auto wanted = list_number(number);
  if (!wanted) return "";
  const SessionCore& core = state_->core;
  Numbering numbering(state_->scene.scene(), core.program);
  for (const StatementRef& statement : state_->document()) {
    if (!numbering.next(*statement).holds(*wanted)) continue;
    const Ast& ast = statement->unit->ast;
    const NodeId base = innermost(ast, statement->nodes.front());
    return ast.kind(base) == Kind::name ? std::string(core.program.symbols.name(ast.symbol(base))) : "";
  }
  return "";
}

const NodeType* Session::noun_of(std::string_view name) const {
  if (list_number(name)) return noun_of(model_of(name));
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

const FunctionInfo* Session::def_of(std::string_view name) const {
  if (list_number(name)) return def_of(model_of(name));
  const TopName* found = find_name(state_->document(), state_->core.program.symbols.find(name));
  if (!found) return nullptr;
  if (found->meaning == Meaning::function) return found->known.is_thing() ? found->known.function : nullptr;
  const Value& value = state_->core.evaluator.session_value(found->slot);
  return value.is(ValueKind::thing) ? value.thing().def : nullptr;
}

std::vector<std::string> Session::properties_of(std::string_view name) const {
  std::vector<std::string> words;
  const NodeType* type = noun_of(name);
  if (!type) return words;
  for (const Property& property : type->properties) words.emplace_back(property.name);
  if (const FunctionInfo* def = def_of(name))
    for (const FunctionInfo::Parameter& parameter : def->parameters)
      words.emplace_back(state_->core.program.symbols.name(parameter.name));
  std::sort(words.begin(), words.end());
  return words;
}

} // namespace rt::lang
