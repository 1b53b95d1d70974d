// Things that are in view and never seen: too small, or always hidden.

#include "renderer/compile/geometries.hpp"
#include "renderer/math/random.hpp"
#include "tools/explain/lint/lint_parts.hpp"
#include "tools/explain/naming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rt::tools::explain {
namespace {

/// An infinite opaque plane.
struct Wall {
  PlaneGeometry plane; ///< in scene space
  const scene::Object* object;
  double side(const Vec3& p) const { return dot(p, plane.normal) - plane.offset; }
};

/// Everything that one line places.
struct Unseen {
  std::vector<LintLeaf> leaves;
  std::uint64_t count = 0;
  double largest = 0; ///< in pixels
  bool is_in_view = false, is_all_small = true;
};

constexpr std::size_t most_leaves_of_line = 256; ///< with more, it is not checked whether a line's things are enclosed
constexpr std::uint64_t least_pixels = 4'096;    ///< of a picture that is meant to be viewed
constexpr int probes = 96;
constexpr int least_probes = 12;

bool is_opaque(const scene::Scene& scene, scene::MaterialId material) {
  return material == scene::no_material || scene::is_opaque(scene.materials[static_cast<std::size_t>(material)]);
}

class Watch {
public:
  explicit Watch(LintContext& context) : context_(context), projector_(context.scene) {}

  void run() {
    // Else a line may place more than was examined.
    if (!for_each_leaf(context_.scene, [this](const LintLeaf& leaf) { look(leaf); })) return;
    std::uint64_t tries = 0;
    for (const auto& [line, unseen] : lines_) {
      if (is_stopped(context_.options)) return;
      if (tell_hidden_by_wall(line, unseen)) continue;
      if (unseen.is_in_view && unseen.is_all_small) {
        if (context_.view.rays >= least_pixels) tell_small(line, unseen);
        continue;
      }
      if (unseen.count > most_leaves_of_line || (tries += unseen.count) > most_tries) continue;
      tell_enclosed(line, unseen);
    }
  }

private:
  static constexpr std::uint64_t most_tries = 2'000;

  void look(const LintLeaf& leaf) {
    const scene::Object& object = *leaf.object;
    if (object.shape.kind == scene::kind_of<scene::Plane> && is_opaque(context_.scene, leaf.material)) {
      if (const auto plane = placed(geometry(context_.scene.shapes.get<scene::Plane>(object.shape)), leaf.to_scene))
        walls_.push_back({*plane, &object});
    }
    const Line line = line_of(object.origin);
    if (line.number == 0 || context_.view.lines.contains(line) || context_.survey.lines.contains(line)) return;
    Unseen& unseen = lines_[line];
    ++unseen.count;
    if (!leaf.box.is_finite() || leaf.box.is_empty()) {
      unseen.is_all_small = false;
      unseen.count = most_leaves_of_line + 1; // no conclusion is possible
      return;
    }
    if (const auto extent = projector_.extent(leaf.box); extent && extent->is_in_view) {
      unseen.is_in_view = true;
      unseen.largest = std::max({unseen.largest, extent->width, extent->height});
      unseen.is_all_small &= extent->width < 1 && extent->height < 1;
    } else if (!extent) {
      unseen.is_all_small = false;
    }
    if (unseen.leaves.size() <= most_leaves_of_line) unseen.leaves.push_back(leaf);
  }

  std::string things(const Unseen& unseen) const {
    return Findings::subject(name_of(context_.scene, *unseen.leaves.front().object), unseen.count);
  }

  bool tell_hidden_by_wall(Line line, const Unseen& unseen) {
    if (unseen.count > most_leaves_of_line) return false;
    for (const Wall& wall : walls_) {
      const double eye = wall.side(context_.scene.camera.at);
      if (eye == 0) continue;
      const bool is_behind = std::ranges::all_of(unseen.leaves, [&](const LintLeaf& leaf) {
        const bool is_within =
            std::ranges::all_of(corners(leaf.box), [&](const Vec3& p) { return wall.side(p) * eye <= 0; });
        return is_within && wall.side(leaf.box.center()) * eye < 0; // what lies in the plane is not behind it
      });
      if (!is_behind) continue;
      lang::Diagnostic& d = context_.findings.warn(lang::lint_rule::hidden, line,
                                                   fmt::format("{} is hidden: it lies entirely behind {}",
                                                               things(unseen), context_.findings.name(*wall.object)));
      d.label = "no ray of the picture can reach it";
      d.notes.push_back(
          context_.findings.note(line_of(wall.object->origin),
                                 "an infinite plane separates it from the camera: one of them is on the wrong side"));
      return true;
    }
    return false;
  }

