// Coincident surfaces, nested media, and what becomes of light.

#include "tools/explain/lint/lint_parts.hpp"
#include "tools/explain/naming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::tools::explain {
namespace {

constexpr std::uint64_t least_evidence = 3; // pixels that show something, before it is reported about lines

/// An interval of a ray within a transparent solid.
struct LineInterval {
  double begin, end;
  const HitReport* hit; ///< where it is entered or left
};

bool uses_media(const scene::Scene& scene) {
  return std::ranges::any_of(scene.materials,
                             [](const scene::Material& m) { return !scene::is_opaque(m) && m.ior != 1; });
}

/// For the transparent solids up to the first opaque surface.
std::vector<LineInterval> intervals(const LintContext& context, const std::vector<HitReport>& hits) {
  std::vector<LineInterval> found;
  std::map<std::uint64_t, const HitReport*> entered;
  for (const HitReport& hit : hits) {
    if (hit.material.refract == 0) break;
    if (!is_solid(context.scene, objects_on(context.scene, hit.path))) continue;
    if (hit.enters) {
      entered.emplace(hit.order, &hit);
    } else if (const auto begin = entered.find(hit.order); begin != entered.end()) {
      found.push_back({begin->second->t, hit.t, begin->second});
      entered.erase(begin);
    }
  }
  return found;
}

struct Overlap {
  std::uint64_t count = 0;
  std::string first, second;
};

std::string percent(std::uint64_t part, std::uint64_t whole) {
  return fmt::format("{:.0f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

Line most_common(const std::map<Line, std::uint64_t>& counts) {
  Line best;
  std::uint64_t most = 0;
  for (const auto& [line, count] : counts)
    if (count > most) best = line, most = count;
  return best;
}

/// Why a light contributes nothing, and what to do about it.
std::pair<std::string, std::string> darkness(const LintContext& context, const Light& light, const LightTally& tally) {
  if (light.color == black) return {"its `color` or `intensity` is 0", "raise it, or remove the light"};
  if (tally.blocked > 0 && tally.blocked >= tally.averted) {
    const Line line = most_common(tally.blockers);
    const std::string where = context.findings.place(line);
    return {where.empty() ? "something opaque always blocks it" : fmt::format("what {} places blocks it", where),
            "move one of them, or write `casts_shadow: false` where no shadow is wanted"};
  }
  if (std::holds_alternative<SpotEmitter>(light.emitter) && tally.dark > 0 && tally.averted <= tally.dark)
    return {"nothing visible is within its cone", "check its `look_at` and `angle`"};
  return {"everything visible faces away from it", "it shines from behind: move it to the camera's side"};
}

} // namespace

void find_coincidences(LintContext& context) {
  for (const auto& [lines, c] : context.survey.coincidences) {
    if (c.count < least_evidence) continue;
    lang::Diagnostic& d = context.findings.warn(lang::lint_rule::coincident, lines.second,
                                                fmt::format("{} and {} share a surface", c.second, c.first));
    d.label = "of the two only the one placed first is seen";
    if (lines.first != lines.second) d.notes.push_back(context.findings.note(lines.first, "the other one is here"));
    d.notes.push_back(
        {std::nullopt, "move one of them slightly, for example by 0.001, or place the one to be seen first"});
  }
}

void find_overlaps(LintContext& context) {
  if (!uses_media(context.scene)) return;
  const auto [width, height] = context.scene.size;
  const double step = std::max(1.0, std::sqrt(static_cast<double>(width) * height / static_cast<double>(survey_rays)));
  std::map<std::pair<Line, Line>, Overlap> overlaps;
  for (double y = step / 2; y < height && !is_stopped(context.options); y += step) {
    for (double x = step / 2; x < width; x += step) {
      const auto hits = context.query.all_hits(context.query.camera().ray(std::floor(x) + 0.5, std::floor(y) + 0.5));
      if (hits.size() < 4) continue;
      const auto inside = intervals(context, hits);
      for (const LineInterval& a : inside) {
        for (const LineInterval& b : inside) {
          const double slack = 1e-6 * (1 + std::abs(b.end));
          const bool is_crossed = a.begin + slack < b.begin && b.begin + slack < a.end && a.end + slack < b.end;
          if (a.hit->order == b.hit->order || !is_crossed || (a.hit->ior == 1 && b.hit->ior == 1)) continue;
          const scene::Object &one = thing_of(objects_on(context.scene, a.hit->path)),
                              &other = thing_of(objects_on(context.scene, b.hit->path));
          const bool is_in_order = line_of(one.origin) <= line_of(other.origin);
          Overlap& overlap = overlaps[std::minmax(line_of(one.origin), line_of(other.origin))];
          if (overlap.count++ > 0) continue;
          overlap.first = context.findings.name(is_in_order ? one : other);
          overlap.second = context.findings.name(is_in_order ? other : one);
        }
      }
    }
  }
  for (const auto& [lines, overlap] : overlaps) {
    if (overlap.count < least_evidence) continue;
    lang::Diagnostic& d = context.findings.warn(
        lang::lint_rule::overlapping_media, lines.second,
        fmt::format("{} and {} overlap, and both are transparent", overlap.second, overlap.first));
    d.label = "it is ambiguous which medium light is in there";
    if (lines.first != lines.second) d.notes.push_back(context.findings.note(lines.first, "the other one is here"));
    d.notes.push_back({std::nullopt, "combine them with `a | b`, cut one out of the other with `b - a`, or "
                                     "put one entirely inside the other"});
  }
}

void find_dark_lights(LintContext& context) {
  if (context.view.hits == 0 || context.is_eye_shut_in) return;
  const auto& lights = context.query.scene().lights();
  const auto is_dark = [](const LightTally& tally) { return !tally.is_lit; };
  if (std::ranges::none_of(context.survey.lights, is_dark)) return;
  const LintSurvey closer = survey_of(context, 10 * survey_rays); // what it reaches may be small
  struct Dark {
    std::size_t first = 0;
    std::uint64_t count = 0;
  };
  std::map<Line, Dark> lines;
  std::set<Line> lit;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Line line = line_of(context.scene.lights[i].origin);
    if (!scene::is_lamp(context.scene.lights[i])) continue;
    if (closer.lights[i].is_lit || context.survey.lights[i].is_lit) {
      lit.insert(line);
    } else if (Dark& dark = lines[line]; dark.count++ == 0) {
      dark.first = i;
    }
  }
  for (const auto& [line, dark] : lines) {
    // In a row of lights some may point elsewhere.
    if (lit.contains(line) || context.shut_in_lights.contains(line)) continue;
    const std::string name = Findings::subject(name_of(context.scene, context.scene.lights[dark.first]), dark.count);
    lang::Diagnostic& d =
        context.findings.warn(lang::lint_rule::dark_light, line, fmt::format("{} reaches nothing visible", name));
    auto [why, advice] = darkness(context, lights[dark.first], closer.lights[dark.first]);
    d.label = std::move(why);
    d.notes.push_back({std::nullopt, std::move(advice)});
  }
}

void find_exposure(LintContext& context) {
  const LintSurvey& s = context.survey;
  if (s.surfaces == 0 || context.is_eye_shut_in) return;
  if (s.black == s.surfaces) {
    lang::Diagnostic& d = context.findings.warn(lang::lint_rule::black_picture, {}, "everything visible is black");
    const bool has_light = !context.scene.lights.empty(), has_ambient = context.scene.ambient != black;
    const std::string lights = has_light ? "no light reaches it" : "there is no light";
    d.notes.push_back(
        {std::nullopt, has_ambient ? fmt::format("{}, and its materials reflect none of the `ambient` light", lights)
                                   : fmt::format("{}, and `ambient` is 0", lights)});
    d.notes.push_back({std::nullopt, has_light ? "`rtlang why` shows what blocks the light of a pixel"
                                               : "add a `sun {}` or a `light { at: … }`"});
    return;
  }
  if (2 * s.clipped <= s.surfaces) return;
  lang::Diagnostic& d = context.findings.warn(
      lang::lint_rule::clipped_picture, {},
      fmt::format("{} of what is visible is brighter than the picture can show", percent(s.clipped, s.surfaces)));
  d.notes.push_back(
      {std::nullopt, "lower the `intensity` of the lights or `ambient`: channels are clipped at 1, and colours shift"});
}

void find_cut_off_rays(LintContext& context) {
  const LintSurvey& s = context.survey;
  if (s.rays == 0 ||
      100.0 * static_cast<double>(s.cut_off) <= context.options.depth_share * static_cast<double>(s.rays))
    return;
  const Line line = most_common(s.cut_off_at);
  lang::Diagnostic& d =
      context.findings.warn(lang::lint_rule::depth_reached, line,
                            fmt::format("{} of the pixels lose light at `max_depth` ({})", percent(s.cut_off, s.rays),
                                        scene::depth_limit(context.scene)));
  d.label = "most of it here";
  d.notes.push_back({std::nullopt, fmt::format("raise it, as in `max_depth: {}`",
                                               2 * std::max(scene::depth_limit(context.scene), 4))});
}

} // namespace rt::tools::explain
