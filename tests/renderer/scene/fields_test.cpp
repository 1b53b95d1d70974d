// The field tables: whatever is set through one can be read back through it.

#include "renderer/scene/scene.hpp"
#include "tests/support/shapes.hpp"

#include <set>

using namespace rt;
using namespace rt::scene;
using rt::tests::Random;

namespace {

double number(Random& random, const Constraint& allowed) {
  const double low = std::max(allowed.min, -100.0), high = std::min(allowed.max, std::max(100.0, low + 10));
  const double value = low + (high - low) * random.between(0.01, 0.99);
  return allowed.is_whole ? std::round(value) : value;
}

Vec3 vector(Random& random, const Constraint& allowed) {
  return {number(random, allowed), number(random, allowed), number(random, allowed)};
}

Color color(Random& random, const Constraint& allowed) {
  const Vec3 v = vector(random, allowed);
  return {v.x, v.y, v.z};
}

std::vector<Vec3> points(Random& random, const Constraint& allowed) {
  std::vector<Vec3> list(static_cast<std::size_t>(std::min(std::max(allowed.min_count, 5), allowed.max_count)));
  for (Vec3& p : list) p = random.vector(-10, 10);
  return list;
}

FieldValue value_for(Random& random, const Field& field) {
  const Constraint& allowed = field.constraint;
  if (field.is_textured && random.bits() % 2 == 0) return PatternId{7};
  switch (field.type) {
  case FieldType::number:
    return number(random, allowed);
  case FieldType::boolean:
    return random.bits() % 2 == 0;
  case FieldType::vector:
  case FieldType::size:
    return vector(random, allowed);
  case FieldType::color:
    return color(random, allowed);
  case FieldType::points:
    return points(random, allowed);
  case FieldType::choice:
    return Choice{static_cast<int>(random.bits() % field.choices.size())};
  case FieldType::fade:
    return Fade{Fade::Law::quadratic, random.between(1, 10)};
  case FieldType::resolution:
    return Resolution{640, 480};
  case FieldType::metal:
    return Metal{{0.2, 0.9, 1.1}, {3, 2, 1}};
  case FieldType::absorb:
    return Absorb{{0.5, 0.6, 0.7}, random.between(1, 10)};
  case FieldType::function:
    return constant_function(random.between(0, 1));
  case FieldType::stops:
    return Stops{{random.between(0, 0.5), PatternId{3}}, {random.between(0.5, 1), color(random, not_negative)}};
  }
  return {};
}

template <class T>
void check_table(std::string_view owner, std::span<const Field> table) {
  INFO(std::string(owner));
  std::set<std::string_view> names;
  Random random(31);
  for (const Field& field : table) {
    INFO(std::string(field.name));
    CHECK(names.insert(field.name).second);
    CHECK_FALSE(field.help.empty());
    CHECK_FALSE(field.help.ends_with('.'));
    CHECK((field.type == FieldType::choice) == !field.choices.empty());
    for (int i = 0; i < 5; ++i) {
      T thing;
      const FieldValue value = value_for(random, field);
      field.set(&thing, value);
      // Shares are kept as colours, so that they may become ones.
      const double* number = std::get_if<double>(&value);
      CHECK((field.get(&thing) == value || (number && field.get(&thing) == FieldValue(grey(*number)))));
    }
  }
  // Setting one leaves the others alone.
  for (const Field& field : table) {
    T thing;
    const T untouched;
    field.set(&thing, value_for(random, field));
    for (const Field& other : table) {
      if (other.name != field.name) CHECK(other.get(&thing) == other.get(&untouched));
    }
  }
}

/// In each form but the first, what is written picks the form: nothing of it has a value before.
template <class T>
void check_forms(std::span<const Field> table) {
  const T fresh;
  for (const Field& field : table) {
    INFO(std::string(field.name));
    if (field.form != 0)
      CHECK_FALSE(field.get(&fresh));
    else
      CHECK(field.get(&fresh));
    if (field.form == 0) CHECK_FALSE(field.default_text.empty());
  }
}

} // namespace

TEST_CASE("fields: every shape's can be set and read back") {
  ShapeKinds::for_each([]<class S>() {
    const S* none = nullptr;
    check_table<S>(S::noun, fields(none));
    check_forms<S>(fields(none));
  });
}

TEST_CASE("fields: those of materials, patterns, lights, the camera and the scene can be set and read back") {
  const auto check_kind = []<class T>() { check_table<T>(T::noun, fields(static_cast<const T*>(nullptr))); };
  LightKinds::for_each(check_kind);
  PatternKinds::for_each(check_kind);
  check_table<Material>("material", fields(static_cast<const Material*>(nullptr)));
  check_table<Camera>("camera", fields(static_cast<const Camera*>(nullptr)));
  check_table<Scene>("scene", fields(static_cast<const Scene*>(nullptr)));
}

TEST_CASE("fields: constraints of the shapes") {
  const auto find = []<class S>(const S*, std::string_view name) {
    for (const Field& field : fields(static_cast<const S*>(nullptr))) {
      if (field.name == name) return field.constraint;
    }
    FAIL("no such field");
    return any_value;
  };
  const auto must_be_positive = [&](const Constraint& c) { return c.min == 0 && c.min_is_excluded; };
  CHECK(must_be_positive(find(static_cast<const Sphere*>(nullptr), "radius")));
  CHECK(must_be_positive(find(static_cast<const Cylinder*>(nullptr), "radius")));
  CHECK(must_be_positive(find(static_cast<const Cylinder*>(nullptr), "height")));
  CHECK(must_be_positive(find(static_cast<const Disc*>(nullptr), "radius")));
  CHECK(must_be_positive(find(static_cast<const Box*>(nullptr), "size")));
  CHECK(must_be_positive(find(static_cast<const Quad*>(nullptr), "size")));
  const Constraint top = find(static_cast<const Cone*>(nullptr), "top_radius");
  CHECK((top.min == 0 && !top.min_is_excluded));
  CHECK(find(static_cast<const Plane*>(nullptr), "normal").is_nonzero);
  CHECK(find(static_cast<const Cylinder*>(nullptr), "axis").is_nonzero);
  CHECK(find(static_cast<const Disc*>(nullptr), "normal").is_nonzero);
  CHECK(find(static_cast<const Triangle*>(nullptr), "points").min_count == 3);
  CHECK(find(static_cast<const Triangle*>(nullptr), "points").max_count == 3);
  CHECK(find(static_cast<const Quad*>(nullptr), "points").min_count == 4);
  CHECK(find(static_cast<const Polygon*>(nullptr), "points").min_count == 3);
}

TEST_CASE("camera: where `up` is parallel to the view, one that is not is advised") {
  const auto advice = [](const Camera& camera) {
    const auto problem = check(camera);
    REQUIRE(problem);
    CHECK(problem->field == "up");
    return problem->advice;
  };
  CHECK(advice({.at = {0, 9, 0}}) == "write another direction, for instance `up: [0, 0, -1]`");
  CHECK_FALSE(check(Camera{.at = {0, 9, 0}, .up = {0, 0, -1}}));
  CHECK(advice({.at = {0, 0, 9}, .up = {0, 0, 2}}) == "write another direction, for instance `up: [0, 1, 0]`");
  CHECK_FALSE(check(Camera{.at = {0, 0, 9}, .up = {0, 1, 0}}));
}
