// What the pixels see, and what they do not.

#include "renderer/math/affine.hpp"
#include "tools/explain/lint/lint_parts.hpp"
#include "tools/explain/naming.hpp"
#include "tools/explain/probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rt::tools::explain {
namespace {

/// Which leaf was hit: as long as it is the same, its names need not be looked up again.
struct LeafKey {
  const void* leaves = nullptr;
  const void* aggregate = nullptr;
  std::uint32_t index = 0, operand = 0;
  std::uint64_t base = 0;
  friend bool operator==(const LeafKey&, const LeafKey&) = default;
};
LeafKey key_of(const RayHit& hit) {
  return {hit.leaves, hit.aggregate, hit.index, hit.operand, hit.base};
}

class RowWatcher {
public:
  explicit RowWatcher(const LintContext& context) : context_(context) {}

  void watch(int y, int step) {
    const int width = context_.scene.size[0];
    std::array<Ray, bvh::packet_size> rays;
    std::array<RayHit, bvh::packet_size> hits;
    for (int x = 0; x < width;) {
      std::size_t n = 0;
      for (; n < rays.size() && x < width; x += step) rays[n++] = context_.query.camera().ray(x + 0.5, y + 0.5);
      context_.query.scene().nearest(std::span(rays).first(n), {}, std::span(hits).first(n), scratch_);
      for (std::size_t i = 0; i < n; ++i) note(rays[i], hits[i]);
    }
  }

  LintView view;

private:
  void note(const Ray& ray, const RayHit& hit) {
    ++view.rays;
    if (!hit) return;
    ++view.hits;
    if (key_of(hit) == last_) return;
    last_ = key_of(hit);
    if (!view.orders.insert(context_.query.scene().surface(ray, hit).order).second && !hit.operand) return;
    for (const scene::Object* object : objects_on(context_.scene, context_.query.scene().path(hit)))
      view.lines.insert(line_of(object->origin));
  }

  const LintContext& context_;
  TraceScratch scratch_;
  LeafKey last_;
};

bool walk(const scene::Scene& scene, const std::vector<scene::Object>& objects, const Affine& outer,
          scene::MaterialId inherited, std::uint64_t& order, const std::function<void(const LintLeaf&)>& look) {
  for (const scene::Object& object : objects) {
    if (!object.is_visible) continue;
    const scene::MaterialId material = object.material == scene::no_material ? inherited : object.material;
    const Affine to_scene = outer * scene::to_parent(scene, object);
    if (object.shape.kind == scene::kind_of<scene::Group>) {
      if (!walk(scene, scene.shapes.get<scene::Group>(object.shape).members, to_scene, material, order, look))
        return false;
      continue;
    }
    if (order == most_leaves) return false;
    LintLeaf leaf{&object, to_scene, material, order++, {}};
    scene.shapes.visit(object.shape, [&]<class S>(const S& shape) {
      if constexpr (std::is_same_v<S, scene::Combination>)
        leaf.box = transform_box(outer, scene::bounds(scene, object));
      else if constexpr (!std::is_same_v<S, scene::Group>)
        leaf.box = bounds(geometry(shape), to_scene);
    });
    look(leaf);
  }
  return true;
}

std::string direction(double right, double up) {
  const auto part = [](double angle, const char* positive, const char* negative) {
    return fmt::format("{:.0f} degrees {}", std::abs(angle), angle > 0 ? positive : negative);
  };
  const std::string across = part(right, "to the right", "to the left"), along = part(up, "up", "down");
  if (std::abs(up) < 0.5) return across;
  if (std::abs(right) < 0.5) return along;
  return fmt::format("{} and {}", across, along);
}

std::string rounded(const Vec3& p) {
  return fmt::format("[{:.3g}, {:.3g}, {:.3g}]", p.x + 0.0, p.y + 0.0, p.z + 0.0);
}

} // namespace

bool for_each_leaf(const scene::Scene& scene, const std::function<void(const LintLeaf&)>& look) {
  std::uint64_t order = 0;
  return walk(scene, scene.objects, {}, scene::no_material, order, look);
}

