#include "lang/evaluate/expectation_runner.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/values/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::lang {
namespace {

constexpr double default_tolerance = 1e-9; // absolute, and also relative to the expected value

double tolerance_for(std::optional<double> given, double expected) {
  return given ? *given : default_tolerance + default_tolerance * std::abs(expected);
}

bool are_near(double a, double b, std::optional<double> tolerance) {
  return a == b || std::abs(a - b) <= tolerance_for(tolerance, b);
}

/// Whether two values agree, component by component.
bool are_near(const Value& found, const Value& expected, std::optional<double> tolerance) {
  if (found.is_number() && expected.is_number()) return are_near(found.number(), expected.number(), tolerance);
  if (found.is(ValueKind::color) || expected.is(ValueKind::color)) {
    const auto a = as_color(found), b = as_color(expected);
    return a && b && are_near(a->r, b->r, tolerance) && are_near(a->g, b->g, tolerance) &&
           are_near(a->b, b->b, tolerance);
  }
  if (!is_sequence(found) || !is_sequence(expected)) return equal(found, expected);
  const std::size_t size = sequence_size(expected);
  if (sequence_size(found) != size) return false;
  for (std::size_t i = 0; i < size; ++i) {
    if (!are_near(sequence_at(found, i), sequence_at(expected, i), tolerance)) return false;
  }
  return true;
}

std::string at_t(const Sighting& sighting) {
  return fmt::format("{} at t {:.17g}", sighting.title, sighting.t);
}

bool is_comparison(Op op) {
  return op >= Op::equal && op <= Op::greater_equal;
}

} // namespace

Expectations ExpectationRunner::run(const std::vector<Expectation>& expectations) {
  for (const Expectation& expectation : expectations) {
    limits_.spend(1, expectation.unit->ast.span(expectation.node));
    if (holds(expectation))
      ++outcome_.passed;
    else
      ++outcome_.failed;
  }
  return std::move(outcome_);
}

bool ExpectationRunner::holds(const Expectation& expectation) {
  const ExpectItem item = expectation.unit->ast.expect_item(expectation.node);
  switch (item.claim) {
  case Claim::holds:
    return holds_true(expectation, item);
  case Claim::near:
    return holds_near(expectation, item);
  case Claim::hits:
  case Claim::misses:
    break;
  }
  return holds_sight(expectation, item);
}

void ExpectationRunner::fail_expectation(const Expectation& expectation, std::string message, std::string expected,
                                         std::string found) {
  Diagnostic& d = outcome_.failures.emplace_back(
      errors::expectation_fails(expectation.unit->ast.span(expectation.node), std::move(message)));
  if (!expected.empty()) d.notes.push_back({std::nullopt, "expected " + std::move(expected)});
  if (!found.empty()) d.notes.push_back({std::nullopt, "found " + std::move(found)});
  std::string turn;
  for (const Expectation::LoopVariable& v : expectation.turn)
    turn += fmt::format("{}{} = {}", turn.empty() ? "" : ", ", program_.sources.text(v.name),
                        format(v.value, program_.symbols));
  if (!turn.empty()) d.notes.push_back({std::nullopt, "in the loop iteration with " + turn});
}

bool ExpectationRunner::holds_true(const Expectation& expectation, const ExpectItem& item) {
  const Context context{expectation.unit, expectation.frame.get()};
  bool is_poison = false;
  const bool truth = expressions_.is_true(item.subject, context, is_poison);
  if (truth || is_poison) return truth && !is_poison;
  const Ast& ast = context.ast();
  if (ast.kind(item.subject) != Kind::binary || !is_comparison(ast.op(item.subject))) {
    fail_expectation(expectation, "this is false", {}, {});
    return false;
  }
  const auto side = [&](NodeId node) { return format(expressions_.evaluate(node, context), program_.symbols); };
  const Op op = ast.op(item.subject);
  fail_expectation(
      expectation, "this is false",
      fmt::format("{}{}", op == Op::equal ? "" : fmt::format("{} ", spelling(op)), side(ast.right(item.subject))),
      side(ast.left(item.subject)));
  return false;
}

std::optional<double> ExpectationRunner::tolerance_of(const ExpectItem& item, const Context& context,
                                                      double otherwise) {
  if (item.tolerance == no_node) return otherwise;
  const Value tolerance = expressions_.evaluate(item.tolerance, context);
  if (tolerance.is_number() && tolerance.number() >= 0) return tolerance.number();
  if (!tolerance.is_poison())
    fail(errors::wrong_operand(context.ast().span(item.tolerance), "a tolerance is a number, 0 or more",
                               "this is " + describe(tolerance)));
  return std::nullopt;
}

bool ExpectationRunner::holds_near(const Expectation& expectation, const ExpectItem& item) {
  constexpr double none_given = -1;
  const Context context{expectation.unit, expectation.frame.get()};
  const auto given = tolerance_of(item, context, none_given);
  if (!given) return false;
  const auto tolerance = *given == none_given ? std::nullopt : given;
  precision_ = tolerance;
  const Value found = expressions_.evaluate(item.subject, context),
              expected = expressions_.evaluate(item.other, context);
  precision_.reset();
  if (found.is_poison() || expected.is_poison()) return false;
  if (are_near(found, expected, tolerance)) return true;
  std::string wanted = format(expected, program_.symbols);
  if (tolerance) wanted += fmt::format(" within {}", format_number(*tolerance));
  std::string message = "the values differ";
  if (found.is_number() && expected.is_number())
    message += fmt::format(" by {:.3g}", std::abs(found.number() - expected.number()));
  fail_expectation(expectation, std::move(message), std::move(wanted), format(found, program_.symbols));
  return false;
}

