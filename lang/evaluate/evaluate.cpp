#include "lang/evaluate/evaluate.hpp"

#include "lang/evaluate/deep_stack.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/evaluator.hpp"
#include "lang/values/css_colors.hpp"
#include "renderer/scene/compact.hpp"
#include "renderer/scene/defaults.hpp"

#include <fmt/format.h>

#include <algorithm>

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
    : evaluation_(program, report, limits, stop, stack_limit), program_(program), report_(report),
      scene_(evaluation_.builder.scene), writer_(evaluation_), expressions_(evaluation_, *this),
      blocks_(evaluation_, expressions_, things_, expectation_list_),
      things_(evaluation_, expressions_, blocks_, writer_), expectations_(evaluation_, expressions_, blocks_, writer_) {
  scene_properties_.type = &program.types.scene();
}

Evaluated Evaluator::run(const ObserverMaker* observe) {
  Expectations outcome;
  if (observe) {
    expectation_list_.want();
    expectations_.use(*observe);
  }
  try {
    run_program();
    if (!report_.has_errors()) finish_scene();
    if (!report_.has_errors()) outcome = expectations_.run(expectation_list_.all());
    try_unused_functions();
  } catch (const LimitGuard::Ended&) {
    // A limit was exceeded, or the evaluation was stopped from outside; either is reported.
  }
  expectations_.clear();
  expectation_list_.clear();
  return {std::move(scene_), evaluation_.limits.steps(), std::move(outcome), evaluation_.errors.take_printed()};
}

void Evaluator::run_program() {
  library_ = evaluation_.frames.keep(make_frame(evaluation_.heap, {}, program_.library_frame_size));
  run_library();
  main_ = evaluation_.frames.keep(make_frame(evaluation_.heap, library_, program_.main_frame_size));
  Target target;
  target.kind = Target::Kind::scene;
  target.objects = &scene_.objects;
  target.lights = &scene_.lights;
  target.properties = &scene_properties_;
  blocks_.file_items(program_.main->ast.root, {program_.main, main_.get()}, target);
}

void Evaluator::run_library() {
  const Context context{program_.library, library_.get()};
  const Ast& ast = context.ast();
  for (const NodeId item : ast.children(ast.root)) {
    expressions_.declare(item, context);
    if (ast.kind(item) != Kind::bind) continue;
    const NodeId bound = ast.bind_item(item).name;
    const Value& value = (*library_)[ast.slot(bound)];
    if (!value.is(ValueKind::thing)) continue;
    if (const auto rgb = find_css_color(evaluation_.errors.name(ast.symbol(bound)))) value.thing().css_color = *rgb;
  }
}

Value Evaluator::module_value(const Context& context, NodeId item) {
  const ModuleInfo* info = context.unit->used(item);
  if (!info) return Value::poison();
  for (const auto& [known, value] : modules_) {
    if (known == info) return value;
  }
  const Ref<Frame> frame = evaluation_.frames.keep(make_frame(evaluation_.heap, library_, info->frame_size));
  PropertyBlock properties{&program_.types.scene(), nullptr, {}, {}, false};
  Target target;
  target.kind = Target::Kind::discarded;
  target.properties = &properties;
  blocks_.file_items(info->unit->ast.root, {info->unit, frame.get()}, target);
  Value module = Ref<Module>(evaluation_.heap.make<Module>(0, *info, frame));
  modules_.emplace_back(info, module);
  return module;
}

namespace {

/// Whether two values are of the same kind: a value from the command line must match what the scene expects.
bool are_alike(const Value& a, const Value& b) {
  if (is_sequence(a) && is_sequence(b)) return true;
  if (a.is(ValueKind::thing) && b.is(ValueKind::thing)) return a.thing().type->category == b.thing().type->category;
  return a.kind() == b.kind() || (a.is(ValueKind::color) && as_color(b));
}

} // namespace

Value Evaluator::param_value(const Context& context, NodeId item) {
  const Ast& ast = context.ast();
  const ParamItem param = ast.param_item(item);
  const Value otherwise = expressions_.evaluate(param.value, context);
  Value value = otherwise;
  Span place = ast.span(param.value);
  if (const Define* define = context.frame == main_.get() ? program_.find_define(ast.symbol(param.name)) : nullptr) {
    place = define->unit->ast.span(define->unit->ast.root);
    const FrameScope frame(evaluation_.frames, make_frame(evaluation_.heap, library_, define->frame_size));
    value = expressions_.evaluate(define->unit->ast.root, {define->unit, frame.get()});
    if (!value.is_poison() && !otherwise.is_poison() && !are_alike(otherwise, value))
      return evaluation_.errors.fail(errors::wrong_define(
          place, fmt::format("`{}` is {} in the scene", evaluation_.errors.name(define->name), describe(otherwise)),
          "this is " + describe(value)));
    if (otherwise.is(ValueKind::color) && !value.is_poison()) value = *as_color(value); // a number is a grey
  }
  return param.range == no_node ? value : within_range(value, place, param, context);
}

