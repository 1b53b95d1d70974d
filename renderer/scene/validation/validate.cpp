#include "renderer/scene/validation/validate.hpp"

#include "renderer/scene/validation/media_conflicts.hpp"

#include <fmt/format.h>

#include <array>
#include <set>
#include <utility>

namespace rt::scene {
namespace {

using Kind = Flaw::Kind;

std::string at(std::string_view list, std::size_t index) {
  return fmt::format("{}[{}]", list, index);
}

/// Visits everything reachable once and collects what is wrong.
class Validation {
public:
  explicit Validation(const Scene& scene) : scene_(scene) {
    ShapeKinds::for_each([&]<class S>() {
      if constexpr (!is_composite<S>) seen_shapes_[kind_of<S>].resize(scene.shapes.all<S>().size());
    });
    for (const std::uint32_t kind : {kind_of<Group>, kind_of<Combination>})
      states_[kind].resize(kind == kind_of<Group> ? scene.shapes.all<Group>().size()
                                                  : scene.shapes.all<Combination>().size());
    seen_materials_.resize(scene.materials.size());
    seen_patterns_.resize(scene.patterns.size());
    seen_transforms_.resize(scene.transforms.size());
  }

  void check_settings();
  void check_objects(std::span<const Object> objects);
  void check_tables();

  std::vector<Flaw> flaws;

private:
  enum class State : std::uint8_t { unknown, being_checked, checked };

  // The objects of a list during its traversal. Not recursive: scenes may be nested arbitrarily deep.
  struct ListFrame {
    std::span<const Object> objects;
    std::size_t first;
    ShapeRef owner;
    bool are_operands;
    std::size_t next = 0;
  };

  void add(Kind kind, std::string path, std::string message) {
    flaws.push_back({kind, std::move(path), std::move(message)});
  }
  std::string path() const;

  template <class PathOf>
  void check_fields(std::span<const Field> fields, const void* owner, const PathOf& path_of);
  template <class T, class PathOf>
  bool check_thing(const T& thing, const PathOf& path_of);
  void check_light(const Light& light, std::size_t index);
  void check_object(const Object& object);
  void check_ids(const Object& object);
  bool exists(ShapeRef shape) const;
  template <class S>
  void check_leaf(const S& shape, bool is_seen);
  void enter(ShapeRef composite);
  void check_material(std::size_t index);
  void check_pattern(std::size_t index);
  void check_paints(std::span<const Field> fields, const void* owner, std::size_t patterns, const std::string& where);
  void check_shown(const Field& property, PatternId id, const std::string& where, std::set<PatternId>& seen);
  void check_shown(const Field& property, const Color& color, const std::string& where, std::set<PatternId>& seen);
  void check_placement(const Placement& placement, const std::string& where);
  void check_transform(std::size_t index);

