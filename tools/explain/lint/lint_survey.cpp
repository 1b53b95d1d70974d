// A sample of the pixels, traced with all descendant rays.

#include "renderer/integrators/whitted.hpp"
#include "tools/explain/lint/lint_parts.hpp"
#include "tools/explain/naming.hpp"

#include <algorithm>
#include <cmath>

namespace rt::tools::explain {
namespace {

constexpr double weight_that_counts = 0.1;        // of a branch that is cut off, in its pixel
constexpr double weight_of_coincidence = 0.02;    // of a ray whose surfaces are examined for coincidence
constexpr int coincidences_looked_for = 32;       // per pixel
constexpr std::size_t most_blockers = 200;        // that are looked for, per light
constexpr double black_below = 0.5 / 255 / 12.92; // what sRGB rounds to 0
constexpr double white_from = 1 + 1e-9;

struct Listener : NoRecorder {
  Listener(const LintContext& c, LintSurvey& s) : context(c), survey(s) {
    survey.lights.resize(c.query.scene().lights().size());
  }

  struct RayFrame {
    Vec3 direction;
    Color weight;
    Line line; // of the surface last hit
  };

  void begin_pixel(double pixel_size_at_1) {
    is_cut_off = false;
    looks = 0;
    footprint = pixel_size_at_1;
  }

  void begin_ray(RayKind, const Ray& ray, int, const Color& weight) {
    const Line line = frames.empty() ? Line{} : frames.back().line;
    frames.push_back({ray.direction, weight, line});
  }
  void end_ray(const Color&) { frames.pop_back(); }

  void too_deep() {
    if (max_component(frames.back().weight) < weight_that_counts) return;
    if (!is_cut_off) ++survey.cut_off_at[frames.back().line];
    is_cut_off = true;
  }

  void surface(const RayHit& hit, const Surface& surface, const MaterialValues& values, const Vec3&) {
    const auto objects = objects_on(context.scene, context.query.scene().path(hit));
    for (const scene::Object* object : objects) survey.lines.insert(line_of(object->origin));
    frames.back().line = line_of(objects.back()->origin);
    if (looks < coincidences_looked_for && max_component(frames.back().weight) >= weight_of_coincidence) {
      ++looks;
      look_for_coincidence(surface, values);
    }
  }

  void light(const LightRecord& record, const Surface& surface) {
    LightTally& tally = survey.lights[record.light];
    if (tally.is_lit) return;
    if (record.sample.color == black) {
      ++tally.dark;
    } else if (record.cos_light <= 0) {
      ++tally.averted;
    } else if (record.filter != black) {
      tally.is_lit = true;
    } else {
      ++tally.blocked;
      if (tally.blocked <= most_blockers) find_blocker(record, surface, tally);
    }
  }

  void find_blocker(const LightRecord& record, const Surface& surface, LightTally& tally) const {
    for (const HitReport& hit : context.query.all_hits(OwnRules::leave(surface, record.sample.to_light),
                                                       OwnRules::shadow_range(record.sample.distance))) {
      if (hit.material.refract > 0) continue;
      ++tally.blockers[line_of(objects_on(context.scene, hit.path).back()->origin)];
      return;
    }
  }