LintView view_of(const LintContext& context) {
  const auto [width, height] = context.scene.size;
  const double pixels = static_cast<double>(width) * height;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / static_cast<double>(most_pixels)))));
  std::vector<RowWatcher> watchers(static_cast<std::size_t>(workers_of(context.options)), RowWatcher(context));
  for_each_row(context.options, (height + step - 1) / step,
               [&](int row, int worker) { watchers[static_cast<std::size_t>(worker)].watch(row * step, step); });
  LintView all;
  for (const RowWatcher& watcher : watchers) {
    all.rays += watcher.view.rays;
    all.hits += watcher.view.hits;
    all.lines.insert(watcher.view.lines.begin(), watcher.view.lines.end());
    all.orders.insert(watcher.view.orders.begin(), watcher.view.orders.end());
  }
  return all;
}

std::array<Vec3, 8> corners(const Box3& box) {
  std::array<Vec3, 8> all;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z};
  return all;
}

Projector::Projector(const scene::Scene& scene)
    : eye_(scene.camera.at), width_(scene.size[0]), height_(scene.size[1]),
      is_orthographic_(scene.camera.projection == scene::Projection::orthographic) {
  forward_ = normalize(scene.camera.look_at - scene.camera.at);
  right_ = normalize(cross(forward_, scene.camera.up));
  up_ = cross(right_, forward_);
  half_width_ = is_orthographic_ ? scene.camera.width / 2 : std::tan(scene.camera.fov / 2 * (std::numbers::pi / 180));
}

Vec3 Projector::pixel(const Vec3& p) const {
  const double scale = (is_orthographic_ ? 1 : depth(p)) * half_width_;
  const double x = dot(p - eye_, right_) / scale, y = dot(p - eye_, up_) / scale;
  return {(x + 1) * width_ / 2, height_ / 2 - y * width_ / 2, 0};
}

std::pair<double, double> Projector::angles(const Vec3& p) const {
  const double degrees = 180 / std::numbers::pi;
  const Vec3 d = p - eye_;
  return {std::atan2(dot(d, right_), dot(d, forward_)) * degrees,
          std::atan2(dot(d, up_), std::hypot(dot(d, right_), dot(d, forward_))) * degrees};
}

std::optional<Projector::Extent> Projector::extent(const Box3& box) const {
  Box3 covered;
  for (const Vec3& corner : corners(box)) {
    if (!(depth(corner) > 0)) return std::nullopt;
    covered.extend(pixel(corner));
  }
  const Vec3 size = covered.extent();
  const bool is_in_view =
      covered.lower.x < width_ && covered.upper.x > 0 && covered.lower.y < height_ && covered.upper.y > 0;
  return Extent{size.x, size.y, is_in_view};
}

void find_empty_view(LintContext& context) {
  if (context.view.hits > 0) return;
  const scene::Scene& scene = context.scene;
  const Line line = line_of(scene.camera_origin);
  const Projector projector(scene);
  const Box3 box = scene::finite_bounds(scene);
  if (box.is_empty()) {
    lang::Diagnostic& d = context.findings.warn(lang::lint_rule::nothing_in_view, line, "nothing is in view");
    d.notes.push_back({std::nullopt, "everything is infinite, and lies behind the camera or outside its view"});
    return;
  }
  const std::string middle = rounded(box.center());
  const bool is_behind = std::ranges::all_of(corners(box), [&](const Vec3& p) { return projector.depth(p) <= 0; });
  if (is_behind) {
    lang::Diagnostic& d =
        context.findings.warn(lang::lint_rule::behind_camera, line, "everything is behind the camera");
    d.label = fmt::format("it looks from {} at {}", rounded(scene.camera.at), rounded(scene.camera.look_at));
    d.notes.push_back(
        {std::nullopt, fmt::format("the centre of all things is at {}: write `look_at: {}`", middle, middle)});
    return;
  }
  lang::Diagnostic& d = context.findings.warn(lang::lint_rule::nothing_in_view, line, "nothing is in view");
  const auto extent = projector.extent(box);
  if (extent && extent->width < 1 && extent->height < 1 && extent->is_in_view) {
    d.label = "everything is smaller than a pixel";
    d.notes.push_back(
        {std::nullopt,
         fmt::format("the camera is {:.3g} away from it, and it is {:.3g} across: move closer, or reduce `fov`",
                     length(box.center() - scene.camera.at), length(box.extent()))});
    return;
  }
  const auto [right, up] = projector.angles(box.center());
  if (std::hypot(right, up) < 1) {
    d.label = "the rays through all pixels miss everything";
    return;
  }
  d.label = fmt::format("the centre of all things is {} from the view's centre", direction(right, up));
  d.notes.push_back({std::nullopt, fmt::format("write `look_at: {}`", middle)});
}

} // namespace rt::tools::explain
