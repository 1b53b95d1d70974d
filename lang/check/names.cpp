#include "lang/check/names.hpp"

#include "lang/builtins/builtins.hpp"
#include "lang/check/check.hpp"
#include "lang/check/errors/dialects.hpp"
#include "lang/check/errors/name_errors.hpp"
#include "lang/syntax/errors/syntax_errors.hpp"
#include "lang/text/tokens.hpp"
#include "lang/values/css_colors.hpp"

#include <algorithm>
#include <utility>

namespace rt::lang {

StaticType NameResolver::resolve(Unit& unit, NodeId node, Reference::Use use) {
  Binding* binding = scopes_.find(unit.ast.symbol(node));
  if (statement_) note_use(unit.ast.symbol(node), binding);
  return binding ? resolve_binding(unit, node, *binding, use) : resolve_global(unit, node);
}

StaticType NameResolver::resolve_binding(Unit& unit, NodeId node, Binding& binding, Reference::Use use) {
  ++binding.reads;
  const bool is_part = use == Reference::Use::reads_part && !is_in_expect_;
  if (binding.declaration != no_declaration)
    context_.program.references.add(unit.ast.span(node), binding.declaration,
                                    is_part ? Reference::Use::reads_part : Reference::Use::reads);
  const std::size_t depth = scopes_.frames_out(binding);
  switch (binding.meaning) {
  case Meaning::error:
    unit.ast.set_slot(node, 0, pack(Resolution::none, 0));
    break;
  case Meaning::function:
    unit.ast.set_slot(node, binding.slot, pack(Resolution::function, depth));
    break;
  case Meaning::value:
  case Meaning::module:
    unit.ast.set_slot(node, binding.slot, pack(Resolution::local, depth));
    break;
  }
  return binding.known;
}

StaticType NameResolver::resolve_global(Unit& unit, NodeId node) {
  Program& program = context_.program;
  const std::string_view word = context_.name(unit.ast.symbol(node));
  const auto found = [&](Resolution resolution, std::size_t index, Referent referent) {
    unit.ast.set_slot(node, static_cast<std::uint32_t>(index), pack(resolution, 0));
    program.references.add(unit.ast.span(node), referent);
  };
  StaticType known;
  if (const NodeType* type = program.types.find(word)) {
    found(Resolution::type, program.types.index(*type), type);
    known.what = StaticType::What::thing, known.type = type, known.is_bare_noun = true;
  } else if (const auto builtin = find_builtin(word)) {
    known.what = StaticType::What::builtin, known.builtin = all_builtins()[*builtin];
    found(Resolution::builtin, *builtin, known.builtin);
  } else if (const Constant* constant = find_constant(word)) {
    found(Resolution::constant, static_cast<std::size_t>(constant - constants().data()), constant);
  } else if (const auto choice = std::ranges::find(program.choices, word); choice != program.choices.end()) {
    found(Resolution::choice, static_cast<std::size_t>(choice - program.choices.begin()), Choice{*choice});
  } else if (const auto color = find_css_color(word)) {
    found(Resolution::color, *color, ColorName{word, *color});
  } else {
    unit.ast.set_slot(node, 0, pack(Resolution::none, 0));
    report_unknown(unit, node);
  }
  return known;
}

std::optional<StaticType> NameResolver::resolve_question(Unit& unit, NodeId node) {
  const auto question = is_in_expect_ ? find_question(context_.name(unit.ast.symbol(node))) : std::nullopt;
  if (!question) return std::nullopt;
  unit.ast.set_slot(node, static_cast<std::uint32_t>(*question), pack(Resolution::question, 0));
  StaticType known;
  known.what = StaticType::What::builtin, known.builtin = &questions()[*question];
  context_.program.references.add(unit.ast.span(node), known.builtin);
  return known;
}

void NameResolver::refer_to_names(Span span) {
  Program& program = context_.program;
  const std::string_view text = context_.text(span);
  std::string_view before;
  for (std::uint32_t at = 0;;) {
    const Token token = next_token(text, at);
    if (token.kind == TokenKind::end) return;
    at = token.end;
    const std::string_view word = text_of(text, token);
    const bool is_member = std::exchange(before, word) == ".";
    if (token.kind != TokenKind::name || is_member) continue;
    const Span place{span.file, span.begin + token.begin, span.begin + token.end};
    const Symbol symbol = program.symbols.find(word);
    if (const Binding* binding = symbol == no_symbol ? nullptr : scopes_.find(symbol)) {
      if (binding->declaration != no_declaration) program.references.add(place, binding->declaration);
    } else if (const NodeType* type = program.types.find(word)) {
      program.references.add(place, type);
    } else if (const auto builtin = find_builtin(word)) {
      program.references.add(place, all_builtins()[*builtin]);
    }
  }
}

void NameResolver::note_use(Symbol symbol, const Binding* binding) {
  if (!binding || scopes_.is_outside_file(*binding))
    statement_->globals.push_back(symbol);
  else if (scopes_.is_top_level(*binding))
    statement_->uses.push_back(symbol);
}

std::vector<std::string_view> NameResolver::visible_names() {
  std::vector<std::string_view> names;
  for (const Binding& binding : scopes_.bindings()) names.push_back(context_.name(binding.name));
  if (add_further_names_) (*add_further_names_)(names);
  for (const NodeType& type : context_.program.types.all()) names.push_back(type.name);
  for (const Builtin* builtin : all_builtins()) names.push_back(builtin->name);
  for (const Constant& constant : constants()) names.push_back(constant.name);
  for (const CssColor& color : css_colors()) names.push_back(color.name);
  return names;
}

namespace {

/// Where a name is bound in a block, if it is.
std::optional<Span> bound_in(const Ast& ast, NodeId block, Symbol symbol) {
  if (block == no_node || ast.kind(block) != Kind::block) return std::nullopt;
  for (const NodeId item : ast.children(block)) {
    NodeId bound = no_node;
    if (ast.kind(item) == Kind::bind)
      bound = ast.bind_item(item).name;
    else if (ast.kind(item) == Kind::param)
      bound = ast.param_item(item).name;
    else if (ast.kind(item) == Kind::use)
      bound = ast.use_item(item).name;
    if (bound != no_node && ast.symbol(bound) == symbol) return ast.span(bound);
  }
  return std::nullopt;
}

/// Where a name is bound in any block of the file that ends before `place`.
std::optional<Span> bound_in_closed_block(const Ast& ast, std::uint32_t place, Symbol symbol) {
  for (std::uint32_t i = 0; i < ast.nodes.size(); ++i) {
    const Node& node = ast.nodes[i];
    if (node.kind != Kind::block || node.end > place) continue;
    if (const auto span = bound_in(ast, NodeId{i}, symbol)) return span;
  }
  return std::nullopt;
}

} // namespace

// A name that is bound on a later line, or gets its value from the current one.
bool NameResolver::report_early(const Unit& unit, NodeId node) {
  const Symbol symbol = unit.ast.symbol(node);
  const Span span = unit.ast.span(node);
  if (symbol == being_bound_.name) {
    errors::name_in_its_own_value(context_, span, symbol, being_bound_.is_lambda);
    return true;
  }
  for (std::size_t i = scopes_.all().size(); i-- > 0;) {
    const Scope& scope = scopes_.all()[i];
    if (scope.unit != &unit) continue;
    if (const auto later = bound_in(unit.ast, scope.block, symbol)) {
      errors::name_before_its_value(context_, span, symbol, *later);
      return true;
    }
  }
  return false;
}

// `light_source { <2, 4, -3> … }`: the error in the block shows the whole form.
bool NameResolver::is_form_shown(const Span& name) const {
  const std::string_view text = context_.program.sources.file(name.file).text;
  const Token brace = next_token(text, name.end);
  return text_of(text, brace) == "{" && text_of(text, next_token(text, brace.end)) == "<" &&
         is_povray_thing(text, brace.begin);
}

void NameResolver::report_unknown(const Unit& unit, NodeId node) {
  if (names_are_missing_ || report_early(unit, node) || is_form_shown(unit.ast.span(node))) return;
  const Symbol symbol = unit.ast.symbol(node);
  const std::string_view word = context_.name(symbol);
  const Span span = unit.ast.span(node);
  for (std::size_t i = scopes_.all().size(); i-- > 0;) {
    const Owner& owner = scopes_.all()[i].owner;
    const bool is_property =
        (owner.def && owner.def->find(symbol) && !owner.is_def_body) || (owner.type && owner.type->find(symbol));
    if (!is_property || find_css_color(word)) continue;
    const std::string_view text = context_.program.sources.file(span.file).text;
    return errors::property_is_no_name(context_, span, symbol, text_of(text, next_token(text, span.end)) == "{");
  }
  if (const auto inner = bound_in_closed_block(unit.ast, span.begin, symbol))
    return errors::name_of_another_block(context_, span, symbol, *inner);
  if (const std::string other = dialect_name(word); !other.empty())
    return errors::name_of_another_language(context_, span, symbol, other);
  if (is_in_define_) return errors::unquoted_string(context_, span, symbol);
  if (!choices_.empty()) return errors::unknown_choice(context_, span, symbol, choices_);
  errors::unknown_name(context_, span, symbol, visible_names());
}

} // namespace rt::lang
