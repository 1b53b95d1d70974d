#include "lang/check/checker.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {

namespace {
constexpr std::size_t top_level_activations = 2; // the library's, and the file's
}

void check(Program& program, Files& files, Report& report) {
  std::vector<std::string> open_files;
  Checker(program, files, report, open_files).check_library();
  for (Define& define : program.defines) Checker(program, files, report, open_files).check_define(define);
  Checker(program, files, report, open_files).check_main();
}

Checker::Checker(Program& program, Files& files, Report& report, std::vector<std::string>& open_files)
    : program_(program), files_(files), report_(report), open_files_(open_files) {}

void Checker::check_library() {
  begin_activation();
  open_scope(nullptr, no_node, {});
  check_items(*program_.library, program_.library->ast.root);
  for (const Binding& binding : bindings_) program_.library_names.push_back({binding.name, binding.slot, binding.span});
  close_scope();
  program_.library_frame_size = end_activation();
}

// The library's names stand around those of each file.
void Checker::declare_library() {
  begin_activation();
  open_scope(nullptr, no_node, {});
  for (const Program::LibraryName& entry : program_.library_names) {
    Binding* binding = declare(entry.name, entry.span, Binding::What::value);
    binding->slot = entry.slot;
    binding->known.what = StaticType::What::thing;
    binding->known.type = &program_.types.material();
  }
}

void Checker::check_define(Define& define) {
  is_define_ = true;
  declare_library();
  begin_activation();
  check_expression(*define.unit, define.unit->ast.root);
  define.frame_size = end_activation();
  close_scope();
}

void Checker::check_main() {
  is_main_ = true;
  Unit& unit = *program_.main;
  is_library_ = program_.uses && places_nothing(unit);
  if (const std::string& path = program_.sources.file(unit.ast.file).path; !path.empty()) open_files_.push_back(path);
  declare_library();
  begin_activation();
  top_scope_ = scopes_.size();
  Owner owner;
  owner.type = &program_.types.scene();
  open_scope(&unit, unit.ast.root, owner);
  check_items(unit, unit.ast.root);
  close_scope();
  program_.main_frame_size = end_activation();
  close_scope();
}

void Checker::check_module(ModuleInfo& module) {
  module_ = &module;
  declare_library();
  begin_activation();
  top_scope_ = scopes_.size();
  Owner owner;
  owner.type = &program_.types.scene();
  open_scope(module.unit, module.unit->ast.root, owner);
  check_items(*module.unit, module.unit->ast.root);
  for (std::size_t i = scopes_.back().first_binding; i < bindings_.size(); ++i) {
    Binding& binding = bindings_[i];
    ++binding.reads; // whoever uses the module may read it
    if (binding.what == Binding::What::error) continue;
    const FunctionInfo* function =
        binding.what == Binding::What::function ? &program_.functions[binding.slot] : nullptr;
    module.exports.push_back({binding.name, binding.slot, function, binding.known.type});
  }
  close_scope();
  module.frame_size = end_activation();
  close_scope();
}

// Names of defs and fns are visible throughout their block, so they are declared before anything else is read.
void Checker::hoist(Unit& unit, NodeId block) {
  for (const NodeId item : unit.ast.children(block)) hoist_item(unit, item);
}

void Checker::hoist_item(Unit& unit, NodeId item) {
  const Kind kind = unit.ast.kind(item);
  if (kind == Kind::def || kind == Kind::fn)
    hoist_function(unit, item);
  else if (kind == Kind::include)
    check_include(unit, item);
}