bool ExpectationRunner::holds_sight(const Expectation& expectation, const ExpectItem& item) {
  const Context context{expectation.unit, expectation.frame.get()};
  const Ast& ast = context.ast();
  const Value query = expressions_.evaluate(item.subject, context);
  const Value thing = item.other == no_node ? Value() : expressions_.evaluate(item.other, context);
  const Value t = item.parameter == no_node ? Value() : expressions_.evaluate(item.parameter, context);
  const auto tolerance = tolerance_of(item, context, t.is_number() ? tolerance_for({}, t.number()) : 0);
  if (query.is_poison() || thing.is_poison() || t.is_poison() || !tolerance) return false;
  if (item.other != no_node && !thing.is(ValueKind::thing) && !thing.is(ValueKind::string)) {
    fail(errors::wrong_operand(ast.span(item.other), "what a ray hits is a thing", "this is " + describe(thing)));
    return false;
  }
  if (item.parameter != no_node && !t.is_number()) {
    fail(errors::wrong_operand(ast.span(item.parameter), "`t` is a number", "this is " + describe(t)));
    return false;
  }
  const std::vector<Value>& parts = query.items();
  const Observer* eye = parts.size() > 2 ? observer_of(parts[2], ast.span(item.subject)) : observer();
  if (!eye) return false;
  const std::optional<Sighting> seen = eye->nearest({parts[0].vector(), parts[1].vector()});
  const bool is_it = seen && (item.other == no_node || is_seen(thing, *seen));
  const std::string found = seen ? at_t(*seen) : "nothing";
  const std::string what = item.other == no_node ? "a thing" : name_of(thing, item.other, context);
  if (item.claim == Claim::misses) {
    if (!is_it) return true;
    fail_expectation(expectation, "the ray hits", item.other == no_node ? "nothing" : "anything but " + what, found);
    return false;
  }
  if (is_it && (!t.is_number() || are_near(seen->t, t.number(), tolerance))) return true;
  std::string expected = what;
  if (t.is_number()) expected += fmt::format(" at t {}", format_number(t.number()));
  const char* message = !seen   ? "the ray hits nothing"
                        : is_it ? "the ray hits elsewhere"
                                : "the ray hits something else";
  fail_expectation(expectation, message, std::move(expected), found);
  return false;
}

std::string ExpectationRunner::name_of(const Value& thing, NodeId node, const Context& context) {
  if (thing.is(ValueKind::string)) return fmt::format("`{}`", thing.text());
  return fmt::format("`{}`", program_.sources.text(context.ast().span(node)));
}

// By name if it has one: placed copies have it too, and so do the contents of a composite. Else by
// shape.
bool ExpectationRunner::is_seen(const Value& value, const Sighting& sighting) {
  if (is_alone(value)) { // whatever was hit is part of it
    const bool is_of_it = std::ranges::any_of(single_.scene->objects, [&](const scene::Object& o) {
      return o.shape == sighting.objects.front().shape && o.at == sighting.objects.front().at;
    });
    if (is_of_it) return true;
  }
  scene::NameId wanted = scene::no_name;
  std::optional<scene::ShapeRef> shape;
  if (value.is(ValueKind::string)) {
    wanted = evaluation_.builder.name(value.text());
  } else {
    const Thing& thing = value.thing();
    wanted = writer_.default_name(thing.default_name);
    for (const PropertyValue& p : thing.properties) {
      const bool is_name = (p.id & parameter_bit) == 0 && thing.type->properties[p.id].common == Common::name;
      if (is_name) wanted = evaluation_.builder.name(p.value.text());
    }
    shape = thing.content ? thing.content->shape : thing.shape;
  }
  return std::ranges::any_of(sighting.objects, [&](const scene::Object& object) {
    return wanted != scene::no_name ? object.name == wanted : shape && object.shape == *shape;
  });
}

const Observer* ExpectationRunner::observer() {
  if (!observer_) observer_ = (*make_observer_)(scene_);
  return observer_.get();
}

// Whether this is the thing that was queried alone.
bool ExpectationRunner::is_alone(const Value& thing) const {
  return thing.is(ValueKind::thing) && single_.thing.is(ValueKind::thing) && single_.thing.cell() == thing.cell();
}

// In a scene of its own, because what is queried need not be placed in this one.
const Observer* ExpectationRunner::observer_of(const Value& value, Span place) {
  if (!value.is(ValueKind::thing) || !value.thing().type->is_shape()) {
    fail(errors::wrong_operand(place, "a ray is tested against a shape, a group or a solid",
                               "this is " + describe(value)));
    return nullptr;
  }
  if (is_alone(value)) return single_.observer.get();
  std::vector<scene::Object> objects;
  std::vector<scene::Light> lights;
  Target target;
  target.kind = Target::Kind::scene;
  target.objects = &objects;
  target.lights = &lights;
  blocks_.put(value, place, target);
  std::swap(scene_.objects, objects);
  auto alone = std::make_unique<scene::Scene>(scene_);
  std::swap(scene_.objects, objects);
  single_ = {};
  single_.observer = (*make_observer_)(*alone);
  single_.scene = std::move(alone);
  single_.thing = value;
  return single_.observer.get();
}

void ExpectationRunner::clear() {
  observer_.reset();
  single_ = {};
}

} // namespace rt::lang