  void tell_small(Line line, const Unseen& unseen) {
    lang::Diagnostic& d =
        context_.findings.warn(lang::lint_rule::too_small, line,
                               fmt::format("{} is smaller than a pixel, and no pixel shows it", things(unseen)));
    d.label = fmt::format("at most {:.2g} pixels across", unseen.largest);
    d.notes.push_back({std::nullopt, "enlarge it, move the camera closer, or raise `size` and `samples`"});
  }

  void tell_enclosed(Line line, const Unseen& unseen) {
    std::optional<Around> first;
    for (const LintLeaf& leaf : unseen.leaves) {
      const auto hull = enclosing(leaf);
      if (!hull) return;
      if (!first) first = hull;
    }
    if (!first) return;
    const scene::Object& hull = thing_of(first->objects);
    lang::Diagnostic& d = context_.findings.warn(
        lang::lint_rule::hidden, line,
        fmt::format("{} is hidden: it lies entirely inside {}", things(unseen), context_.findings.name(hull)));
    d.label = "no ray of the picture can reach it";
    d.notes.push_back(context_.findings.note(line_of(hull.origin), "this opaque solid surrounds it"));
  }

  // Deterministic for each key.
  static Vec3 random_point(const Box3& box, std::uint64_t key) {
    SplitMix64 random(mix_bits(key));
    const Vec3 size = box.extent();
    return box.lower + Vec3{size.x * random.unit(), size.y * random.unit(), size.z * random.unit()};
  }

  /// The opaque solid that every line through the leaf enters before the leaf and leaves after it.
  std::optional<Around> enclosing(const LintLeaf& leaf) const {
    std::map<std::uint64_t, Around> candidates;
    int hits = 0;
    const double reach = length(leaf.box.extent());
    for (std::uint64_t i = 0; i < probes; ++i) {
      const Vec3 target = random_point(leaf.box, i), aim = random_point(leaf.box, i + probes);
      if (target == aim) continue;
      const Vec3 direction = normalize(aim - target);
      const auto around = intervals_around(leaf, {target - direction * (2 * reach), direction});
      if (!around) continue;
      if (hits++ == 0)
        candidates = *around;
      else
        std::erase_if(candidates, [&](const auto& c) { return !around->contains(c.first); });
      if (candidates.empty()) return std::nullopt;
    }
    if (hits < least_probes) return std::nullopt;
    return candidates.begin()->second;
  }

  /// The opaque solids that contain the whole segment of the line that is in the leaf; nothing if the line misses it.
  /// The eye is in none of them.
  std::optional<std::map<std::uint64_t, Around>> intervals_around(const LintLeaf& leaf, const Ray& ray) const {
    // A solid around the leaf may be much larger: start far enough back to see where it is entered.
    const Ray line = from_outside(ray);
    const std::vector<HitReport> hits = context_.query.all_hits(line);
    double first = infinity, last = -infinity;
    for (const HitReport& hit : hits) {
      if (hit.order != leaf.order) continue;
      first = std::min(first, hit.t), last = std::max(last, hit.t);
    }
    if (first > last) return std::nullopt;
    std::map<std::uint64_t, Around> open, around;
    std::map<std::uint64_t, double> entered;
    for (const HitReport& hit : hits) {
      if (hit.order == leaf.order || hit.material.refract > 0) continue;
      if (hit.enters) {
        if (hit.t < first) entered[hit.order] = hit.t;
      } else if (const auto begin = entered.find(hit.order); begin != entered.end()) {
        if (hit.t > last) {
          Around hull{hit.order, objects_on(context_.scene, hit.path), false, true};
          if (is_solid(context_.scene, hull.objects) && !is_around_eye(hit.order))
            around.emplace(hit.order, std::move(hull));
        }
        entered.erase(begin);
      }
    }
    return around;
  }

  Ray from_outside(const Ray& ray) const {
    const double back = 4 * length(scene_size_.extent());
    return {ray.origin - ray.direction * back, ray.direction};
  }

  bool is_around_eye(std::uint64_t order) const {
    return std::ranges::any_of(context_.around_eye, [&](const Around& a) { return a.order == order; });
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  LintContext& context_;
  Projector projector_;
  Box3 scene_size_ = scene::finite_bounds(context_.scene);
  std::map<Line, Unseen> lines_;
  std::vector<Wall> walls_;
};

} // namespace

void find_unseen(LintContext& context) {
  if (context.view.hits > 0) Watch(context).run();
}

} // namespace rt::tools::explain