  const Scene& scene_;
  std::vector<ListFrame> frames_;
  std::array<std::vector<char>, ShapeKinds::size> seen_shapes_; // of leaves; not bits, for speed
  std::array<std::vector<State>, ShapeKinds::size> states_;     // of composites
  std::vector<char> seen_materials_, seen_patterns_, seen_transforms_;
  bool has_bad_references_ = false;
};

std::string Validation::path() const {
  std::string text;
  for (const ListFrame& frame : frames_) {
    if (!text.empty()) text += '.';
    const bool is_root = &frame == &frames_.front();
    text += at(is_root ? "objects" : frame.are_operands ? "operands" : "members", frame.first + frame.next - 1);
  }
  return text;
}

std::string joined(const std::string& owner, std::string_view field) {
  if (owner.empty() || field.empty()) return owner + std::string(field);
  return fmt::format("{}.{}", owner, field);
}

template <class PathOf>
void Validation::check_fields(std::span<const Field> fields, const void* owner, const PathOf& path_of) {
  for (const Field& field : fields) {
    const std::optional<Violation> violation = field.check(field, owner);
    if (violation)
      add(Kind::value, joined(path_of(), field.name),
          fmt::format("`{}` {} ({})", field.name, violation->rule, violation->found));
  }
}

template <class T, class PathOf>
bool Validation::check_thing(const T& thing, const PathOf& path_of) {
  const std::size_t before = flaws.size();
  check_fields(fields(static_cast<const T*>(nullptr)), &thing, path_of);
  if (flaws.size() > before) return false; // `check` requires values that satisfy their constraints
  const std::optional<Problem> problem = check(thing);
  if (problem) add(Kind::thing, joined(path_of(), problem->field), problem->message);
  return !problem;
}

void Validation::check_settings() {
  check_thing(scene_, [] { return std::string(); });
  check_thing(scene_.camera, [] { return std::string("camera"); });
  std::size_t skies = 0;
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    check_light(scene_.lights[i], i);
    if (!is_lamp(scene_.lights[i]) && ++skies == 2)
      add(Kind::thing, at("lights", i), "there is already a sky, and a scene has only one");
  }
}

void Validation::check_light(const Light& light, std::size_t index) {
  const std::string where = at("lights", index);
  std::visit([&](const auto& source) { check_thing(source, [&] { return where; }); }, light.source);
  check_placement({{1, 1, 1}, {}, {}, light.chain}, where);
  for (std::size_t i = 0; i < light.enclosing.size(); ++i)
    check_placement(light.enclosing[i], joined(where, at("enclosing", i)));
  if (light.name != no_name && static_cast<std::size_t>(light.name) >= scene_.names.size())
    add(Kind::reference, joined(where, "name"), "there is no such name");
}

void Validation::check_objects(std::span<const Object> objects) {
  const auto first = objects.empty() ? 0 : static_cast<std::size_t>(objects.data() - scene_.objects.data());
  frames_.push_back({objects, first, {}, false});
  while (!frames_.empty()) {
    ListFrame& frame = frames_.back();
    if (frame.next < frame.objects.size()) {
      check_object(frame.objects[frame.next++]);
      continue;
    }
    if (frames_.size() > 1) states_[frame.owner.kind][frame.owner.index] = State::checked;
    frames_.pop_back();
  }
  if (has_bad_references_) return;
  for (const MediaConflict& conflict : media_conflicts(scene_, objects))
    add(Kind::media, at("combinations", conflict.combination),
        fmt::format("the parts of this solid refract differently, and one solid is one medium: `ior` is {} and {}",
                    conflict.first_ior, conflict.second_ior));
}

void Validation::check_object(const Object& object) {
  if (!is_finite(object.at)) add(Kind::value, path() + ".at", "`at` is not a finite number");
  check_ids(object);
  if (!exists(object.shape)) {
    has_bad_references_ = true;
    return add(Kind::reference, path() + ".shape", "there is no such shape");
  }
  if (refers_to_composite(object.shape)) return enter(object.shape);
  char& is_seen = seen_shapes_[object.shape.kind][object.shape.index];
  if (!is_seen || frames_.back().are_operands)
    scene_.shapes.visit(object.shape, [&](const auto& shape) { check_leaf(shape, std::exchange(is_seen, true)); });
}

void Validation::check_ids(const Object& object) {
  if (object.material != no_material) {
    const auto index = static_cast<std::size_t>(object.material);
    if (index < scene_.materials.size()) {
      if (!seen_materials_[index]) check_material(index);
    } else {
      has_bad_references_ = true;
      add(Kind::reference, path() + ".material", "there is no such material");
    }
  }
  if (object.transform != no_transform) {
    const auto index = static_cast<std::size_t>(object.transform);
    if (index < scene_.transforms.size())
      check_transform(index);
    else
      add(Kind::reference, path() + ".transform", "there is no such transform");
  }
  if (object.name != no_name && static_cast<std::size_t>(object.name) >= scene_.names.size())
    add(Kind::reference, path() + ".name", "there is no such name");
}

bool Validation::exists(ShapeRef shape) const {
  if (shape.kind >= ShapeKinds::size) return false;
  return shape.index < (refers_to_composite(shape) ? states_[shape.kind].size() : seen_shapes_[shape.kind].size());
}

template <class S>
void Validation::check_leaf(const S& shape, bool is_seen) {
  if constexpr (!is_composite<S>) {
    if (!is_seen && !check_thing(shape, [&] { return path(); })) return;
    if (frames_.back().are_operands && !check(shape) && !is_solid(geometry(shape)))
      add(Kind::operand, path(), fmt::format("a {} is open: it has no inside, so it cannot be combined", S::noun));
  }
}

void Validation::enter(ShapeRef composite) {
  const bool is_group = composite.kind == kind_of<Group>;
  if (is_group && frames_.back().are_operands)
    add(Kind::operand, path(), "a group is no operand: the union of its members is");
  State& state = states_[composite.kind][composite.index];
  if (state == State::being_checked) {
    has_bad_references_ = true;
    return add(Kind::reference, path(), "it is part of itself");
  }
  if (state == State::checked) return;
  state = State::being_checked;
  if (!is_group) check_thing(scene_.shapes.get<Combination>(composite), [&] { return path(); });
  frames_.push_back({parts(scene_.shapes, composite), 0, composite, !is_group});
}

void Validation::check_material(std::size_t index) {
  if (std::exchange(seen_materials_[index], true)) return;
  const Material& material = scene_.materials[index];
  const std::string where = at("materials", index);
  check_fields(fields(&material), &material, [&] { return where; });
  check_paints(fields(&material), &material, scene_.patterns.size(), where);
}

void Validation::check_pattern(std::size_t index) {
  if (std::exchange(seen_patterns_[index], true)) return;
  const Pattern& pattern = scene_.patterns[index];
  const std::string where = at("patterns", index);
  check_placement(pattern.placement, where);
  std::visit(
      [&](const auto& layout) {
        check_fields(fields(&layout), &layout, [&] { return where; });
        check_paints(fields(&layout), &layout, index, where);
      },
      pattern.layout);
}

/// The patterns that an owner's fields refer to are among the first `patterns`: none contains itself.
void Validation::check_paints(std::span<const Field> fields, const void* owner, std::size_t patterns,
                              const std::string& where) {
  for (const Field& field : fields) {
    for_each_pattern({&field, 1}, owner, [&](PatternId id) {
      if (static_cast<std::size_t>(id) >= patterns)
        return add(Kind::reference, joined(where, field.name), "there is no such pattern before this one");
      check_pattern(static_cast<std::size_t>(id));
      std::set<PatternId> seen;
      if (field.type == FieldType::number) check_shown(field, id, joined(where, field.name), seen);
    });
  }
}

/// What a pattern gives must be what the property would itself accept. For colours all patterns require the same.
void Validation::check_shown(const Field& property, PatternId id, const std::string& where, std::set<PatternId>& seen) {
  if (static_cast<std::size_t>(id) >= scene_.patterns.size() || !seen.insert(id).second) return;
  const auto look_at = [&]<class P>(const P& layout) {
    for (const Field& field : fields(&layout)) {
      const std::optional<FieldValue> value = field.get(&layout);
      const FunctionRef* function = value ? std::get_if<FunctionRef>(&*value) : nullptr;
      if (function && *function && (*function)->results.size() != 1)
        add(Kind::value, where, fmt::format("`{}` takes numbers, and its pattern gives colours", property.name));
      if (const Stops* stops = value ? std::get_if<Stops>(&*value) : nullptr)
        for (const Stop& stop : *stops)
          std::visit([&](const auto& shown) { check_shown(property, shown, where, seen); }, stop.shown);
      if (!value || !field.is_textured) continue;
      if (const PatternId* inner = std::get_if<PatternId>(&*value))
        check_shown(property, *inner, where, seen);
      else
        check_shown(property, std::get<Color>(*value), where, seen);
    }
  };
  std::visit(look_at, scene_.patterns[static_cast<std::size_t>(id)].layout);
}

void Validation::check_shown(const Field& property, const Color& color, const std::string& where,
                             std::set<PatternId>&) {
  if (const auto violation = check(property.constraint, color.r))
    add(Kind::value, where,
        fmt::format("`{}` {} (in its pattern {})", property.name, violation->rule, violation->found));
}

void Validation::check_placement(const Placement& placement, const std::string& where) {
  if (!is_finite(placement.at))
    add(Kind::value, joined(where, "at"), "`at` is not a finite number");
  else if (flattens(placement))
    add(Kind::transform, where, "it flattens, or stretches without end: its determinant is 0 or infinite");
}

void Validation::check_transform(std::size_t index) {
  if (std::exchange(seen_transforms_[index], true)) return;
  if (flattens(scene_.transforms[index])) check_placement(scene_.transforms[index], at("transforms", index));
}

void Validation::check_tables() {
  for (std::size_t i = 0; i < scene_.patterns.size(); ++i) check_pattern(i);
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) check_material(i);
  for (std::size_t i = 0; i < scene_.transforms.size(); ++i) check_transform(i);
}

