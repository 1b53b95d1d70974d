#include "lang/evaluate/evaluator.hpp"

#include <algorithm>

namespace rt::lang {
namespace {

/// Whether a value on a line of its own is added to the scene; else a session prints it.
bool is_placed(const Value& value) {
  if (value.is(ValueKind::list)) return !value.items().empty() && std::ranges::all_of(value.items(), is_placed);
  if (!value.is(ValueKind::thing)) return value.is_poison();
  const NodeType& type = *value.thing().type;
  return type.is_placeable() || type.category == Category::camera;
}

bool is_expression(Kind kind) {
  const bool is_statement = kind == Kind::for_ || kind == Kind::if_ || kind == Kind::property || kind == Kind::repeat;
  return !is_statement && !is_declaration(kind);
}

} // namespace

void Evaluator::begin_session() {
  library_ = evaluation_.frames.keep(make_frame(evaluation_.heap, {}, program_.library_frame_size));
  run_library();
  main_ = evaluation_.frames.keep(make_frame(evaluation_.heap, library_, 0));
}

// Slots are written once, so functions created earlier in the frame find everything they may look for in it.
void Evaluator::begin_input(std::uint32_t slots, const char* stack_limit) {
  evaluation_.limits.restart(stack_limit);
  if (slots <= main_->size) return;
  const Ref<Frame> larger = make_frame(evaluation_.heap, library_, std::max<std::uint32_t>(2 * slots, 256));
  std::copy_n(main_->slots(), main_->size, larger->slots());
  main_ = evaluation_.frames.keep(larger);
}

StatementResult Evaluator::run_statement(Unit& unit, std::span<const NodeId> nodes, bool may_print) {
  StatementResult made;
  scene_properties_ = {&program_.types.scene(), nullptr, {}, {}, false};
  writer_.forget_camera_and_sky();
  Target target;
  target.kind = Target::Kind::scene;
  target.objects = &made.objects;
  target.lights = &made.lights;
  target.properties = &scene_properties_;
  try {
    run_nodes(unit, nodes, may_print, target, made);
    writer_.check_media(made.objects);
  } catch (const LimitGuard::Ended&) {
    // A limit was exceeded, or the evaluation was stopped; either is reported.
  }
  made.properties = std::move(scene_properties_.values);
  if (writer_.camera_place()) {
    made.camera = scene_.camera;
    made.camera_place = *writer_.camera_place();
  }
  made.sky_place = writer_.sky_place();
  return made;
}

void Evaluator::run_nodes(Unit& unit, std::span<const NodeId> nodes, bool may_print, Target& target,
                          StatementResult& made) {
  const Context context{&unit, main_.get()};
  for (const NodeId node : nodes) {
    if (!may_print || !is_expression(unit.ast.kind(node))) {
      blocks_.item(node, context, target);
      continue;
    }
    const std::size_t printed_before = evaluation_.errors.printed_count();
    const Value value = expressions_.evaluate(node, context);
    if (is_placed(value)) {
      blocks_.put(value, unit.ast.span(node), target);
    } else {
      made.printed = value;
      made.is_print = value.is(ValueKind::none) && evaluation_.errors.printed_count() > printed_before;
    }
  }
}

void Evaluator::try_session_functions() {
  const ErrorReporter::Unsure unsure(evaluation_.errors);
  try {
    while (tried_functions_ < program_.functions.size()) try_function(program_.functions[tried_functions_++]);
  } catch (const LimitGuard::Ended&) {
    // Reported.
  }
}

} // namespace rt::lang
