#include "tools/explain/why/contributions.hpp"

#include <algorithm>

namespace rt::tools::explain {
namespace {

class Taker {
public:
  explicit Taker(Sum& sum) : sum_(sum) {}

  void ray(const RayNode& node, const Color& weight) {
    const std::uint32_t mark = last_;
    if (!node.is_expanded) {
      add(Contribution::Kind::unexpanded, weight * node.radiance);
      return;
    }
    for (std::size_t i = 0; i < node.surfaces.size(); ++i) {
      surface(node.surfaces[i], weight);
      if (i + 1 < node.surfaces.size() || node.end != RayNode::End::surface)
        step(WayStep::How::crossed, node.surfaces[i]);
    }
    const Color left = node.surfaces.empty() ? weight : weight * passed_behind(node.surfaces.back());
    if (node.end == RayNode::End::background) add(Contribution::Kind::background, left * node.background);
    if (node.end == RayNode::End::too_deep) sum_.cuts.push_back({left, last_});
    last_ = mark;
  }

private:
  static Color passed_behind(const SurfaceNode& s) { return s.transition ? s.passed * s.transition->tau : s.passed; }

  void surface(const SurfaceNode& s, const Color& ray_weight) {
    const Color weight = ray_weight * s.passed;
    add(Contribution::Kind::ambient, weight * s.ambient, &s);
    add(Contribution::Kind::emission, weight * s.emission, &s);
    for (const LightNode& light : s.lights) {
      add(Contribution::Kind::diffuse, weight * light.record.reflected.diffuse, &s, light.record.light);
      add(Contribution::Kind::highlight, weight * light.record.reflected.highlight, &s, light.record.light);
    }
    using enum WayStep::How;
    if (s.mirror) {
      left_out(s.mirror->left_out, weight * s.mirror->rho);
      branch(s, s.mirror->ray.get(), weight * s.mirror->rho, mirrored);
    }
    if (s.transition) {
      left_out(s.transition->left_out, weight * s.transition->tau);
      branch(s, s.transition->ray.get(), weight * s.transition->tau, refracted);
    }
    if (s.total_reflection) branch(s, s.total_reflection->ray.get(), weight, totally_reflected);
  }

  void left_out(const std::optional<LeftOut>& branch, const Color& weight) {
    if (branch) add(Contribution::Kind::estimate, weight * branch->estimate);
  }

  void branch(const SurfaceNode& at, const RayNode* node, const Color& weight, WayStep::How how) {
    if (!node) return;
    const std::uint32_t mark = last_;
    step(how, at);
    ray(*node, weight);
    last_ = mark;
  }

  void step(WayStep::How how, const SurfaceNode& at) {
    sum_.steps.push_back({how, &at, last_});
    last_ = static_cast<std::uint32_t>(sum_.steps.size() - 1);
  }

  void add(Contribution::Kind kind, const Color& value, const SurfaceNode* surface = nullptr, std::uint32_t light = 0) {
    if (value == black) return;
    sum_.terms.push_back({kind, value, surface, light, last_});
    sum_.total += value;
  }

  Sum& sum_;
  std::uint32_t last_ = no_step;
};

} // namespace

std::vector<WayStep> Sum::way(std::uint32_t last_step) const {
  std::vector<WayStep> way;
  for (std::uint32_t i = last_step; i != no_step; i = steps[i].before) way.push_back(steps[i]);
  std::reverse(way.begin(), way.end());
  return way;
}

Sum take_apart(const RayNode& root) {
  Sum sum;
  Taker(sum).ray(root, white);
  return sum;
}

} // namespace rt::tools::explain
