#include "lang/evaluate/evaluate.hpp"

#include "lang/evaluate/deep_stack.hpp"
#include "lang/evaluate/evaluator.hpp"
#include "lang/evaluate/evaluator_loops.hpp"
#include "lang/values/css_colors.hpp"
#include "renderer/scene/compact.hpp"
#include "renderer/scene/defaults.hpp"

#include <fmt/format.h>

namespace rt::lang {

Evaluated evaluate(Program& program, Report& report, const Limits& limits, const std::atomic<bool>* stop,
                   const ObserverMaker& observe) {
  Evaluated result;
  run_on_deep_stack([&](const char* stack_limit) {
    result = Evaluator(program, report, limits, stop, stack_limit).run(observe ? &observe : nullptr);
  });
  return result;
}

Evaluator::Evaluator(Program& program, Report& report, const Limits& limits, const std::atomic<bool>* stop,
                     const char* stack_limit)
    : program_(program), report_(report), limits_(limits), stop_(stop), writer_(program.sources, builder_),
      stack_limit_(stack_limit) {
  scene_properties_.type = &program.types.scene();
}

// What frames hold may refer to them in turn, through functions and the things of defs.
Evaluator::~Evaluator() {
  instances_.clear();
  for (const Ref<Frame>& frame : suspects_) frame->clear();
}

Evaluated Evaluator::run(const ObserverMaker* observe) {
  make_observer_ = observe;
  try {
    run_program();
    if (!report_.has_errors()) finish_scene();
    if (!report_.has_errors()) run_expectations();
    try_unused_functions();
  } catch (const Ended&) {
    // A limit was passed, or the evaluation was stopped from outside; either is reported.
  }
  observer_.reset();
  alone_ = {};
  expectations_.clear();
  loops_.clear();
  return {std::move(scene_), steps_, std::move(outcome_)};
}

namespace {

/// Where the value of an item that binds a name is kept.
std::optional<std::uint32_t> bound_slot(const Ast& ast, NodeId item) {
  switch (ast.kind(item)) {
  case Kind::bind:
    return ast.slot(ast.bind_item(item).name);
  case Kind::use:
    return ast.slot(ast.use_item(item).name);
  case Kind::param:
    return ast.slot(ast.param_item(item).name);
  default:
    return std::nullopt;
  }
}

} // namespace

void Evaluator::run_program() {
  library_ = make_frame(heap_, {}, program_.library_frame_size);
  suspects_.push_back(library_);
  run_library();
  main_ = make_frame(heap_, library_, program_.main_frame_size);
  suspects_.push_back(main_);
  Target target;
  target.kind = Target::Kind::scene;
  target.objects = &scene_.objects;
  target.lights = &scene_.lights;
  target.properties = &scene_properties_;
  file_items(program_.main->ast.root, {program_.main, main_.get()}, target);
}

/// Tells whether it came to its end. Inside a call it is the outermost call that is given up.
template <class F>
bool Evaluator::ends_in_time(F&& run) {
  const bool is_in_call = calls_ != nullptr;
  const int unsure = unsure_;
  try {
    run();
    return true;
  } catch (const TooDeep&) {
    if (is_in_call) throw;
    recursion_ = 0;
    calls_ = nullptr;
    unsure_ = unsure;
    return false;
  }
}

// An item that goes too deep leaves the others to be looked at, so that all mistakes of a file are told.
void Evaluator::file_items(NodeId root, const Context& context, Target& target) {
  const NodeList children = context.ast().children(root);
  for (const NodeId child : children) {
    if (ends_in_time([&] { item(child, context, target); })) continue;
    if (const auto slot = bound_slot(context.ast(), child)) (*context.frame)[*slot] = Value::poison();
  }
}

void Evaluator::run_library() {
  const Context context{program_.library, library_.get()};
  const Ast& ast = context.ast();
  for (const NodeId item : ast.children(ast.root)) {
    declaration(item, context);
    if (ast.kind(item) != Kind::bind) continue;
    const NodeId bound = ast.bind_item(item).name;
    const Value& value = (*library_)[ast.slot(bound)];
    if (!value.is(ValueKind::thing)) continue;
    if (const auto rgb = find_css_color(name(ast.symbol(bound)))) value.thing().css_color = *rgb;
  }
}

Value Evaluator::module_value(const Context& context, NodeId item) {
  const ModuleInfo* info = context.unit->used(item);
  if (!info) return Value::poison();
  for (const auto& [known, value] : modules_) {
    if (known == info) return value;
  }
  const Ref<Frame> frame = make_frame(heap_, library_, info->frame_size);
  suspects_.push_back(frame);
  PropertyBlock properties{&program_.types.scene(), nullptr, {}, {}, false};
  Target target;
  target.kind = Target::Kind::discarded;
  target.properties = &properties;
  file_items(info->unit->ast.root, {info->unit, frame.get()}, target);
  Value module = Ref<Module>(heap_.make<Module>(0, *info, frame));
  modules_.emplace_back(info, module);
  return module;
}

namespace {

/// Whether two values are of one sort: what the command line gives must be what the scene reckons with.
bool are_alike(const Value& a, const Value& b) {
  if (is_sequence(a) && is_sequence(b)) return true;
  if (a.is(ValueKind::thing) && b.is(ValueKind::thing)) return a.thing().type->category == b.thing().type->category;
  return a.kind() == b.kind() || (a.is(ValueKind::color) && as_color(b));
}

} // namespace

Value Evaluator::param_value(const Context& context, NodeId item) {
  const Ast& ast = context.ast();
  const ParamItem param = ast.param_item(item);
  const Value otherwise = expression(param.value, context);
  Value value = otherwise;
  Span place = ast.span(param.value);
  if (const Define* define = context.frame == main_.get() ? program_.find_define(ast.symbol(param.name)) : nullptr) {
    place = define->unit->ast.span(define->unit->ast.root);
    const FrameScope frame(*this, make_frame(heap_, library_, define->frame_size));
    value = expression(define->unit->ast.root, {define->unit, frame.get()});
    if (!value.is_poison() && !otherwise.is_poison() && !are_alike(otherwise, value))
      return fail("E0605", place, fmt::format("`{}` is {} in the scene", name(define->name), describe(otherwise)),
                  "this is " + describe(value));
    if (otherwise.is(ValueKind::color) && !value.is_poison()) value = *as_color(value); // a number is a grey
  }
  return param.range == no_node ? value : within_range(value, place, param, context);
}

Value Evaluator::within_range(const Value& value, Span place, const ParamItem& param, const Context& context) {
  const Ast& ast = context.ast();
  const Value range = expression(param.range, context);
  if (value.is_poison() || range.is_poison()) return value;
  if (!range.is(ValueKind::range))
    return fail("E0304", ast.span(param.range), "the values that a `param` may have are a range",
                "this is " + describe(range));
  if (!value.is_number()) return fail("E0606", place, "only a number can lie in a range", "this is " + describe(value));
  const RangeValue& r = range.range();
  const double low = std::min(r.from, r.to), high = std::max(r.from, r.to), x = value.number();
  const bool is_at_open_end = range.excludes_end() && x == r.to;
  if (x >= low && x <= high && !is_at_open_end) return value;
  if (Diagnostic* d = error("E0606", place)) {
    d->message = fmt::format("`{}` is outside of its range", name(ast.symbol(param.name)));
    d->label = fmt::format("it must be in {}", program_.sources.text(ast.span(param.range)));
    d->notes.push_back({ast.span(param.range), "the range is given here"});
  }
  return Value::poison();
}

void Evaluator::finish_scene() {
  check_media(scene_.objects);
  for (const PropertyValue& p : scene_properties_.values) {
    const Property& property = scene_properties_.type->properties[p.id];
    property.field->set(&scene_, writer_.field_value(property, p.value));
  }
  if (const auto problem = scene::check(scene_)) {
    Span place;
    for (const PropertyValue& p : scene_properties_.values) {
      if (scene_properties_.type->properties[p.id].name == problem->field) place = p.span;
    }
    fail("E0407", place, problem->message, {}, problem->advice);
    return;
  }
  if (has_leftovers_ && expectations_.empty()) compact(scene_); // expectations may ask about what stands nowhere
  for (std::size_t i = 0; i < program_.sources.size(); ++i)
    scene_.files.push_back(program_.sources.file(static_cast<FileId>(i)).name);
  const auto note = [&](std::string_view code, std::string message) {
    if (Diagnostic* d = report_.add(Severity::note, code, {program_.main->ast.file, 0, 0}))
      d->message = std::move(message);
  };
  if (!camera_place_) note("N0001", assume_camera(scene_, finite_bounds(scene_)));
  bool has_ambient = false;
  for (const PropertyValue& p : scene_properties_.values)
    has_ambient |= scene_properties_.type->properties[p.id].name == "ambient";
  if (scene_.lights.empty() && !has_ambient) note("N0002", assume_light(scene_));
}

// What no line calls is run once with values that are not known, so that mistakes in it are found now and not later.
void Evaluator::try_unused_functions() {
  ++unsure_;
  for (std::size_t i = 0; i < program_.functions.size(); ++i)
    ends_in_time([&] { try_function(program_.functions[i]); });
  --unsure_;
}

void Evaluator::try_function(const FunctionInfo& function) {
  if (function.was_run || function.kind == Kind::lambda || !function.is_at_top_level) return;
  Ref<Frame> parent;
  if (!function.module) parent = main_;
  for (const auto& [info, value] : modules_) {
    if (info == function.module) parent = value.module().frame;
  }
  if (!parent) return; // the line that would read its file was not reached
  const FrameScope frame(*this, make_frame(heap_, parent, function.frame_size));
  for (const FunctionInfo::Parameter& parameter : function.parameters) {
    if (parameter.default_value != no_node) expression(parameter.default_value, {function.unit, frame.get()});
    (*frame.get())[parameter.slot] = Value::poison();
  }
  const Context context{function.unit, frame.get()};
  if (function.kind == Kind::fn) {
    expression(function.body, context);
    return;
  }
  PropertyBlock properties{&program_.types.group(), nullptr, {}, {}, false};
  scene::Group nowhere;
  std::vector<scene::Light> no_lights;
  Target target;
  target.kind = Target::Kind::content;
  target.objects = &nowhere.members;
  target.lights = &no_lights;
  target.type = &program_.types.group();
  target.properties = &properties;
  items(function.body, context, target);
}

} // namespace rt::lang
