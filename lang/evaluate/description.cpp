#include "lang/evaluate/description.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace rt::lang {
namespace {

using scene::FieldValue;
using scene::Paint;

std::vector<Vec3> points(const Value& value) {
  std::vector<Vec3> list;
  const std::size_t n = sequence_size(value);
  list.reserve(n);
  for (std::size_t i = 0; i < n; ++i) list.push_back(sequence_at(value, i).vector());
  return list;
}

scene::Choice choice(const Property& property, const Value& value) {
  const auto found = std::ranges::find(property.choices, value.choice());
  return {static_cast<int>(found - property.choices.begin())};
}

Vec3 size(const Value& value) {
  if (value.is_number()) return {value.number(), value.number(), value.number()};
  return value.vector();
}

void add_to(Hasher& h, double v) {
  h.add(v);
}
void add_to(Hasher& h, bool v) {
  h.add(std::uint64_t{v ? 1U : 0U});
}
void add_to(Hasher& h, const Vec3& v) {
  h.add(v);
}
void add_to(Hasher& h, const Color& v) {
  h.add(v);
}
void add_to(Hasher& h, const std::vector<Vec3>& v) {
  for (const Vec3& p : v) h.add(p);
}
void add_to(Hasher& h, scene::Choice v) {
  h.add(static_cast<std::uint64_t>(v.index));
}
void add_to(Hasher& h, const scene::Fade& v) {
  h.add(static_cast<std::uint64_t>(v.law)).add(v.distance);
}
void add_to(Hasher& h, const scene::Resolution& v) {
  h.add(double(v[0])).add(double(v[1]));
}
void add_to(Hasher& h, const Paint& paint) {
  if (const Color* color = std::get_if<Color>(&paint))
    h.add(*color);
  else
    h.add(std::uint64_t{1} << 32 | static_cast<std::uint64_t>(std::get<scene::PatternId>(paint)));
}

std::uint64_t hash_of(const scene::Material& material) {
  Hasher h;
  for (const scene::Field& field : scene::material_fields()) {
    if (const auto value = field.get(&material)) std::visit([&](const auto& v) { add_to(h, v); }, *value);
  }
  return h.value();
}

// The steps hold doubles and nothing else, so they are hashed and compared as such.
template <class S>
constexpr std::size_t doubles_in = sizeof(S) / sizeof(double);

void add_to(Hasher& h, const scene::Step& step) {
  std::visit(
      [&]<class S>(const S& s) {
        static_assert(std::is_trivially_copyable_v<S>);
        std::array<double, doubles_in<S>> numbers;
        std::memcpy(numbers.data(), &s, sizeof numbers);
        for (const double number : numbers) h.add(number);
      },
      step);
}

bool equal(const scene::Placement& a, const scene::Placement& b) {
  if (!(a.scale == b.scale && a.rotate == b.rotate)) return false;
  return std::ranges::equal(a.chain, b.chain, [](const scene::Step& s, const scene::Step& t) {
    return s.index() == t.index() &&
           std::visit([&]<class S>(const S& step) { return std::memcmp(&step, std::get_if<S>(&t), sizeof step) == 0; },
                      s);
  });
}

} // namespace

DescriptionWriter::DescriptionWriter(const SourceMap& sources, scene::Scene& scene)
    : sources_(sources), scene_(scene) {}

FieldValue DescriptionWriter::field_value(const Property& property, const Value& value) {
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
  case PropertyType::paint:
  case PropertyType::number_paint:
    if (is_pattern(value)) return Paint(pattern(value.thing()));
    return Paint(*as_color(value));
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
    attributes_of.name = name(value.text());
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
        const Property& property = thing.type->properties[p.id];
        property.field->set(&made, field_value(property, p.value));
      }
      thing.built = static_cast<std::uint32_t>(add(made));
    }
    return scene::MaterialId{thing.built};
  }
  if (!is_pattern(value)) return plain(*as_color(value));
  scene::Material made;
  made.color = pattern(value.thing());
  return add(made);
}

scene::MaterialId DescriptionWriter::plain(const Color& color) {
  const auto [found, is_new] = plain_.try_emplace(color, static_cast<scene::MaterialId>(scene_.materials.size()));
  if (is_new) scene_.materials.emplace_back().color = color;
  return found->second;
}