std::string summary(const std::vector<Flaw>& flaws) {
  std::string text = "the scene is not valid";
  for (const Flaw& flaw : flaws)
    text += fmt::format("\n  {}: {}", flaw.path.empty() ? "scene" : flaw.path, flaw.message);
  return text;
}

} // namespace

std::vector<Flaw> validate(const Scene& scene) {
  Validation validation(scene);
  validation.check_settings();
  validation.check_tables();
  validation.check_objects(scene.objects);
  return std::move(validation.flaws);
}

std::vector<Flaw> validate(const Scene& scene, std::span<const std::span<const Object>> ranges) {
  Validation validation(scene);
  for (const auto& range : ranges) validation.check_objects(range);
  return std::move(validation.flaws);
}

std::vector<Flaw> validate_settings(const Scene& scene) {
  Validation validation(scene);
  validation.check_settings();
  return std::move(validation.flaws);
}

InvalidScene::InvalidScene(std::vector<Flaw> flaws) : std::invalid_argument(summary(flaws)), flaws_(std::move(flaws)) {}

void require_none(std::vector<Flaw> flaws) {
  if (!flaws.empty()) throw InvalidScene(std::move(flaws));
}

const Scene& validated(const Scene& scene) {
  require_none(validate(scene));
  return scene;
}

Affine inverse_of_nested(const Affine& map) {
  if (const std::optional<Affine> found = inverse(map)) return *found;
  throw InvalidScene({{Flaw::Kind::transform, "objects", "the product of nested transforms is singular"}});
}

} // namespace rt::scene
