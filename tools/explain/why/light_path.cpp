#include "tools/explain/why/light_path.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rt::tools::explain {
namespace {

using How = WayStep::How;

// The ray that leaves a surface; null if the same ray continues, unbent, or if there is none because its weight is 0.
const RayNode* ray_onwards(const SurfaceNode& s, How how) {
  switch (how) {
  case How::mirrored:
    return s.mirror->ray.get();
  case How::refracted:
    return s.transition->ray.get();
  case How::totally_reflected:
    return s.total_reflection->ray.get();
  case How::crossed:
    break;
  }
  return nullptr;
}

// The terms that came the same way from the same surface. `first` is one of them; null: there is no light.
struct Terms {
  const Contribution* first = nullptr;
  Color sum;
};

Terms largest_path(const Sum& sum) {
  using Key = std::pair<std::uint32_t, const SurfaceNode*>;
  std::map<Key, Color> sums;
  for (const Contribution& term : sum.terms) sums[{term.last_step, term.surface}] += term.value;
  Terms best{nullptr, black};
  for (const Contribution& term : sum.terms) { // in the tree's order: the first of equal ones
    const Color& color = sums.at({term.last_step, term.surface});
    if (!best.first || size_of(color) > size_of(best.sum)) best = {&term, color};
  }
  return best;
}

std::vector<PathStep> along_prospects(const RayNode& root) {
  std::vector<PathStep> path;
  const RayNode* ray = &root;
  for (std::size_t i = 0;;) {
    if (i == ray->surfaces.size()) {
      path.push_back({ray, nullptr, std::nullopt});
      return path;
    }
    const SurfaceNode& s = ray->surfaces[i];
    std::optional<How> how;
    switch (prospect(s)) {
    case Prospect::own_shading:
      break;
    case Prospect::mirrored:
      how = How::mirrored;
      break;
    case Prospect::through:
      // A black colour transmits nothing: then no ray continues.
      if (s.transition->ray || &s != &ray->surfaces.back() || ray->end != RayNode::End::surface)
        how = s.transition->ray ? How::refracted : How::crossed;
      break;
    case Prospect::totally_reflected:
      how = How::totally_reflected;
      break;
    }
    path.push_back({ray, &s, how});
    if (!how) return path;
    const RayNode* next = ray_onwards(s, *how);
    i = next ? 0 : i + 1;
    if (next) ray = next;
  }
}

} // namespace

Prospect prospect(const SurfaceNode& s) {
  if (s.total_reflection) return Prospect::totally_reflected;
  const double body = 1 - s.material.refract;
  const double mirror = s.mirror ? max_component(s.mirror->rho) : 0;
  const double through = s.transition ? s.material.refract : 0;
  if (through > body && through >= mirror) return Prospect::through;
  return mirror > 0.5 * body && s.mirror->ray ? Prospect::mirrored : Prospect::own_shading;
}

LightPath main_path(const RayNode& root, const Sum& sum) {
  const auto [term, light] = largest_path(sum);
  if (!term) return {along_prospects(root), black};
  LightPath path{{}, light};
  const RayNode* ray = &root;
  for (const WayStep& step : sum.way(term->last_step)) {
    path.steps.push_back({ray, step.at, step.how});
    if (const RayNode* next = ray_onwards(*step.at, step.how)) ray = next;
  }
  path.steps.push_back({ray, term->surface, std::nullopt});
  return path;
}

} // namespace rt::tools::explain