scene::MaterialId DescriptionWriter::add(const scene::Material& material) {
  const std::uint64_t h = hash_of(material);
  for (auto [i, end] = materials_.equal_range(h); i != end; ++i) {
    if (scene_.materials[static_cast<std::size_t>(i->second)] == material) return i->second;
  }
  const auto id = static_cast<scene::MaterialId>(scene_.materials.size());
  scene_.materials.push_back(material);
  materials_.emplace(h, id);
  return id;
}

scene::PatternId DescriptionWriter::pattern(const Thing& thing) {
  if (thing.built != 0xffffffff) return scene::PatternId{thing.built};
  scene::Pattern made;
  made.kind = thing.type->pattern;
  ObjectAttributes attributes_of;
  for (const PropertyValue& p : thing.properties) {
    const Property& property = thing.type->properties[p.id];
    if (property.common == Common::none)
      property.field->set(&made, field_value(property, p.value));
    else
      apply(attributes_of, property, p.value);
  }
  made.placement = {attributes_of.scale, attributes_of.rotate, attributes_of.at,
                    thing.chain ? thing.chain->steps : std::vector<scene::Step>{}};
  thing.built = static_cast<std::uint32_t>(scene_.patterns.size());
  scene_.patterns.push_back(std::move(made));
  return scene::PatternId{thing.built};
}

scene::NameId DescriptionWriter::name(std::string_view text) {
  const auto [found, is_new] = names_.try_emplace(std::string(text), static_cast<scene::NameId>(scene_.names.size()));
  if (is_new) scene_.names.emplace_back(text);
  return found->second;
}

std::optional<scene::TransformId> DescriptionWriter::transform(const ObjectAttributes& attributes_of,
                                                               const Chain* chain) {
  const bool has_chain = chain && !chain->steps.empty();
  if (!has_chain && attributes_of.rotate == Vec3{} && attributes_of.scale == Vec3{1, 1, 1}) return scene::no_transform;
  scene::Placement placement{
      attributes_of.scale, attributes_of.rotate, {}, has_chain ? chain->steps : std::vector<scene::Step>{}};
  Hasher h;
  h.add(placement.scale).add(placement.rotate);
  for (const scene::Step& step : placement.chain) add_to(h, step);
  for (auto [i, end] = transforms_.equal_range(h.value()); i != end; ++i) {
    if (equal(scene_.transforms[static_cast<std::size_t>(i->second)], placement)) return i->second;
  }
  const double determinant = scene::matrix(placement).determinant();
  if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
  const auto id = static_cast<scene::TransformId>(scene_.transforms.size());
  scene_.transforms.push_back(std::move(placement));
  transforms_.emplace(h.value(), id);
  return id;
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

scene::ShapeRef DescriptionWriter::united(scene::ShapeRef group) {
  if (group.kind != scene::kind_of<scene::Group>) return group;
  if (const auto found = united_.find(group.index); found != united_.end()) return found->second;
  scene::Combination made{scene::Combination::Operation::unite, scene_.shapes.get<scene::Group>(group).members};
  for (scene::Object& operand : made.operands) operand.shape = united(operand.shape);
  const scene::ShapeRef ref = scene_.shapes.add(std::move(made));
  united_.emplace(group.index, ref);
  return ref;
}

std::string_view DescriptionWriter::open_member(const std::vector<scene::Object>& members) {
  for (const scene::Object& member : members) {
    if (const std::string_view open = open_part(member.shape); !open.empty()) return open;
  }
  return {};
}

std::string_view DescriptionWriter::open_part(scene::ShapeRef shape) {
  const bool is_composite =
      shape.kind == scene::kind_of<scene::Group> || shape.kind == scene::kind_of<scene::Combination>;
  const std::uint64_t key = std::uint64_t{shape.index} << 8 | shape.kind;
  if (is_composite) {
    if (const auto found = open_composites_.find(key); found != open_composites_.end()) return found->second;
  }
  const std::string_view open = scene_.shapes.visit(shape, [&]<class S>(const S& s) -> std::string_view {
    if constexpr (std::is_same_v<S, scene::Group>)
      return open_member(s.members);
    else if constexpr (std::is_same_v<S, scene::Combination>)
      return {}; // its operands were solids when it was made
    else
      return is_solid(geometry(s)) ? std::string_view{} : S::noun;
  });
  if (is_composite) open_composites_.emplace(key, open);
  return open;
}

} // namespace rt::lang
