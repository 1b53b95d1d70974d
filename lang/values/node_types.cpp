#include "lang/values/node_types.hpp"

#include "renderer/scene/names.hpp"

#include <utility>

namespace rt::lang {
namespace {

using scene::Field;
using scene::FieldType;

static_assert(static_cast<int>(PropertyType::stops) == static_cast<int>(FieldType::stops));

Property from_field(const Field& f) {
  return {
      f.name, static_cast<PropertyType>(f.type), Common::none, f.form, f.constraint, f.default_text, f.help, f.choices,
      &f};
}

std::vector<Property> from_fields(std::span<const Field> fields) {
  std::vector<Property> properties;
  for (const Field& f : fields) properties.push_back(from_field(f));
  return properties;
}

constexpr scene::Constraint turns_nothing_flat{.is_nonzero = true};

Property at() {
  return {"at", PropertyType::vector, Common::at, 0, {}, "[0, 0, 0]", "position", {}, nullptr};
}
Property rotate() {
  return {"rotate",
          PropertyType::vector,
          Common::rotate,
          0,
          {},
          "[0, 0, 0]",
          "rotation about the x, then the y, then the z axis, degrees",
          {},
          nullptr};
}
Property scale() {
  return {
      "scale", PropertyType::size, Common::scale, 0, turns_nothing_flat, "1", "scale factor, or one for each axis", {},
      nullptr};
}
Property name() {
  return {"name", PropertyType::text, Common::name, 0, {}, "", "name in reports", {}, nullptr};
}

void append_placement(std::vector<Property>& properties) {
  for (const Property& p : {at(), rotate(), scale()}) properties.push_back(p);
}

void append_common(std::vector<Property>& properties) {
  append_placement(properties);
  properties.push_back(
      {"material",
       PropertyType::material,
       Common::material,
       0,
       {},
       "",
       "its surface: a material, a colour or a pattern; inherited from the enclosing composite by default",
       {},
       nullptr});
  properties.push_back(name());
  properties.push_back(
      {"visible", PropertyType::boolean, Common::visible, 0, {}, "true", "false: removed entirely", {}, nullptr});
  properties.push_back({"casts_shadow",
                        PropertyType::boolean,
                        Common::casts_shadow,
                        0,
                        {},
                        "true",
                        "false: light passes through it as if it were not there",
                        {},
                        nullptr});
}

template <class T>
NodeType type_of(std::string_view noun_name, Category category, std::string_view help, const T& prototype) {
  return {noun_name, category, help, from_fields(fields(&prototype)), prototype, {}, {}};
}

template <class S>
NodeType shape_noun() {
  NodeType type = type_of(S::noun, Category::shape, S::help, S{});
  append_common(type.properties);
  return type;
}

template <class L>
NodeType light_noun() {
  NodeType type = type_of(L::noun, Category::light, L::help, L{});
  type.properties.push_back(name());
  return type;
}

NodeType composite_noun(std::string_view noun_name, Category category, std::string_view help,
                        scene::Combination::Operation operation) {
  NodeType type{noun_name, category, help, {}, {}, operation, {}};
  append_common(type.properties);
  return type;
}

template <class P>
NodeType pattern_noun() {
  NodeType type = type_of(P::noun, Category::pattern, P::help, P{});
  append_placement(type.properties);
  return type;
}

} // namespace

NodeTypes::NodeTypes() {
  using Operation = scene::Combination::Operation;
  scene::ShapeKinds::for_each([&]<class S>() {
    if constexpr (!scene::is_composite<S>) nouns_.push_back(shape_noun<S>());
  });
  nouns_.push_back(
      composite_noun(scene::Group::noun, Category::group, "things that are placed together", Operation::unite));
  const auto add_combination = [&](Operation operation, std::string_view help) {
    nouns_.push_back(composite_noun(scene::noun(operation), Category::combination, help, operation));
  };
  add_combination(Operation::unite, "the union of solids, also written a | b");
  add_combination(Operation::intersect, "the intersection of solids, also written a & b");
  add_combination(Operation::subtract, "the first solid without the others, also written a - b");
  nouns_.push_back(
      type_of("material", Category::material, "what a surface and its inside look like", scene::Material{}));
  scene::PatternKinds::for_each([&]<class P>() { nouns_.push_back(pattern_noun<P>()); });
  scene::LightKinds::for_each([&]<class L>() { nouns_.push_back(light_noun<L>()); });
  nouns_.push_back(type_of("camera", Category::camera, "the view of the scene", scene::Camera{}));
  scene_ = {"scene",
            Category::scene,
            "the scene itself: properties at the top level",
            from_fields(fields(static_cast<const scene::Scene*>(nullptr))),
            {},
            {},
            {}};
  group_ = find(scene::Group::noun);
  material_ = find("material");
}

void NodeTypes::intern(SymbolTable& symbols) {
  const auto index_properties = [&](NodeType& type) {
    type.by_symbol.clear();
    for (std::size_t i = 0; i < type.properties.size(); ++i) {
      const auto symbol = static_cast<std::size_t>(symbols.intern(type.properties[i].name));
      if (symbol >= type.by_symbol.size()) type.by_symbol.resize(symbol + 1);
      type.by_symbol[symbol] = static_cast<std::uint8_t>(i + 1);
      if (type.properties[i].type == PropertyType::metal)
        type.properties[i].parts = {symbols.intern("n"), symbols.intern("k")};
      if (type.properties[i].type == PropertyType::absorb)
        type.properties[i].parts = {symbols.intern("color"), symbols.intern("distance")};
    }
  };
  for (NodeType& type : nouns_) index_properties(type);
  index_properties(scene_);
}

const NodeType* NodeTypes::find(std::string_view noun_name) const {
  for (const NodeType& type : nouns_) {
    if (type.name == noun_name) return &type;
  }
  return nullptr;
}

const NodeType& NodeTypes::combination(scene::Combination::Operation operation) const {
  for (const NodeType& type : nouns_) {
    if (type.category == Category::combination && type.operation == operation) return type;
  }
  return nouns_.front(); // unreachable: every operation has its noun
}

std::optional<std::uint16_t> NodeType::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return static_cast<std::uint16_t>(i);
  }
  return std::nullopt;
}

} // namespace rt::lang
