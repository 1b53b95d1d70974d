#pragma once

#include "lang/values/properties.hpp"
#include "lang/values/thing.hpp"
#include "renderer/scene/builder.hpp"

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rt::lang {

/// The attributes common to all shapes (chain, material and so on), as specified for one of them.
struct ObjectAttributes {
  Vec3 at{}, rotate{}, scale{1, 1, 1};
  scene::MaterialId material = scene::no_material;
  scene::NameId name = scene::no_name;
  bool is_visible = true;
  bool casts_shadow = true;
};

/// Converts values to parts of the scene description. All values must have passed `check_value`.
class DescriptionWriter {
public:
  DescriptionWriter(const SourceMap& sources, scene::Builder& builder);

  /// In the form that the field's `set` takes.
  scene::FieldValue field_value(const Property& property, const Value& value);
  /// Applies a property that is not a field.
  void apply(ObjectAttributes& attributes_of, const Property& property, const Value& value);

  scene::MaterialId material(const Value& value);
  scene::PatternId pattern(const Thing& pattern);
  /// Of a pattern, or a function that stands where one does.
  scene::PatternId pattern(const Value& value);
  /// Nothing where the placement flattens: its determinant is 0 or not finite.
  std::optional<scene::TransformId> transform(const ObjectAttributes& attributes_of, const Chain* chain);
  scene::Origin origin(Span span);

private:
  scene::Stops stops(const Value& value);

  const SourceMap& sources_;
  scene::Builder& builder_;
  Span last_line_; // where `origin` last looked: most things come in order
  std::uint32_t last_line_number_ = 1;
};

} // namespace rt::lang
