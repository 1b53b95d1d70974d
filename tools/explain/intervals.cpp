#include "tools/explain/intervals.hpp"

#include "renderer/compile/geometries.hpp"
#include "tools/explain/derivation/derivation.hpp"
#include "tools/explain/naming.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt::tools::explain {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int deepest = 200;

LineIntervals complement(const LineIntervals& a) {
  LineIntervals outside;
  double from = -infinity;
  for (const LineInterval& s : a) {
    if (s.enter > from) outside.push_back({from, s.enter});
    from = s.leave;
  }
  if (from < infinity) outside.push_back({from, infinity});
  return outside;
}

template <Solidlike G>
LineIntervals of_shape(const G& shape, const Ray& ray) {
  LineIntervals inside;
  const Crossings found = crossings(shape, ray);
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(found.count); i += 2)
    inside.push_back({found.at[i].t, found.at[i + 1].t});
  return inside;
}

// Without what rounding makes where surfaces touch: intervals and gaps far shorter than the digits that are shown.
LineIntervals without_slivers(const LineIntervals& a) {
  const auto is_sliver = [](double from, double to) { return to - from <= 1e-12 * std::abs(to); };
  LineIntervals kept;
  for (const LineInterval& s : a) {
    if (is_sliver(s.enter, s.leave)) continue;
    if (!kept.empty() && is_sliver(kept.back().leave, s.enter))
      kept.back().leave = s.leave;
    else
      kept.push_back(s);
  }
  return kept;
}

struct TooDeep {};

// Where the line is inside an object: a shape, a group's union or a combination. `ray` is in the space of its
// parent.
class Walker {
public:
  explicit Walker(const scene::Scene& scene) : scene_(scene) {}

  LineIntervals along(const scene::Object& object, const Ray& ray, int depth) const {
    if (depth > deepest) throw TooDeep{};
    const auto back = inverse(to_parent(scene_, object));
    if (!back) return {};
    const Ray own = back->ray(ray);
    return scene_.shapes.visit(object.shape, [&]<class S>(const S& shape) -> LineIntervals {
      if constexpr (std::is_same_v<S, scene::Group>)
        return all(shape.members, scene::Combination::Operation::unite, own, depth);
      else if constexpr (std::is_same_v<S, scene::Combination>)
        return all(shape.operands, shape.operation, own, depth);
      else if constexpr (Solidlike<GeometryOf<S>>)
        return of_shape(geometry(shape), own);
      else
        return {}; // it has no inside
    });
  }

private:
  LineIntervals all(const std::vector<scene::Object>& objects, scene::Combination::Operation operation, const Ray& ray,
                    int depth) const {
    LineIntervals inside;
    bool is_first = true;
    for (const scene::Object& object : objects) {
      if (!object.is_visible) {
        // If there is nothing to subtract from, the result is empty.
        if (is_first && &object == &objects.front() && operation == scene::Combination::Operation::subtract) return {};
        continue;
      }
      inside = is_first ? along(object, ray, depth + 1) : combine(operation, inside, along(object, ray, depth + 1));
      is_first = false;
    }
    return inside;
  }

public:
  static LineIntervals combine(scene::Combination::Operation operation, const LineIntervals& a,
                               const LineIntervals& b) {
    switch (operation) {
    case scene::Combination::Operation::unite:
      return unite(a, b);
    case scene::Combination::Operation::intersect:
      return rt::tools::explain::intersect(a, b);
    case scene::Combination::Operation::subtract:
      return subtract(a, b);
    }
    return {};
  }

private:
  const scene::Scene& scene_;
};

} // namespace

LineIntervals unite(const LineIntervals& a, const LineIntervals& b) {
  LineIntervals sorted = a, whole;
  sorted.insert(sorted.end(), b.begin(), b.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const LineInterval& s, const LineInterval& t) { return s.enter < t.enter; });
  for (const LineInterval& s : sorted) {
    if (!whole.empty() && s.enter <= whole.back().leave)
      whole.back().leave = std::max(whole.back().leave, s.leave);
    else
      whole.push_back(s);
  }
  return whole;
}

LineIntervals intersect(const LineIntervals& a, const LineIntervals& b) {
  LineIntervals both;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    const LineInterval common{std::max(i->enter, j->enter), std::min(i->leave, j->leave)};
    if (common.enter < common.leave) both.push_back(common);
    i->leave < j->leave ? ++i : ++j;
  }
  return both;
}

LineIntervals subtract(const LineIntervals& a, const LineIntervals& b) {
  return intersect(a, complement(b));
}

std::optional<CombinationIntervals> intervals_along(const scene::Scene& scene, std::span<const std::uint32_t> path,
                                                    const Ray& ray) {
  const auto objects = objects_on(scene, path);
  std::size_t at = 0;
  while (at < objects.size() && objects[at]->shape.kind != scene::kind_of<scene::Combination>) ++at;
  if (at == objects.size()) return std::nullopt;
  const auto back = inverse(map_of(scene, path.subspan(0, at + 1)));
  if (!back) return std::nullopt;
  const Ray own = back->ray(ray);
  const auto& combination = scene.shapes.get<scene::Combination>(objects[at]->shape);
  CombinationIntervals result{static_cast<std::uint32_t>(at), combination.operation, {}, {}};
  try {
    const Walker walker(scene);
    for (const scene::Object& operand : combination.operands) {
      if (!operand.is_visible) continue;
      LineIntervals inside = walker.along(operand, own, 0);
      result.inside = result.operands.empty() ? inside : Walker::combine(combination.operation, result.inside, inside);
      result.operands.push_back({&operand, std::move(inside)});
    }
    result.inside = without_slivers(result.inside);
  } catch (const TooDeep&) {
    return std::nullopt;
  }
  return result;
}

} // namespace rt::tools::explain
