#include "renderer/scene/builder.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace rt::scene {
namespace {

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
void add_to(Hasher& h, Choice v) {
  h.add(static_cast<std::uint64_t>(v.index));
}
void add_to(Hasher& h, const Fade& v) {
  h.add(static_cast<std::uint64_t>(v.law)).add(v.distance);
}
void add_to(Hasher& h, const Resolution& v) {
  h.add(double(v[0])).add(double(v[1]));
}
void add_to(Hasher& h, const Metal& v) {
  h.add(v.n).add(v.k);
}
void add_to(Hasher& h, const Absorb& v) {
  h.add(v.color).add(v.distance);
}
void add_to(Hasher& h, const FunctionRef& v) {
  h.add(static_cast<std::uint64_t>(v->code.size()));
  for (const double constant : v->constants) h.add(constant);
}
void add_to(Hasher& h, PatternId v) {
  h.add(std::uint64_t{1} << 32 | static_cast<std::uint64_t>(v));
}
void add_to(Hasher& h, const Stops& v) {
  for (const Stop& stop : v) {
    h.add(stop.place);
    std::visit([&](const auto& shown) { add_to(h, shown); }, stop.shown);
  }
}

std::uint64_t hash_of(const Material& material) {
  Hasher h;
  for (const Field& field : fields(&material)) {
    if (const auto value = field.get(&material)) std::visit([&](const auto& v) { add_to(h, v); }, *value);
  }
  return h.value();
}

// The steps consist of doubles only, so they are hashed and compared as such.
template <class S>
constexpr std::size_t doubles_in = sizeof(S) / sizeof(double);

void add_to(Hasher& h, const Step& step) {
  std::visit(
      [&]<class S>(const S& s) {
        static_assert(std::is_trivially_copyable_v<S>);
        std::array<double, doubles_in<S>> numbers;
        std::memcpy(numbers.data(), &s, sizeof numbers);
        for (const double number : numbers) h.add(number);
      },
      step);
}

bool equal(const Placement& a, const Placement& b) {
  if (!(a.scale == b.scale && a.rotate == b.rotate)) return false;
  return std::ranges::equal(a.chain, b.chain, [](const Step& s, const Step& t) {
    return s.index() == t.index() &&
           std::visit([&]<class S>(const S& step) { return std::memcmp(&step, std::get_if<S>(&t), sizeof step) == 0; },
                      s);
  });
}

std::string_view open_kind(const Shapes& shapes, ShapeRef ref) {
  return shapes.visit(ref, []<class S>(const S& shape) -> std::string_view {
    if constexpr (!is_composite<S>)
      if (!is_solid(geometry(shape))) return S::noun;
    return {}; // a combination consists of solids
  });
}

} // namespace

MaterialId Builder::material(const Color& color) {
  const auto [found, is_new] = plain_.try_emplace(color, static_cast<MaterialId>(scene.materials.size()));
  if (is_new) scene.materials.emplace_back().color = color;
  return found->second;
}

MaterialId Builder::material(const Material& material) {
  const Color* color = std::get_if<Color>(&material.color);
  if (!color) return add(material);
  Material plain;
  plain.color = *color;
  return material == plain ? this->material(*color) : add(material);
}

MaterialId Builder::add(const Material& material) {
  const std::uint64_t h = hash_of(material);
  for (auto [i, end] = materials_.equal_range(h); i != end; ++i) {
    if (scene.materials[static_cast<std::size_t>(i->second)] == material) return i->second;
  }
  const auto id = static_cast<MaterialId>(scene.materials.size());
  scene.materials.push_back(material);
  materials_.emplace(h, id);
  return id;
}

PatternId Builder::function_pattern(FunctionRef function) {
  Hasher h;
  add_to(h, function);
  for (auto [i, end] = functions_.equal_range(h.value()); i != end; ++i) {
    const Pattern& known = scene.patterns[static_cast<std::size_t>(i->second)];
    if (*std::get<FunctionPattern>(known.layout).function == *function) return i->second;
  }
  const PatternId id = pattern(Pattern{FunctionPattern{std::move(function)}, {}});
  functions_.emplace(h.value(), id);
  return id;
}

PatternId Builder::pattern(Pattern pattern) {
  scene.patterns.push_back(std::move(pattern));
  return static_cast<PatternId>(scene.patterns.size() - 1);
}

NameId Builder::name(std::string_view text) {
  const auto [found, is_new] = names_.try_emplace(std::string(text), static_cast<NameId>(scene.names.size()));
  if (is_new) scene.names.emplace_back(text);
  return found->second;
}

std::optional<TransformId> Builder::transform(Placement placement) {
  if (placement.chain.empty() && placement.rotate == Vec3{} && placement.scale == Vec3{1, 1, 1}) return no_transform;
  placement.at = {};
  Hasher h;
  h.add(placement.scale).add(placement.rotate);
  for (const Step& step : placement.chain) add_to(h, step);
  for (auto [i, end] = transforms_.equal_range(h.value()); i != end; ++i) {
    if (equal(scene.transforms[static_cast<std::size_t>(i->second)], placement)) return i->second;
  }
  if (flattens(placement)) return std::nullopt;
  const auto id = static_cast<TransformId>(scene.transforms.size());
  scene.transforms.push_back(std::move(placement));
  transforms_.emplace(h.value(), id);
  return id;
}

ShapeRef Builder::group(std::vector<Object> members) {
  return scene.shapes.add(Group{std::move(members)});
}

ShapeRef Builder::combination(Combination::Operation operation, std::vector<Object> operands) {
  for (Object& operand : operands) operand.shape = united(operand.shape);
  return scene.shapes.add(Combination{operation, std::move(operands)});
}

// Groups may be nested arbitrarily deep, so the innermost come first by a list and not by recursion.
template <class Known, class Finish>
void Builder::innermost_first(std::uint32_t group, const Known& known, Finish&& finish) {
  std::vector<std::uint32_t> pending{group};
  while (!pending.empty()) {
    const std::uint32_t index = pending.back();
    const std::size_t count = pending.size();
    if (!known.contains(index)) {
      const std::vector<Object>& members = scene.shapes.all<Group>()[index].members;
      for (auto member = members.rbegin(); member != members.rend(); ++member)
        if (member->shape.kind == kind_of<Group> && !known.contains(member->shape.index))
          pending.push_back(member->shape.index);
      if (pending.size() > count) continue;
      finish(index);
    }
    pending.pop_back();
  }
}

ShapeRef Builder::united(ShapeRef shape) {
  if (shape.kind != kind_of<Group>) return shape;
  innermost_first(shape.index, unions_, [&](std::uint32_t group) {
    std::vector<Object> operands = scene.shapes.all<Group>()[group].members;
    for (Object& operand : operands)
      if (operand.shape.kind == kind_of<Group>) operand.shape = unions_.at(operand.shape.index);
    unions_.emplace(group, scene.shapes.add(Combination{Combination::Operation::unite, std::move(operands)}));
  });
  return unions_.at(shape.index);
}

std::string_view Builder::open_part(ShapeRef shape) {
  if (shape.kind != kind_of<Group>) return open_kind(scene.shapes, shape);
  innermost_first(shape.index, open_parts_, [&](std::uint32_t group) {
    std::string_view open;
    for (const Object& member : scene.shapes.all<Group>()[group].members) {
      open = member.shape.kind == kind_of<Group> ? open_parts_.at(member.shape.index)
                                                 : open_kind(scene.shapes, member.shape);
      if (!open.empty()) break;
    }
    open_parts_.emplace(group, open);
  });
  return open_parts_.at(shape.index);
}

} // namespace rt::scene
