#include "lang/evaluate/evaluator.hpp"

#include <algorithm>

namespace rt::lang {
namespace {

/// Whether a value is put into the scene when it stands on a line of its own; else a session prints it.
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
  library_ = make_frame(heap_, {}, program_.library_frame_size);
  suspects_.push_back(library_);
  run_library();
  main_ = make_frame(heap_, library_, 0);
  suspects_.push_back(main_);
}

// Slots are written once, so functions that were made in the frame before find in it all they may look for.
void Evaluator::begin_input(std::uint32_t slots, const char* stack_limit) {
  stack_limit_ = stack_limit;
  steps_ = next_look_ = objects_ = 0;
  if (slots <= main_->size) return;
  const Ref<Frame> larger = make_frame(heap_, library_, std::max<std::uint32_t>(2 * slots, 256));
  std::copy_n(main_->slots(), main_->size, larger->slots());
  main_ = larger;
  suspects_.push_back(main_);
}

StatementResult Evaluator::run_statement(Unit& unit, std::span<const NodeId> nodes, bool may_print) {
  StatementResult made;
  scene_properties_ = {&program_.types.scene(), nullptr, {}, {}, false};
  camera_place_.reset();
  recursion_ = unsure_ = 0;
  calls_ = nullptr;
  Target target;
  target.kind = Target::Kind::scene;
  target.objects = &made.objects;
  target.lights = &made.lights;
  target.properties = &scene_properties_;
  const Context context{&unit, main_.get()};
  try {
    for (const NodeId node : nodes) {
      if (!may_print || !is_expression(unit.ast.kind(node))) {
        item(node, context, target);
        continue;
      }
      const Value value = expression(node, context);
      if (is_placed(value))
        put(value, unit.ast.span(node), target);
      else
        made.printed = value;
    }
    check_media(made.objects);
  } catch (const Ended&) {
    // A limit was passed, or the evaluation was stopped; either is reported.
  }
  made.properties = std::move(scene_properties_.values);
  if (camera_place_) {
    made.camera = scene_.camera;
    made.camera_place = *camera_place_;
  }
  return made;
}

void Evaluator::try_session_functions() {
  ++unsure_;
  try {
    while (tried_functions_ < program_.functions.size()) try_function(program_.functions[tried_functions_++]);
  } catch (const Ended&) {
    // Reported.
  }
  --unsure_;
}

} // namespace rt::lang
