#include "tools/explain/derivation/derivation.hpp"

#include "tools/explain/derivation/derivation_steps.hpp"
#include "tools/explain/naming.hpp"
#include "tools/explain/text.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <limits>

namespace rt::tools::explain {

Steps& Steps::put(std::string_view key, std::string_view label, double value) {
  line_.quantities.push_back({std::string(key), std::string(label), value});
  return *this;
}

Steps& Steps::put(std::string_view key, std::string_view label, const Vec3& value) {
  line_.quantities.push_back({std::string(key), std::string(label), value});
  return *this;
}

void Steps::so(std::string words) {
  line_.words = std::move(words);
  derivation_.lines.push_back(std::move(line_));
  line_ = {};
}

Steps::Roots Steps::solve(double a, double b, double c, std::string_view surface) {
  const double computed = b * b - 4 * a * c;
  const double noise = 1e-9 * (b * b + std::abs(4 * a * c));
  const double d = computed < 0 && computed > -noise ? 0 : computed;
  put("discriminant", "b² − 4ac", computed);
  if (d < 0) {
    so(fmt::format("< 0: the line misses {}", surface));
    return {};
  }
  const double root = std::sqrt(d);
  const double first = (-b - root) / (2 * a), second = (-b + root) / (2 * a);
  if (d == 0) {
    so(fmt::format("0: the line touches {}", surface));
    put("t1", "t = −b / 2a", first).so();
    return {1, first, first};
  }
  so(fmt::format("> 0: the line intersects {} twice", surface));
  put("t1", "t₁ = (−b − √) / 2a", std::min(first, second))
      .put("t2", "t₂ = (−b + √) / 2a", std::max(first, second))
      .so();
  return {2, std::min(first, second), std::max(first, second)};
}

namespace {

// Whether a candidate is where the ray starts: on the surface that it has just left.
bool is_start(double t, double taken) {
  return std::abs(t) <= 1e-9 * std::max(1.0, std::abs(taken));
}

std::string why_not(const Steps::Candidate& c, double taken, bool is_of_combination) {
  if (is_start(c.t, taken)) return fmt::format("{} is where the ray starts", c.name);
  if (c.t < 0) return fmt::format("{} is behind the ray's origin", c.name);
  if (c.t > taken) return {};
  return is_of_combination ? fmt::format("{} is not on the surface of the combination", c.name)
                           : fmt::format("{} is nearer by rounding only", c.name);
}

} // namespace

void Steps::choose(std::vector<Candidate> candidates) {
  const double t = found_.t;
  const Candidate* taken = nullptr;
  const auto gap = [t](const Candidate& c) { return std::abs(c.t - t); };
  for (const Candidate& c : candidates) {
    if (!std::isfinite(c.t)) continue;
    const bool is_better =
        !taken || (c.counts && !taken->counts) || (c.counts == taken->counts && gap(c) < gap(*taken));
    if (is_better) taken = &c;
  }
  if (!taken) return;
  derivation_.t = taken->t;
  if (candidates.size() == 1) return;
  std::string reasons;
  bool has_farther = false;
  for (const Candidate& c : candidates) {
    if (&c == taken || !c.counts || !std::isfinite(c.t)) continue;
    const std::string reason = why_not(c, t, is_operand_);
    if (reason.empty())
      has_farther = true;
    else
      reasons += (reasons.empty() ? "" : ", ") + reason;
  }
  if (!reasons.empty())
    derivation_.choice = fmt::format("{}, so {} is taken", reasons, taken->name);
  else
    derivation_.choice = fmt::format("{} is taken{}", taken->name, has_farther ? ", the nearest ahead" : "");
}

namespace {

bool only_moves(const Affine& map) {
  return map.x == Vec3{1, 0, 0} && map.y == Vec3{0, 1, 0} && map.z == Vec3{0, 0, 1};
}

} // namespace

Affine map_of(const scene::Scene& scene, std::span<const std::uint32_t> path) {
  Affine map;
  for (const scene::Object* object : objects_on(scene, path)) map = map * to_parent(scene, *object);
  return map;
}

Derivation derive(const scene::Scene& scene, std::span<const std::uint32_t> path, const Ray& ray, const Hit& found,
                  bool is_operand) {
  Derivation derivation;
  const scene::Object& object = *objects_on(scene, path).back();
  const Affine map = map_of(scene, path);
  const auto back = inverse(map);
  assert(back && "a transform must not flatten its shape");
  derivation.is_own_space = !only_moves(map);
  derivation.ray = derivation.is_own_space ? back->ray(ray) : ray;
  scene.shapes.visit(object.shape, [&]<class S>(const S& shape) {
    if constexpr (!scene::is_composite<S>) {
      derivation.shape = S::noun;
      Steps steps(derivation, found, is_operand);
      const auto own = geometry(shape);
      derive_shape(steps, derivation.is_own_space ? own : placed(own, map).value_or(own));
    }
  });
  derivation.disagreement =
      std::abs(derivation.t - found.t) / std::max(std::abs(found.t), std::numeric_limits<double>::min());
  return derivation;
}

} // namespace rt::tools::explain
