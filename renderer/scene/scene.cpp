#include "renderer/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace rt::scene {
namespace {

/// A value of type T for each group and combination that is visited: few, if one object of many is queried.
template <class T>
class PerComposite {
public:
  T& operator[](ShapeRef ref) { return values_[key(ref)]; }
  const T& at(ShapeRef ref) const { return values_.at(key(ref)); }

private:
  static std::uint64_t key(ShapeRef ref) { return std::uint64_t{ref.index} << 8 | ref.kind; }
  std::unordered_map<std::uint64_t, T> values_;
};

/// The composites below `roots`, each once, each after those it consists of. Not recursive: scenes may be nested
/// arbitrarily deep.
std::vector<ShapeRef> innermost_first(const Scene& scene, std::span<const Object> roots) {
  struct Visit {
    std::span<const Object> objects;
    std::size_t next = 0;
    ShapeRef owner;
  };
  std::vector<ShapeRef> order;
  PerComposite<bool> is_found;
  std::vector<Visit> path{{roots, 0, {}}};
  while (true) {
    Visit& visit = path.back();
    if (visit.next == visit.objects.size()) {
      if (path.size() == 1) return order;
      order.push_back(visit.owner);
      path.pop_back();
      continue;
    }
    const ShapeRef shape = visit.objects[visit.next++].shape;
    if (!refers_to_composite(shape) || is_found[shape]) continue;
    is_found[shape] = true;
    path.push_back({parts(scene.shapes, shape), 0, shape});
  }
}

/// The extent of a thing, and of what is finite in it: a sphere beside a plane in a group counts for the latter.
struct Extents {
  Box3 whole, finite;

  void extend(const Extents& e) { whole.extend(e.whole), finite.extend(e.finite); }
};

Extents extents_of(const Box3& box) {
  return {box, box.is_finite() ? box : Box3{}};
}

Extents mapped(const Affine& map, const Extents& e) {
  return {transform_box(map, e.whole), transform_box(map, e.finite)};
}

using CompositeExtents = PerComposite<Extents>;

/// In the parent's space.
Extents extents(const Scene& scene, const Object& object, const CompositeExtents& known) {
  const Affine map = to_parent(scene, object);
  if (refers_to_composite(object.shape)) return mapped(map, known.at(object.shape));
  return scene.shapes.visit(object.shape, [&]<class S>(const S& shape) {
    if constexpr (is_composite<S>)
      return Extents{};
    else
      return extents_of(bounds(geometry(shape), map));
  });
}

Extents group_extents(const Scene& scene, std::span<const Object> members, const CompositeExtents& known) {
  Extents all;
  for (const Object& member : members) {
    if (member.is_visible) all.extend(extents(scene, member, known));
  }
  return all;
}

/// A difference lies within its first operand, an intersection within each.
Extents combination_extents(const Scene& scene, const Combination& combination, const CompositeExtents& known) {
  const auto& operands = combination.operands;
  if (combination.operation == Combination::Operation::unite) return group_extents(scene, operands, known);
  if (operands.empty()) return {};
  if (combination.operation == Combination::Operation::subtract)
    return group_extents(scene, std::span(operands).first(1), known);
  std::optional<Box3> common; // of the visible parts
  for (const Object& operand : operands) {
    if (!operand.is_visible) continue;
    const Box3 box = extents(scene, operand, known).whole;
    common = common ? overlap(*common, box) : box;
  }
  return extents_of(common.value_or(Box3{}));
}

CompositeExtents composite_extents(const Scene& scene, std::span<const Object> roots) {
  CompositeExtents known;
  for (const ShapeRef ref : innermost_first(scene, roots)) {
    known[ref] = ref.kind == kind_of<Group> ? group_extents(scene, scene.shapes.get<Group>(ref).members, known)
                                            : combination_extents(scene, scene.shapes.get<Combination>(ref), known);
  }
  return known;
}

Extents scene_extents(const Scene& scene) {
  return group_extents(scene, scene.objects, composite_extents(scene, scene.objects));
}

std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b) {
  return a > std::numeric_limits<std::uint64_t>::max() - b ? std::numeric_limits<std::uint64_t>::max() : a + b;
}

} // namespace

std::string place_text(const Scene& scene, Origin origin) {
  if (origin.line == 0 || origin.file >= scene.files.size()) return {};
  return scene.files[origin.file] + ':' + std::to_string(origin.line);
}

