#include "lang/evaluate/things/description.hpp"

#include <algorithm>

namespace rt::lang {
namespace {

using scene::FieldValue;

std::vector<Vec3> points(const Value& value) {
  std::vector<Vec3> list;
  const std::size_t n = sequence_size(value);
  list.reserve(n);
  for (std::size_t i = 0; i < n; ++i) list.push_back(sequence_at(value, i).vector());
  return list;
}

scene::Choice choice(const Property& property, const Value& value) {
  const auto found = std::ranges::find(property.choices, as_choice(value).value());
  return {static_cast<int>(found - property.choices.begin())};
}

Vec3 size(const Value& value) {
  if (value.is_number()) return {value.number(), value.number(), value.number()};
  return value.vector();
}

} // namespace

DescriptionWriter::DescriptionWriter(const SourceMap& sources, scene::Builder& builder)
    : sources_(sources), builder_(builder) {}

FieldValue DescriptionWriter::field_value(const Property& property, const Value& value) {
  if (property.is_textured() && (is_pattern(value) || is_function(value))) return pattern(value);
  switch (property.type) {
  case PropertyType::number:
    return value.number();
  case PropertyType::boolean:
    return value.truth();
  case PropertyType::vector:
    return value.vector();
  case PropertyType::size:
    return size(value);
  case PropertyType::color:
    return *as_color(value);
  case PropertyType::points:
    return points(value);
  case PropertyType::choice:
    return choice(property, value);
  case PropertyType::fade:
    return value.is(ValueKind::none) ? scene::Fade{} : value.fade();
  case PropertyType::resolution: {
    const Vec3& v = value.vector();
    return scene::Resolution{static_cast<int>(v.x), static_cast<int>(v.y)};
  }
  case PropertyType::metal:
  case PropertyType::absorb:
    return *as_parts(property, value);
  case PropertyType::function:
    return value.closure().compiled;
  case PropertyType::stops:
    return stops(value);
  case PropertyType::material:
  case PropertyType::text:
    break; // no field is of these types
  }
  return 0.0;
}

void DescriptionWriter::apply(ObjectAttributes& attributes_of, const Property& property, const Value& value) {
  switch (property.common) {
  case Common::at:
    attributes_of.at = value.vector();
    break;
  case Common::rotate:
    attributes_of.rotate = value.vector();
    break;
  case Common::scale:
    attributes_of.scale = size(value);
    break;
  case Common::material:
    attributes_of.material = material(value);
    break;
  case Common::name:
    attributes_of.name = builder_.name(value.text());
    break;
  case Common::visible:
    attributes_of.is_visible = value.truth();
    break;
  case Common::casts_shadow:
    attributes_of.casts_shadow = value.truth();
    break;
  case Common::none:
    break;
  }
}

scene::MaterialId DescriptionWriter::material(const Value& value) {
  if (value.is(ValueKind::thing) && value.thing().type->category == Category::material) {
    const Thing& thing = value.thing();
    if (thing.built == 0xffffffff) {
      scene::Material made;
      for (const PropertyValue& p : thing.properties) {
        if (p.value.is_poison()) continue; // an error that was reported
        const Property& property = thing.type->properties[p.id];
        property.field->set(&made, field_value(property, p.value));
      }
      thing.built = static_cast<std::uint32_t>(builder_.material(made));
    }
    return scene::MaterialId{thing.built};
  }
  if (!is_pattern(value) && !is_function(value)) return builder_.material(*as_color(value));
  scene::Material made;
  made.color = pattern(value);
  return builder_.material(made);
}

scene::PatternId DescriptionWriter::pattern(const Thing& thing) {
  if (thing.built != 0xffffffff) return scene::PatternId{thing.built};
  scene::Pattern made;
  Prototype layout = thing.type->prototype;
  ObjectAttributes attributes_of;
  for (const PropertyValue& p : thing.properties) {
    if (p.value.is_poison()) continue;
    const Property& property = thing.type->properties[p.id];
    if (property.common == Common::none)
      property.field->set(owner(layout), field_value(property, p.value));
    else
      apply(attributes_of, property, p.value);
  }
  made.layout = narrowed<scene::PatternLayout>(layout);
  made.placement = {attributes_of.scale, attributes_of.rotate, attributes_of.at,
                    thing.chain ? thing.chain->steps : std::vector<scene::Step>{}};
  thing.built = static_cast<std::uint32_t>(builder_.pattern(std::move(made)));
  return scene::PatternId{thing.built};
}

scene::PatternId DescriptionWriter::pattern(const Value& value) {
  return is_function(value) ? builder_.function_pattern(value.closure().compiled) : pattern(value.thing());
}

scene::Stops DescriptionWriter::stops(const Value& value) {
  scene::Stops list;
  for (std::size_t i = 0; i < sequence_size(value); ++i) {
    const StopParts stop = *as_stop(sequence_at(value, i));
    const std::optional<Color> color = as_color(stop.shown);
    list.push_back({stop.place, color ? scene::Paint(*color) : pattern(stop.shown)});
  }
  return list;
}

std::optional<scene::TransformId> DescriptionWriter::transform(const ObjectAttributes& attributes_of,
                                                               const Chain* chain) {
  return builder_.transform(
      {attributes_of.scale, attributes_of.rotate, {}, chain ? chain->steps : std::vector<scene::Step>{}});
}

scene::Origin DescriptionWriter::origin(Span span) {
  const bool is_in_last_line =
      span.file == last_line_.file && span.begin >= last_line_.begin && span.begin < last_line_.end;
  if (!is_in_last_line) {
    const std::vector<std::uint32_t>& starts = sources_.file(span.file).line_starts;
    const bool is_next = span.file == last_line_.file && last_line_number_ < starts.size() &&
                         span.begin >= starts[last_line_number_] &&
                         (last_line_number_ + 1 == starts.size() || span.begin < starts[last_line_number_ + 1]);
    if (is_next)
      ++last_line_number_;
    else
      last_line_number_ = static_cast<std::uint32_t>(
          std::max<std::ptrdiff_t>(1, std::ranges::upper_bound(starts, span.begin) - starts.begin()));
    const std::uint32_t end = last_line_number_ < starts.size() ? starts[last_line_number_] : 0xffffffff;
    last_line_ = {span.file, starts[last_line_number_ - 1], end};
  }
  return {span.file, last_line_number_};
}

} // namespace rt::lang
