#include "lang/check/checker.hpp"
#include "lang/check/dialects.hpp"
#include "lang/text/suggest.hpp"
#include "lang/values/css_colors.hpp"

#include <fmt/format.h>

namespace rt::lang {

void Checker::open_scope(const Unit* unit, NodeId block, const Owner& owner) {
  scopes_.push_back({static_cast<std::uint32_t>(bindings_.size()), unit, block, owner});
}

void Checker::close_scope() {
  const Scope& scope = scopes_.back();
  for (std::size_t i = scope.first_binding; i < bindings_.size(); ++i) {
    const Binding& binding = bindings_[i];
    if (binding.may_be_property && binding.reads == 0) report_masked_property(binding, scope.owner);
  }
  while (bindings_.size() > scope.first_binding) {
    const Binding& binding = bindings_.back();
    innermost_[static_cast<std::size_t>(binding.name)] = binding.shadowed;
    bindings_.pop_back();
  }
  scopes_.pop_back();
}

void Checker::report_masked_property(const Binding& binding, const Owner& owner) {
  Diagnostic* d = report_.error("E0207", binding.span);
  if (!d) return;
  const bool is_scene = owner.type == &program_.types.scene();
  const std::string whose =
      is_scene ? "the scene" : fmt::format("`{}`", owner.def ? name(owner.def->name) : owner.type->name);
  d->message = fmt::format("`{}` is a name here, and nothing reads it", name(binding.name));
  d->label = fmt::format("to set the property of {}, write `{}: …`", whose, name(binding.name));
}

std::uint32_t Checker::end_activation() {
  const std::uint32_t slots = activations_.back().slots;
  activations_.pop_back();
  return slots;
}

Checker::Binding* Checker::find(Symbol symbol) {
  const auto i = static_cast<std::size_t>(symbol);
  if (i >= innermost_.size() || innermost_[i] == none) return nullptr;
  return &bindings_[innermost_[i]];
}

Checker::Binding* Checker::declare(Symbol symbol, Span span, Binding::What what) {
  const auto i = static_cast<std::size_t>(symbol);
  if (i >= innermost_.size()) innermost_.resize(std::max(i + 1, program_.symbols.size()), none);
  const auto scope = static_cast<std::uint32_t>(scopes_.size());
  if (const Binding* first = find(symbol);
      first && first->scope == scope && what != Binding::What::error && first->what != Binding::What::error) {
    // Functions and nouns are known before the lines of their block are read, so the first may stand behind.
    const bool is_before = first->span.file == span.file && span.begin < first->span.begin;
    const Span one = is_before ? span : first->span;
    if (Diagnostic* d = report_.error("E0202", is_before ? first->span : span)) {
      d->message = fmt::format("`{}` is bound twice in one block", name(symbol));
      d->label = "names never change: choose another one";
      d->notes.push_back({one, fmt::format("first bound here, on line {}", line(one))});
    }
  }
  Binding& binding = bindings_.emplace_back();
  binding.what = what;
  binding.name = symbol;
  binding.span = span;
  binding.scope = scope;
  binding.level = level();
  binding.shadowed = innermost_[i];
  innermost_[i] = static_cast<std::uint32_t>(bindings_.size() - 1);
  return &binding;
}

Checker::Binding* Checker::declare(Unit& unit, NodeId node, Binding::What what) {
  Binding* binding = declare(unit.ast.symbol(node), unit.ast.span(node), what);
  if (what == Binding::What::function) return binding;
  binding->slot = new_slot();
  unit.ast.set_slot(node, binding->slot, pack(Resolution::local, 0));
  return binding;
}

StaticType Checker::resolve(Unit& unit, NodeId node) {
  Binding* binding = find(unit.ast.symbol(node));
  if (top_item_) note_use(unit.ast.symbol(node), binding);
  if (!binding) {
    reads_part_ = false;
    return resolve_global(unit, node);
  }
  ++binding->reads;
  if (binding->use != NameUses::none) program_.uses->read(binding->use, reads_part_ && !is_in_expect_);
  reads_part_ = false;
  const std::size_t depth = level() - binding->level;
  switch (binding->what) {
  case Binding::What::error:
    unit.ast.set_slot(node, 0, pack(Resolution::none, 0));
    break;
  case Binding::What::function:
    unit.ast.set_slot(node, binding->slot, pack(Resolution::function, depth));
    break;
  case Binding::What::value:
  case Binding::What::module:
    unit.ast.set_slot(node, binding->slot, pack(Resolution::local, depth));
    break;
  }
  return binding->known;
}

StaticType Checker::resolve_global(Unit& unit, NodeId node) {
  const std::string_view word = name(unit.ast.symbol(node));
  const auto found = [&](Resolution resolution, std::size_t index) {
    unit.ast.set_slot(node, static_cast<std::uint32_t>(index), pack(resolution, 0));
  };
  StaticType known;
  if (const NodeType* type = program_.types.find(word)) {
    found(Resolution::type, program_.types.index(*type));
    known.what = StaticType::What::thing, known.type = type, known.is_bare_noun = true;
  } else if (const auto builtin = find_builtin(word)) {
    found(Resolution::builtin, *builtin);
    known.what = StaticType::What::builtin, known.builtin = all_builtins()[*builtin];
  } else if (const Constant* constant = find_constant(word)) {
    found(Resolution::constant, static_cast<std::size_t>(constant - constants().data()));
  } else if (const auto choice = std::ranges::find(program_.choices, word); choice != program_.choices.end()) {
    found(Resolution::choice, static_cast<std::size_t>(choice - program_.choices.begin()));
  } else if (const auto color = find_css_color(word)) {
    found(Resolution::color, *color);
  } else {
    found(Resolution::none, 0);
    report_unknown_name(unit, node);
  }
  return known;
}

std::vector<std::string_view> Checker::visible_names() const {
  std::vector<std::string_view> names;
  for (const Binding& binding : bindings_) names.push_back(name(binding.name));
  if (add_further_names_) (*add_further_names_)(names);
  for (const NodeType& type : program_.types.all()) names.push_back(type.name);
  for (const Builtin* builtin : all_builtins()) names.push_back(builtin->name);
  for (const Constant& constant : constants()) names.push_back(constant.name);
  for (const CssColor& color : css_colors()) names.push_back(color.name);
  return names;
}

namespace {

/// Where in a block a name is bound, if it is.
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

void Checker::report_unknown_name(const Unit& unit, NodeId node) {
  if (names_are_missing_) {
    // An error is reported already, for the file that could not be read.
    return;
  }
  const Symbol symbol = unit.ast.symbol(node);
  const std::string_view word = name(symbol);
  const Span span = unit.ast.span(node);
  const auto tell = [&](std::string_view code, std::string message, std::string label, std::optional<Note> note = {}) {
    Diagnostic* d = report_.error(code, span);
    if (!d) return;
    d->message = std::move(message);
    d->label = std::move(label);
    if (note) d->notes.push_back(*std::move(note));
  };
  if (symbol == being_bound_)
    return tell("E0203", fmt::format("`{}` has no value yet: its own line gives it one", word), "not known here",
                is_in_lambda_
                    ? std::optional(Note{std::nullopt,
                                         fmt::format("a function that calls itself is written `fn {}(…) = …`", word)})
                    : std::nullopt);
  for (std::size_t i = scopes_.size(); i-- > 0;) {
    const Scope& scope = scopes_[i];
    if (scope.unit != &unit) continue;
    if (const auto later = bound_in(unit.ast, scope.block, symbol))
      return tell("E0203", fmt::format("`{}` has no value yet: line {} gives it one", word, line(*later)), "too early",
                  Note{*later, "bound here"});
  }
  for (std::size_t i = scopes_.size(); i-- > 0;) {
    const Owner& owner = scopes_[i].owner;
    const bool is_property =
        (owner.def && owner.def->find(symbol) && !owner.is_def_body) || (owner.type && owner.type->find(symbol));
    if (is_property && !find_css_color(word))
      return tell(
          "E0214", fmt::format("`{}` is a property here, not a name", word),
          "a property is not a value to compute with",
          Note{std::nullopt,
               fmt::format("bind a name before the block, `r = …`, and write it in both places: `{}: r`", word)});
  }
  if (const auto inner = bound_in_closed_block(unit.ast, span.begin, symbol))
    return tell(
        "E0215", fmt::format("`{}` is bound inside a block, and known only there", word), "not known here",
        Note{*inner,
             fmt::format("bound here; for a name that depends on a condition, write `{} = if … {{ … }} else {{ … }}`",
                         word)});
  if (const std::string other = dialect_name(word); !other.empty())
    return tell("E0201", fmt::format("there is no `{}` in this language", word), other);
  if (is_define_)
    return tell("E0201", fmt::format("unknown name `{}`", word),
                fmt::format("a string stands in quotes: '\"{}\"'", word));
  const std::vector<std::string_view> names = visible_names();
  const auto guess = nearest(word, names);
  tell("E0201", fmt::format("unknown name `{}`", word),
       guess ? fmt::format("did you mean `{}`?", *guess) : "not known here");
}

} // namespace rt::lang