void Checker::hoist_function(Unit& unit, NodeId item) {
  const Function function = unit.ast.function(item);
  const auto index = static_cast<std::uint32_t>(program_.functions.size());
  FunctionInfo& info = program_.functions.emplace_back();
  info.unit = &unit;
  info.node = item;
  info.kind = unit.ast.kind(item);
  info.name = unit.ast.symbol(function.name);
  info.body = function.body;
  for (const NodeId node : function.parameters) {
    if (unit.ast.kind(node) != Kind::parameter) continue;
    const Parameter parameter = unit.ast.parameter(node);
    info.parameters.push_back({unit.ast.symbol(parameter.name), 0, parameter.default_value, parameter.name});
  }
  info.is_at_top_level = activations_.size() == top_level_activations;
  info.module = module_;
  set_function_index(unit.ast[item], index);
  Binding* binding = declare(unit, function.name, Binding::What::function);
  binding->slot = index;
  binding->use = info.use =
      declare_use(unit, function.name, info.kind == Kind::def ? NameUses::What::def : NameUses::What::fn);
  binding->known.function = &info;
  if (info.kind == Kind::fn) {
    binding->known.what = StaticType::What::function;
  } else {
    binding->known.what = StaticType::What::thing;
    binding->known.type = &program_.types.group();
    binding->known.is_bare_noun = true;
  }
}

void Checker::check_items(Unit& unit, NodeId block) {
  hoist(unit, block);
  for (const NodeId item : unit.ast.children(block)) check_item(unit, item);
}

void Checker::check_block(Unit& unit, NodeId block, const Owner& owner) {
  open_scope(&unit, block, owner);
  check_items(unit, block);
  report_duplicates(unit, block, owner);
  close_scope();
}

void Checker::check_item(Unit& unit, NodeId item) {
  Ast& ast = unit.ast;
  switch (ast.kind(item)) {
  case Kind::error:
    if (const Symbol symbol = ast.error_name(item); symbol != no_symbol)
      declare(symbol, ast.span(item), Binding::What::error);
    return;
  case Kind::include:
    if (Unit* included = unit.included(item)) {
      for (const NodeId inner : included->ast.children(included->ast.root)) check_item(*included, inner);
    }
    return;
  case Kind::use:
    return check_use(unit, item);
  case Kind::param:
    return check_param(unit, item);
  case Kind::def:
  case Kind::fn:
    return check_function_body(unit, item);
  case Kind::for_:
    return check_for(unit, item);
  case Kind::if_:
    return check_if_item(unit, item);
  case Kind::bind:
    return check_bind(unit, item);
  case Kind::property:
    return check_property(unit, item);
  case Kind::expect:
    return check_expect(unit, item);
  case Kind::repeat:
    return check_repeat(unit, ast.repeat(item));
  default:
    check_expression(unit, item);
  }
}

// What is known of the model is known of all; what is wrong with it is told for each.
void Checker::check_repeat(Unit& unit, const Repeat& repeat) {
  const std::pair<const Unit*, NodeId> model{&unit, repeat.model};
  if (repeat.is_first) {
    const std::size_t before = report_.error_count();
    check_item(unit, repeat.model);
    if (report_.error_count() != before) wrong_models_.push_back(model);
  }
  if (std::ranges::find(wrong_models_, model) == wrong_models_.end()) return;
  RepeatSpans spans(report_, program_.sources, unit.ast.model_span(repeat));
  for (std::uint32_t i = 0; i < repeat.count && !report_.is_full(); ++i) {
    spans.stand_for(unit.ast.item_span(repeat, i));
    check_item(unit, repeat.model);
  }
}

void Checker::check_include(Unit& unit, NodeId item) {
  const std::filesystem::path path = files_.find(unit.ast.text(item), unit.ast.span(item));
  Unit* included = nullptr;
  if (!path.empty() && std::ranges::find(open_files_, path.string()) != open_files_.end()) {
    if (Diagnostic* d = report_.error("E0602", unit.ast.span(item))) {
      d->message = "this file is being read already: it would include itself";
      d->label = path.filename().string();
    }
  } else if (!path.empty()) {
    included = files_.read(path, unit.ast.span(item));
  }
  if (!included) {
    names_are_missing_ = true;
    return;
  }
  unit.includes.emplace_back(item, included);
  open_files_.push_back(path.string());
  hoist(*included, included->ast.root);
  open_files_.pop_back();
}