  /// The surfaces that a ray hits at the point where it hits this one, nearest first.
  std::vector<HitReport> hits_around(const Vec3& point, const Vec3& direction) const {
    const double size = std::max({1.0, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    const double back = 1e-2 * size, slack = 1e-9 * size;
    return context.query.all_hits({point - direction * back, direction}, {back - slack, back + slack});
  }

  static const HitReport* of_order(const std::vector<HitReport>& hits, std::uint64_t order) {
    const auto found = std::ranges::find(hits, order, &HitReport::order);
    return found == hits.end() ? nullptr : &*found;
  }

  void look_for_coincidence(const Surface& surface, const MaterialValues& values) {
    const Vec3 direction = frames.back().direction;
    const auto hits = hits_around(surface.position, direction);
    if (hits.size() < 2) return;
    for (const HitReport& other : hits) {
      if (other.order == surface.order) continue;
      const double cosine = dot(other.normal, surface.normal);
      if (std::abs(cosine) < 1 - 1e-6) continue;
      // Light that crosses one of them crosses both in the same way; for opaque ones it matters which is seen.
      if (values.refract > 0 || other.material.refract > 0) continue;
      if (cosine < 0 || looks_alike(values, other.material)) continue;
      const HitReport* mine = of_order(hits, surface.order);
      if (!mine || !coincides_beside(*mine, other, direction)) continue;
      add(*mine, other);
      return;
    }
  }

  static bool looks_alike(const MaterialValues& a, const MaterialValues& b) {
    return a.color == b.color && a.ambient == b.ambient && a.diffuse == b.diffuse && a.emission == b.emission &&
           a.reflect == b.reflect && a.specular == b.specular && a.shininess == b.shininess &&
           a.metallic == b.metallic && a.coat == b.coat;
  }

  /// Not only in a point or line of contact: also beside it, on two sides.
  bool coincides_beside(const HitReport& a, const HitReport& b, const Vec3& direction) const {
    const Vec3 n = a.normal;
    const Vec3 u = normalize(cross(n, std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})), v = cross(n, u);
    const double step = std::max(footprint * length(a.position - context.scene.camera.at), 1e-6);
    for (const Vec3& shift : {u * step, v * step, (u + v) * (-0.7 * step)}) {
      const Vec3 beside = a.position + shift;
      // On a curved surface the ray hits both slightly before or behind: they must do so together.
      const double reach = 1e-2 * std::max(1.0, length(beside)) + step;
      const auto hits = context.query.all_hits({beside - direction * reach, direction}, {0, 2 * reach});
      const HitReport *one = of_order(hits, a.order), *other = of_order(hits, b.order);
      if (!one || !other || std::abs(one->t - other->t) > 1e-9 * std::max(1.0, length(beside))) return false;
    }
    return true;
  }

  void add(const HitReport& a, const HitReport& b) {
    const scene::Object* first = &thing_of(objects_on(context.scene, a.path));
    const scene::Object* second = &thing_of(objects_on(context.scene, b.path));
    if (line_of(second->origin) < line_of(first->origin)) std::swap(first, second);
    Coincidence& c = survey.coincidences[{line_of(first->origin), line_of(second->origin)}];
    if (c.count++ == 0) c.first = context.findings.name(*first), c.second = context.findings.name(*second);
  }

  const LintContext& context;
  LintSurvey& survey;
  std::vector<RayFrame> frames;
  double footprint = 0; ///< of a pixel, at distance 1
  int looks = 0;
  bool is_cut_off = false;
};

void merge(LintSurvey& all, const LintSurvey& part) {
  all.rays += part.rays, all.surfaces += part.surfaces, all.black += part.black, all.clipped += part.clipped;
  all.cut_off += part.cut_off;
  for (const auto& [line, count] : part.cut_off_at) all.cut_off_at[line] += count;
  all.lines.insert(part.lines.begin(), part.lines.end());
  all.lights.resize(part.lights.size());
  for (std::size_t i = 0; i < part.lights.size(); ++i) {
    LightTally& to = all.lights[i];
    const LightTally& from = part.lights[i];
    to.is_lit |= from.is_lit;
    to.dark += from.dark, to.averted += from.averted, to.blocked += from.blocked;
    for (const auto& [line, count] : from.blockers) to.blockers[line] += count;
  }
  for (const auto& [lines, c] : part.coincidences) {
    Coincidence& to = all.coincidences[lines];
    if (to.count == 0) to.first = c.first, to.second = c.second;
    to.count += c.count;
  }
}

class Surveyor {
public:
  Surveyor(const LintContext& context, std::vector<Medium> inside, bool has_one_eye)
      : context_(context), inside_(std::move(inside)), has_one_eye_(has_one_eye) {}

  void trace_row(int row, int columns, int rows, LintSurvey& survey) const {
    const auto [width, height] = context_.scene.size;
    const CompiledScene& scene = context_.query.scene();
    Listener listener(context_, survey);
    Whitted<OwnRules, Listener> whitted(scene, listener);
    TraceScratch scratch;
    const ToneCurve curve(scene::tone_mapping(context_.scene));
    const int y = static_cast<int>((row + 0.5) * height / rows);
    for (int column = 0; column < columns; ++column) {
      const int x = static_cast<int>((column + 0.5) * width / columns);
      const Ray ray = context_.query.camera().ray(x + 0.5, y + 0.5);
      listener.begin_pixel(0.5 / width);
      const Color color = whitted.radiance(ray, has_one_eye_ ? inside_ : scene.around(ray.origin));
      ++survey.rays;
      survey.cut_off += listener.is_cut_off ? 1U : 0U;
      if (!scene.nearest(ray, {}, scratch)) continue;
      ++survey.surfaces;
      survey.black += max_component(color) < black_below ? 1U : 0U;
      survey.clipped += curve(static_cast<float>(max_component(color))) > white_from ? 1U : 0U;
    }
  }

private:
  const LintContext& context_;
  std::vector<Medium> inside_;
  bool has_one_eye_;
};

} // namespace

// Each row has its own result, and they are merged in order: nothing depends on which thread traced which.
LintSurvey survey_of(const LintContext& context, std::uint64_t rays) {
  const auto [width, height] = context.scene.size;
  const double step = std::max(1.0, std::sqrt(static_cast<double>(width) * height / static_cast<double>(rays)));
  const int columns = std::max(1, static_cast<int>(width / step)), rows = std::max(1, static_cast<int>(height / step));
  const CameraRays& camera = context.query.camera();
  const Surveyor surveyor(context, context.query.scene().around(camera.ray(0, 0).origin), camera.has_one_eye());
  std::vector<LintSurvey> parts(static_cast<std::size_t>(rows));
  for_each_row(context.options, rows,
               [&](int row, int) { surveyor.trace_row(row, columns, rows, parts[static_cast<std::size_t>(row)]); });
  LintSurvey all;
  for (const LintSurvey& part : parts) merge(all, part);
  return all;
}

} // namespace rt::tools::explain