std::span<const Field> fields(const Scene*) {
  static constexpr std::string_view tone_choices[] = {"clip", "filmic"};
  static constexpr Constraint stops{.min = -32, .max = 32};
  static constexpr Constraint pixels{.min = 1, .max = 65536, .is_whole = true};
  static constexpr Constraint depth{.min = 0, .max = 1000, .is_whole = true};
  static constexpr Constraint count{.min = 1, .max = most_samples, .is_whole = true};
  static constexpr Constraint share{.min = 0, .max = 1};
  static constexpr Constraint number{.min = 0, .max = std::numeric_limits<int>::max(), .is_whole = true};
  static constexpr std::string_view filters[] = {"box", "gaussian", "blackman_harris"};
  static constexpr Field table[] = {
      field<&Scene::size>("size", {"[800, 600]", "width and height of the picture in pixels", pixels}),
      field<&Scene::background>("background", {"black", "colour of a ray that hits nothing", not_negative}),
      field<&Scene::ambient>("ambient", {"0.1", "uniform ambient light", not_negative}),
      field<&Scene::mode>("mode", {.default_text = "whitted",
                                   .help = "rendering mode: whitted; path (path tracing: soft shadows, indirect "
                                           "light); or occlusion (ambient occlusion)",
                                   .choices = mode_names}),
      field<&Scene::max_depth>(
          "max_depth",
          {"8", "maximum number of reflections and refractions; in path mode of all scattering (64)", depth}),
      field<&Scene::samples>(
          "samples",
          {"1", "samples per pixel, a square number for a regular grid; in path mode any number (64)", count}),
      field<&Scene::noise>(
          "noise",
          {"none", "in path mode: target noise level; sampling continues until it is reached, up to `samples` (65536)",
           positive}),
      field<&Scene::seed>("seed", {"0", "in path mode: random seed; a different one gives different noise", number}),
      field<&Scene::filter>("filter", {.default_text = "blackman_harris",
                                       .help = "in path mode: pixel filter (box: no overlap between pixels)",
                                       .choices = filters}),
      field<&Scene::reach>("reach", {"infinite", "in occlusion mode: maximum distance of occluders", positive}),
      field<&Scene::min_weight>(
          "min_weight",
          {"0.001953125",
           "in whitted mode: how much all the weak rays that are not traced may change a pixel, as a fraction of white",
           share}),
      field<&Scene::exposure>("exposure", {"0", "exposure compensation for 8- and 16-bit pictures, in stops", stops}),
      field<&Scene::tone>(
          "tone", {"clip", "tone mapping of 8- and 16-bit pictures: clip (at white), or filmic (rolls off highlights)",
                   any_value, 0, std::nullopt, tone_choices}),
  };
  return table;
}

int sample_count(const Settings& settings) {
  const int otherwise = !settings.is_random() ? 1 : settings.noise ? most_samples : 64;
  return settings.samples.value_or(otherwise);
}

int depth_limit(const Settings& settings) {
  return settings.max_depth.value_or(settings.is_path() ? 64 : 8);
}

int whitted_samples(const Settings& settings) {
  return settings.is_random() ? 1 : sample_count(settings);
}

double min_weight(const Settings& settings) {
  return settings.min_weight.value_or(0x1p-9);
}

ToneMapping tone_mapping(const Scene& scene) {
  return {scene.exposure.value_or(0), scene.tone.value_or(Tone::clip)};
}

std::optional<int> sample_grid(int samples) {
  const int side = static_cast<int>(std::lround(std::sqrt(std::max(samples, 0))));
  if (side == 0 || side * side != samples) return std::nullopt;
  return side;
}

std::optional<Problem> check(const Scene& scene) {
  if (!sample_grid(whitted_samples(scene)))
    return Problem{"samples", "`samples` is a grid of n × n rays: write a square number (1, 4, 9, 16, …)"};
  return std::nullopt;
}

Placement placement(const Scene& scene, const Object& object) {
  Placement whole =
      object.transform == no_transform ? Placement{} : scene.transforms[static_cast<std::size_t>(object.transform)];
  whole.at = object.at;
  return whole;
}

Affine to_parent(const Scene& scene, const Object& object) {
  if (object.transform == no_transform) return Affine::translating(object.at);
  return matrix(placement(scene, object));
}

Box3 bounds(const Scene& scene, const Object& object) {
  return extents(scene, object, composite_extents(scene, {&object, 1})).whole;
}

Box3 bounds(const Scene& scene) {
  return scene_extents(scene).whole;
}

Box3 finite_bounds(const Scene& scene) {
  return scene_extents(scene).finite;
}

std::uint64_t count_primitives(const Scene& scene) {
  PerComposite<std::uint64_t> known;
  const auto count = [&](std::span<const Object> objects) {
    std::uint64_t sum = 0;
    for (const Object& object : objects) {
      if (object.is_visible) sum = saturating_sum(sum, refers_to_composite(object.shape) ? known.at(object.shape) : 1);
    }
    return sum;
  };
  for (const ShapeRef ref : innermost_first(scene, scene.objects)) known[ref] = count(parts(scene.shapes, ref));
  return count(scene.objects);
}

} // namespace rt::scene