void Checker::check_use(Unit& unit, NodeId item) {
  const ModuleInfo* module = load_module(unit, item);
  Binding* binding = declare(unit, unit.ast.use_item(item).name, module ? Binding::What::module : Binding::What::error);
  if (!module) return;
  binding->use = declare_use(unit, unit.ast.use_item(item).name, NameUses::What::module);
  unit.uses.emplace_back(item, module);
  binding->known.what = StaticType::What::module;
  binding->known.module = module;
}

const ModuleInfo* Checker::load_module(Unit& unit, NodeId item) {
  const Span place = unit.ast.span(item);
  const std::filesystem::path path = files_.find(unit.ast.use_item(item).path, place);
  if (path.empty()) return nullptr;
  if (std::ranges::find(open_files_, path.string()) != open_files_.end()) {
    if (Diagnostic* d = report_.error("E0602", place)) {
      d->message = "this file is being read already: it would use itself";
      d->label = path.filename().string();
    }
    return nullptr;
  }
  for (const ModuleInfo& known : program_.modules) {
    if (known.path == path.string()) return &known;
  }
  Unit* read = files_.read(path, place);
  if (!read) return nullptr;
  ModuleInfo& module = program_.modules.emplace_back();
  module.unit = read;
  module.path = path.string();
  open_files_.push_back(module.path);
  Checker(program_, files_, report_, open_files_).check_module(module);
  open_files_.pop_back();
  return &module;
}

void Checker::check_param(Unit& unit, NodeId item) {
  const ParamItem param = unit.ast.param_item(item);
  if (!is_at_top_level()) {
    if (Diagnostic* d = report_.error("E0216", unit.ast.span(param.name))) {
      d->message = "`param` stands at the top level only";
      d->label = "here it could be bound with `=`";
    }
  }
  const Symbol symbol = unit.ast.symbol(param.name);
  being_bound_ = symbol;
  const std::uint32_t use = declare_use(unit, param.name, NameUses::What::param);
  begin_use(use);
  check_expression(unit, param.value);
  if (param.range != no_node) check_expression(unit, param.range);
  end_use(use);
  being_bound_ = no_symbol;
  if (is_main_) {
    for (Define& define : program_.defines) define.is_used |= define.name == symbol;
    program_.param_names.push_back(symbol);
  }
  Binding* binding = declare(unit, param.name, Binding::What::value);
  binding->use = use;
  if (use != NameUses::none) binding->pi_power = pi_power(unit, param.value);
}

void Checker::check_bind(Unit& unit, NodeId item) {
  const BindItem bind = unit.ast.bind_item(item);
  const Symbol outer = being_bound_;
  being_bound_ = unit.ast.symbol(bind.name);
  is_in_lambda_ = unit.ast.kind(bind.value) == Kind::lambda;
  const std::uint32_t use = declare_use(unit, bind.name, NameUses::What::value);
  begin_use(use);
  StaticType known = check_expression(unit, bind.value);
  end_use(use);
  settle_use(use, known);
  being_bound_ = outer;
  const int factors = use == NameUses::none ? 0 : pi_power(unit, bind.value);
  Binding* binding = declare(unit, bind.name, Binding::What::value);
  binding->use = use;
  binding->pi_power = factors;
  known.is_bare_noun = false;
  binding->known = known;
  const Owner& owner = scopes_.back().owner;
  binding->may_be_property = (owner.type && owner.type->find(binding->name)) ||
                             (owner.def && !owner.is_def_body && owner.def->find(binding->name));
}

void Checker::check_function_body(Unit& unit, NodeId node) {
  FunctionInfo& info = program_.functions[function_index(unit.ast[node])];
  begin_use(info.use);
  begin_activation();
  open_scope(&unit, no_node, {});
  add_parameters(unit, info);
  if (info.kind == Kind::def) {
    Owner owner;
    owner.type = &program_.types.group();
    owner.def = &info;
    owner.is_def_body = true;
    if (unit.ast.kind(info.body) == Kind::block) check_block(unit, info.body, owner);
  } else if (unit.ast.kind(info.body) == Kind::block) {
    check_value_block(unit, info.body, "a function");
  } else {
    check_expression(unit, info.body);
  }
  close_scope();
  info.frame_size = end_activation();
  end_use(info.use);
}

