#include "tools/oracle/runs.hpp"
#include "tools/povray/compare/retrace.hpp"

#include <fmt/format.h>

namespace rt::tools::oracle {
namespace {

constexpr double least_equal = 0.9999, least_precise = 0.999, most_refused = 0.01;

// What a run over shapes alone does not cover.
std::vector<std::string> not_looked_at(Mode mode) {
  if (mode == Mode::color) return {"scene.size", "spot.shadows"};
  std::vector<std::string> names{"material",    "pattern",         "light",          "fade",     "scene.",
                                 "transparent", "two transparent", "several lights", "no shadow"};
  const auto add = [&]<class T>() { names.emplace_back(T::noun); };
  scene::LightKinds::for_each(add);
  scene::PatternKinds::for_each(add);
  return names;
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

bool holds(const RunResult& r, Mode mode) {
  const bool has_precision = share(r.depths - r.depths_beyond_p999, r.depths) >= least_precise;
  const bool has_colors = mode == Mode::geometry || share(r.color_equal, r.samples) >= least_equal;
  const bool has_most = share(r.refusals.size(), r.scenes + r.refusals.size()) <= most_refused;
  return r.failures.empty() && has_most && has_precision && has_colors &&
         r.coverage.missing(not_looked_at(mode)).empty();
}

std::string report(const RunResult& r, Mode mode, bool all_pairs) {
  std::string text = fmt::format("scenes {}, {} {}\n", r.scenes, mode == Mode::color ? "pixels" : "rays", r.samples);
  if (!r.refusals.empty())
    text += fmt::format("scenes that POV-Ray cannot compute exactly, left out: {}\n", r.refusals.size());
  text += fmt::format("objects: {} mismatches, {} unexplained\n", r.id_mismatches, r.ids_unexplained);
  text += fmt::format("distances: {} compared, largest relative difference {:.3g}, {:.5f} % within 1e-12\n", r.depths,
                      r.depth_max, 100 * share(r.depths - r.depths_beyond_p999, r.depths));
  text += fmt::format("normals: largest angle {:.3g}\n", r.normal_max);
  if (mode == Mode::color)
    text += fmt::format(
        "colours: {:.5f} % within 1e-5; of the others {} are explained by POV-Ray's limits, {} by rounding, {} not\n",
        100 * share(r.color_equal, r.samples), r.color_explained_by_limits, r.color_explained_by_rounding,
        r.color_unexplained);
  text += r.coverage.report(all_pairs);
  for (const std::string& name : r.coverage.missing(not_looked_at(mode))) text += fmt::format("NEVER: {}\n", name);
  for (const Refusal& refused : r.refusals) text += fmt::format("left out: scene {}: {}\n", refused.scene, refused.why);
  for (const Failure& f : r.failures) text += fmt::format("FAILED: scene {}: {}\n", f.scene, f.what);
  return text + (holds(r, mode) ? "all hold\n" : "NOT ALL HOLD\n");
}

std::string list_explained(const RunResult& r) {
  std::string text;
  for (const auto& [scene, o] : r.explained)
    text += fmt::format("scene {} ({}, {}): {}: colour {:.3g}, with POV-Ray's limits {:.3g}\n", scene, o.x, o.y,
                        povray::cause_name(o.cause), o.color_error, povray::color_difference(o.again, o.theirs));
  return text;
}

} // namespace rt::tools::oracle
