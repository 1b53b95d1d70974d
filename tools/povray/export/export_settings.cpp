#include "renderer/scene/scene.hpp"
#include "tools/povray/export/export_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::tools::povray {
namespace {

// POV-Ray's own limit; it clamps greater numbers.
constexpr int most_trace_levels = 256;

} // namespace

void write_introduction(Writer& out, const scene::Scene& scene) {
  out.comment("Exported from a rtlang scene for POV-Ray 3.7. Linear colours, one ray through each pixel's centre:");
  out.comment(fmt::format("povray +Iscene.pov +W{} +H{} -A File_Gamma=1.0", scene.size[0], scene.size[1]));
  if (const int samples = scene::whitted_samples(scene); samples > 1) {
    out.comment(fmt::format("For its {} samples each pixel, render it that many times as large (the root of it each "
                            "way)",
                            samples));
    out.comment("and take the mean of each square of pixels.");
  }
  if (const ToneMapping tones = scene::tone_mapping(scene); tones != ToneMapping{})
    out.comment(
        fmt::format("This is the linear picture; in 8 and 16 bits rtlang shows it with exposure {} and tone {}.",
                    tones.exposure, tones.tone == Tone::filmic ? "filmic" : "clip"));
  if (std::ranges::any_of(scene.shapes.all<scene::Triangle>(), [](const auto& t) { return !t.normals.empty(); })) {
    out.comment(
        "Where the interpolated normal of a triangle faces away from the viewer, as at a rim, POV-Ray lights it");
    out.comment("from the other side. rtlang does not.");
  }
}

void write_settings(Writer& out, const scene::Scene& scene, double bailout, std::vector<Inexact>& inexact) {
  const int depth = scene::depth_limit(scene);
  out.line("#version 3.7;");
  if (depth + 1 > most_trace_levels)
    inexact.push_back(
        {fmt::format("POV-Ray follows a ray {} times at most, `max_depth` is {}", most_trace_levels - 1, depth), {}});
  out.open("global_settings");
  out.line("assumed_gamma 1.0");
  out.line(fmt::format("max_trace_level {}", std::min(depth + 1, most_trace_levels)));
  out.line("adc_bailout " + number(bailout));
  out.line("ambient_light " + rgb(scene.ambient));
  out.close();
}

} // namespace rt::tools::povray