void Checker::add_parameters(Unit& unit, FunctionInfo& info) {
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    FunctionInfo::Parameter& parameter = info.parameters[i];
    const Span span = unit.ast.span(parameter.node);
    if (parameter.default_value != no_node) {
      being_bound_ = parameter.name;
      check_expression(unit, parameter.default_value);
      being_bound_ = no_symbol;
    }
    const bool is_told = info.kind != Kind::lambda; // those of a `fn(…) => …` are often there for their place
    const std::uint32_t use = is_told ? declare_use(unit, parameter.node, NameUses::What::parameter) : NameUses::none;
    Binding* binding = declare(unit, parameter.node, Binding::What::value);
    binding->use = use;
    parameter.slot = binding->slot;
    if (info.kind == Kind::def && program_.types.group().find(parameter.name)) {
      if (Diagnostic* d = report_.error("E0211", span)) {
        d->message = fmt::format("a parameter of a `def` cannot be called `{}`", name(parameter.name));
        d->label = "every thing has a property of that name";
      }
    }
  }
}

void Checker::check_for(Unit& unit, NodeId item) {
  const ForItem loop = unit.ast.for_item(item);
  check_expression(unit, loop.head);
  const int factors = program_.uses ? pi_power(unit, loop.head) : 0;
  const bool has_frame = has_closure(unit, loop.body);
  if (has_frame) begin_activation();
  const Owner owner = scopes_.back().owner;
  open_scope(&unit, no_node, owner);
  if (loop.index_name != no_node) declare(unit, loop.index_name, Binding::What::value);
  declare(unit, loop.value_name, Binding::What::value)->pi_power = factors;
  if (unit.ast.kind(loop.body) == Kind::block) check_block(unit, loop.body, owner);
  close_scope();
  if (has_frame) set_loop_frame(unit, item);
}

void Checker::set_loop_frame(Unit& unit, NodeId node) {
  const std::uint32_t slots = end_activation();
  unit.ast[node].extra = static_cast<std::uint16_t>(std::min(slots, most_loop_slots));
  if (slots <= most_loop_slots) return;
  if (Diagnostic* d = report_.error("E0506", unit.ast.span(node))) d->message = "there are too many names in this loop";
}

// What it says is asked once the scene is whole, so it cannot stand in what may run any number of times, or never.
void Checker::check_expect(Unit& unit, NodeId item) {
  const ExpectItem expect = unit.ast.expect_item(item);
  if (scopes_.back().owner.type != &program_.types.scene()) {
    if (Diagnostic* d = report_.error("E0217", unit.ast.span(item))) {
      d->message = "`expect` stands at the top level, or in a `for` or `if` there";
      d->label = "it is about the scene as a whole";
    }
  }
  is_in_expect_ = true;
  const bool asks_ray = expect.claim == Claim::hits || expect.claim == Claim::misses;
  if (asks_ray && !is_query(unit, expect.subject)) {
    if (Diagnostic* d = report_.error("E0218", unit.ast.span(expect.subject))) {
      d->message = fmt::format("`{}` is said of a ray", spelling(expect.claim));
      d->label = "write `pixel(x, y)`, `image_point(x, y)` or `ray(origin, direction)`";
    }
  }
  for (const NodeId part : {expect.subject, expect.other, expect.parameter, expect.tolerance}) {
    if (part != no_node) check_expression(unit, part);
  }
  is_in_expect_ = false;
}

void Checker::check_if_item(Unit& unit, NodeId item) {
  const IfNode branch = unit.ast.if_node(item);
  const Owner owner = scopes_.back().owner;
  check_expression(unit, branch.condition);
  if (unit.ast.kind(branch.then) == Kind::block) check_block(unit, branch.then, owner);
  if (branch.otherwise == no_node) return;
  if (unit.ast.kind(branch.otherwise) == Kind::if_)
    check_if_item(unit, branch.otherwise);
  else if (unit.ast.kind(branch.otherwise) == Kind::block)
    check_block(unit, branch.otherwise, owner);
}

} // namespace rt::lang
