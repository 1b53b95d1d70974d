#include "tools/explain/why/ray_tree.hpp"

#include "renderer/integrators/whitted.hpp"

#include <utility>

namespace rt::tools::explain {
namespace {

class Recorder {
public:
  Recorder(const CompiledScene& scene, std::size_t most_surfaces) : scene_(scene), surfaces_left_(most_surfaces) {}

  void begin_ray(RayKind kind, const Ray& ray, int depth, const Color& weight) {
    RayNode* const node = add_ray();
    open_.push_back(node);
    if (!node) return;
    node->kind = kind;
    node->ray = next_ = ray;
    node->depth = depth;
    node->weight = weight;
    node->is_expanded = surfaces_left_ > 0;
    passed_.push_back(white);
  }

  void end_ray(const Color& radiance) {
    RayNode* const node = open_.back();
    open_.pop_back();
    if (!node) return;
    node->radiance = radiance;
    passed_.pop_back();
  }

  void miss(const Color& background) {
    if (!is_expanded()) return;
    open_.back()->end = RayNode::End::background;
    open_.back()->background = absorbed_ ? background * absorbed_->left : background;
    absorbed_.reset();
  }

  void absorption(const Color& left, double length) {
    if (is_expanded()) absorbed_ = AbsorptionNode{left, length};
  }

  void too_deep() {
    if (is_expanded()) open_.back()->end = RayNode::End::too_deep;
  }

  void too_weak(double weight, const Color& estimate) {
    if (!is_expanded()) return;
    SurfaceNode& s = last();
    (s.transition ? s.transition->left_out : s.mirror->left_out) = LeftOut{weight, estimate};
  }

  void touching(const std::vector<MetSurface>& met) {
    if (!is_expanded() || met.size() < 2) return;
    for (const MetSurface& m : met) touching_.push_back(scene_.path(m.hit));
  }

  void contact(const Contacts& contacts, const Contacts::Position& position) {
    contacts_ = &contacts;
    position_ = position;
    if (position.is_inside()) next_ = contacts.surface(position).ray;
  }

  void surface(const RayHit& hit, const Surface& surface, const MaterialValues& values, const Vec3& normal) {
    if (!is_expanded()) return;
    if (surfaces_left_ > 0) --surfaces_left_;
    SurfaceNode node;
    node.ray = next_;
    node.hit = hit;
    node.path = scene_.path(hit);
    node.surface = surface;
    node.material = values;
    node.normal = normal;
    if (absorbed_) passed_.back() *= absorbed_->left;
    node.passed = passed_.back();
    node.touching = std::move(touching_);
    touching_.clear();
    node.absorbed = std::exchange(absorbed_, std::nullopt);
    open_.back()->surfaces.push_back(std::move(node));
  }

  void own_light(const Color& ambient, const Color& emission) {
    if (!is_expanded()) return;
    last().ambient = ambient;
    last().emission = emission;
  }

  void light(const LightRecord& record, const Surface& surface) {
    if (!is_expanded()) return;
    last().lights.push_back({record, record.filter == white || record.left_out > 0 ? std::vector<InTheWay>{}
                                                                                   : in_the_way(record, surface)});
  }

  void reflection(const Color& rho, double reflectance, double cosine, double eta) {
    if (is_expanded()) last().mirror = MirrorNode{rho, reflectance, cosine, eta, std::nullopt, nullptr};
  }

  void refraction(const Color& tau, const MediumTransition& transition, double cosine, double cosine_behind) {
    if (!is_expanded()) return;
    SurfaceNode& s = last();
    s.transition = TransitionNode{tau, transition, cosine, cosine_behind, std::nullopt, nullptr};
    // Needed only if the ray goes on unbent.
    next_ = OwnRules::leave(s.surface, s.ray.direction);
    passed_.back() = s.passed * tau;
  }

  void total_reflection(const MediumTransition& transition, double cosine) {
    if (is_expanded()) last().total_reflection = TotalReflectionNode{transition, cosine, nullptr};
  }

  std::unique_ptr<RayNode> root;

private:
  bool is_expanded() const { return open_.back() && open_.back()->is_expanded; }
  SurfaceNode& last() { return open_.back()->surfaces.back(); }

  // The node for a ray that begins: the root, or the branch of the surface that was recorded last. None below a ray
  // that is not expanded.
  RayNode* add_ray() {
    auto node = std::make_unique<RayNode>();
    RayNode* const added = node.get();
    if (open_.empty()) {
      root = std::move(node);
      return added;
    }
    if (!is_expanded()) return nullptr;
    SurfaceNode& s = last();
    (s.total_reflection ? s.total_reflection->ray : s.transition ? s.transition->ray : s.mirror->ray) = std::move(node);
    return added;
  }

  std::vector<InTheWay> in_the_way(const LightRecord& record, const Surface& surface) const {
    const Vec3& to_light = record.sample.to_light;
    std::vector<InTheWay> found;
    for (auto p = position_; p.is_inside() && (p = contacts_->after(p, to_light)).is_inside();)
      add_in_the_way(contacts_->surface(p).hit, contacts_->surface(p).surface, 0, found);
    const Ray ray = OwnRules::leave(surface, to_light);
    for (const RayHit& hit : scene_.all_hits(ray, OwnRules::shadow_range(record.sample.distance))) {
      add_in_the_way(hit, scene_.surface(ray, hit), hit.t, found);
      if (!found.empty() && found.back().transmittance == black) break;
    }
    return found;
  }

  void add_in_the_way(const RayHit& hit, const Surface& surface, double distance, std::vector<InTheWay>& found) const {
    if (!scene_.casts_shadow(hit)) return;
    MaterialValues scratch;
    const MaterialValues& v = scene_.values(surface, scratch);
    found.push_back({scene_.path(hit), distance, v.color * v.refract});
  }

  const CompiledScene& scene_;
  std::size_t surfaces_left_;
  std::vector<RayNode*> open_;
  std::vector<Color> passed_;                        // of the open rays that have a node
  Ray next_;                                         // that hits the next surface
  std::vector<std::vector<std::uint32_t>> touching_; // the surfaces in the place of the next surface
  const Contacts* contacts_ = nullptr;
  Contacts::Position position_{};          // of the last surface, if it is one of several that touch
  std::optional<AbsorptionNode> absorbed_; // on the way there
};

} // namespace

Color SurfaceNode::shading() const {
  Color sum = ambient + emission;
  for (const LightNode& light : lights) sum += light.record.reflected.sum();
  return sum;
}

std::unique_ptr<RayNode> record(const RayQuery& query, const Ray& ray, std::size_t most_surfaces) {
  Recorder recorder(query.scene(), most_surfaces);
  Whitted<OwnRules, Recorder> whitted(query.scene(), recorder);
  whitted.radiance(RayQuery::unit(ray), query.scene().around(ray.origin));
  return std::move(recorder.root);
}

} // namespace rt::tools::explain