Value Evaluator::within_range(const Value& value, Span place, const ParamItem& param, const Context& context) {
  const Ast& ast = context.ast();
  const Value range = expressions_.evaluate(param.range, context);
  if (value.is_poison() || range.is_poison()) return value;
  if (!range.is(ValueKind::range))
    return evaluation_.errors.fail(errors::wrong_operand(
        ast.span(param.range), "the values that a `param` may have are a range", "this is " + describe(range)));
  if (!value.is_number())
    return evaluation_.errors.fail(
        errors::param_out_of_range(place, "only a number can have a range", "this is " + describe(value)));
  const RangeValue& r = range.range();
  const double low = std::min(r.from, r.to), high = std::max(r.from, r.to), x = value.number();
  const bool is_at_open_end = range.excludes_end() && x == r.to;
  if (x >= low && x <= high && !is_at_open_end) return value;
  Diagnostic error = errors::param_out_of_range(
      place, fmt::format("`{}` is out of range", evaluation_.errors.name(ast.symbol(param.name))),
      fmt::format("it must be in {}", program_.sources.text(ast.span(param.range))));
  error.notes.push_back({ast.span(param.range), "the range is given here"});
  return evaluation_.errors.fail(std::move(error));
}

void Evaluator::finish_scene() {
  writer_.check_media(scene_.objects);
  if (!set_scene_properties()) return;
  // Expectations may ask about what stands nowhere.
  if (evaluation_.may_have_unused && expectation_list_.all().empty()) compact(scene_);
  for (std::size_t i = 0; i < program_.sources.size(); ++i)
    scene_.files.push_back(program_.sources.file(static_cast<FileId>(i)).name);
  const Span whole_scene{program_.main->ast.file, 0, 0};
  if (!writer_.camera_place())
    report_.add(errors::assumed_camera(whole_scene, assume_camera(scene_, finite_bounds(scene_))));
  const bool has_ambient = std::ranges::any_of(scene_properties_.values, [&](const PropertyValue& p) {
    return scene_properties_.type->properties[p.id].name == "ambient";
  });
  if (lacks_light(scene_, has_ambient)) report_.add(errors::assumed_light(whole_scene, assume_light(scene_)));
}

bool Evaluator::set_scene_properties() {
  const std::vector<Property>& properties = scene_properties_.type->properties;
  for (const PropertyValue& p : scene_properties_.values) properties[p.id].field->set(&scene_, scene_value(p));
  const auto problem = scene::check(scene_);
  if (!problem) return true;
  Span place;
  for (const PropertyValue& p : scene_properties_.values)
    if (properties[p.id].name == problem->field) place = p.span;
  evaluation_.errors.fail(errors::properties_disagree(place, problem->message, {}, problem->advice));
  return false;
}

// Code that nothing calls is run once with unknown values, so that errors in it are found now rather than later.
void Evaluator::try_unused_functions() {
  const ErrorReporter::Unsure unsure(evaluation_.errors);
  for (std::size_t i = 0; i < program_.functions.size(); ++i)
    blocks_.ends_in_time([&] { try_function(program_.functions[i]); });
}

void Evaluator::try_function(const FunctionInfo& function) {
  if (function.was_run || function.kind == Kind::lambda || !function.is_at_top_level) return;
  Ref<Frame> parent;
  if (!function.module) parent = main_;
  for (const auto& [info, value] : modules_) {
    if (info == function.module) parent = value.module().frame;
  }
  if (!parent) return; // the line that would read its file was not reached
  const FrameScope frame(evaluation_.frames, make_frame(evaluation_.heap, parent, function.frame_size));
  for (const FunctionInfo::Parameter& parameter : function.parameters) {
    if (parameter.default_value != no_node)
      expressions_.evaluate(parameter.default_value, {function.unit, frame.get()});
    (*frame.get())[parameter.slot] = Value::poison();
  }
  try_body(function, {function.unit, frame.get()});
}

void Evaluator::try_body(const FunctionInfo& function, const Context& context) {
  if (function.kind == Kind::fn) {
    expressions_.evaluate(function.body, context);
    return;
  }
  PropertyBlock properties{&program_.types.group(), nullptr, {}, {}, false};
  Content nowhere;
  Target target = target_for(nowhere, program_.types.group(), {});
  target.properties = &properties;
  blocks_.items(function.body, context, target);
}

Value Evaluator::declared_value(NodeId item, const Context& context) {
  return context.ast().kind(item) == Kind::use ? module_value(context, item) : param_value(context, item);
}

} // namespace rt::lang
