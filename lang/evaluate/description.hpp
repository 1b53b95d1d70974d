#pragma once

#include "lang/text/hashing.hpp"
#include "lang/values/properties.hpp"
#include "lang/values/thing.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rt::lang {

/// The chain, the material and so on that all shapes have, as they were written for one of them.
struct ObjectAttributes {
  Vec3 at{}, rotate{}, scale{1, 1, 1};
  scene::MaterialId material = scene::no_material;
  scene::NameId name = scene::no_name;
  bool is_visible = true;
  bool casts_shadow = true;
};

/// Puts values into the scene description: materials, patterns, names and turns once each, shapes into their tables.
/// All values must have passed `check_value`.
class DescriptionWriter {
public:
  DescriptionWriter(const SourceMap& sources, scene::Scene& scene);

  /// As the field's `set` takes it.
  scene::FieldValue field_value(const Property& property, const Value& value);
  /// Applies one of the properties that are no field's.
  void apply(ObjectAttributes& attributes_of, const Property& property, const Value& value);

  scene::MaterialId material(const Value& value);
  scene::PatternId pattern(const Thing& pattern);
  scene::NameId name(std::string_view text);
  /// Nothing where the placement flattens: its determinant is 0 or not finite.
  std::optional<scene::TransformId> transform(const ObjectAttributes& attributes_of, const Chain* chain);
  scene::Origin origin(Span span);
  scene::Scene& scene() { return scene_; }

  /// The combination of the members that stands for a group as an operand: their union.
  scene::ShapeRef united(scene::ShapeRef group);
  /// Where a shape is not a solid, or something in it is not: what that is called; empty for solids.
  std::string_view open_part(scene::ShapeRef shape);

private:
  scene::MaterialId plain(const Color& color);
  scene::MaterialId add(const scene::Material& material);
  std::string_view open_member(const std::vector<scene::Object>& members);

  const SourceMap& sources_;
  scene::Scene& scene_;
  std::unordered_multimap<std::uint64_t, scene::MaterialId> materials_;
  struct ColorHash {
    std::size_t operator()(const Color& color) const { return Hasher().add(color).value(); }
  };
  std::unordered_map<Color, scene::MaterialId, ColorHash> plain_; // materials that are a colour and nothing else
  std::unordered_multimap<std::uint64_t, scene::TransformId> transforms_;
  std::unordered_map<std::string, scene::NameId> names_;
  std::unordered_map<std::uint32_t, scene::ShapeRef> united_;           // by index of the group
  std::unordered_map<std::uint64_t, std::string_view> open_composites_; // by kind and index
  Span last_line_; // where `origin` looked last: most things stand in order
  std::uint32_t last_line_number_ = 1;
};

} // namespace rt::lang
