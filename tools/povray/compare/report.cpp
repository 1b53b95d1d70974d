#include "tools/povray/compare/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace rt::tools::povray {
namespace {

constexpr std::size_t lines_of_outliers = 20, json_outliers = 1000;

std::string value_text(const Verdict& v, double value) {
  if (v.name == "color_share") return fmt::format("{:.5f} %", 100 * value);
  return fmt::format("{:.3g}", value);
}

std::string pixel_text(const Report& report, const std::vector<ObjectName>& names, const Outlier& o) {
  std::string text = fmt::format("  ({}, {})  {}: {}", o.x, o.y, cause_name(o.cause),
                                 object_text(*report.description, names, o.our_id));
  if (o.our_id != o.their_id) text += fmt::format("; POV-Ray: {}", object_text(*report.description, names, o.their_id));
  if (o.depth_error > report.gates.depth) text += fmt::format("; distance {:.3g}", o.depth_error);
  if (o.normal_error > report.gates.normals) text += fmt::format("; normal {:.3g}", o.normal_error);
  if (o.color_error > report.gates.color)
    text += fmt::format("; colour {:.3g}: [{:.6g}, {:.6g}, {:.6g}], POV-Ray [{:.6g}, {:.6g}, {:.6g}]", o.color_error,
                        o.ours.r, o.ours.g, o.ours.b, o.theirs.r, o.theirs.g, o.theirs.b);
  if (o.is_traced_again)
    text += fmt::format("; with POV-Ray's limits [{:.6g}, {:.6g}, {:.6g}]", o.again.r, o.again.g, o.again.b);
  return text + "\n";
}

nlohmann::json finite(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}
nlohmann::json color_json(const Rgb32& c) {
  return {c.r, c.g, c.b};
}

} // namespace

std::vector<Verdict> Report::verdicts() const {
  std::vector<Verdict> all = judge(comparison, gates);
  if (!inexact.empty())
    all.push_back({"exact", "things that POV-Ray cannot compute exactly", static_cast<double>(inexact.size()), 0});
  return all;
}

std::string object_text(const scene::Scene& scene, const std::vector<ObjectName>& names, std::uint32_t id) {
  if (id == 0) return "nothing";
  if (id > names.size()) return fmt::format("object {}", id);
  const ObjectName& found = names[id - 1];
  const std::string place = place_text(scene, found.origin);
  return place.empty() ? found.name : fmt::format("{}, {}", found.name, place);
}

std::string report_text(const Report& report) {
  const Comparison& c = report.comparison;
  std::string text =
      fmt::format("{}, {} x {}, against POV-Ray {}\n", report.scene, c.width, c.height, report.povray_version);
  for (const Inexact& i : report.inexact) {
    const std::string place = place_text(*report.description, i.origin);
    text += fmt::format("  not exact: {}{}{}\n", place, place.empty() ? "" : ": ", i.message);
  }
  for (const Verdict& v : report.verdicts()) {
    text += fmt::format("  {:<6} {:<18} {:>12}  {} {:<12} {}\n", v.holds() ? "holds" : "FAILS", v.name,
                        v.is_measured ? value_text(v, v.value) : "-", v.at_least ? "≥" : "≤", value_text(v, v.gate),
                        v.meaning);
  }
  text += fmt::format(
      "  Pixels with another object: {}. Distances compared: {}. Colours within 1/255: {:.4f} %. Largest difference "
      "of colour: {:.3g} at ({}, {}).\n",
      c.id_mismatches, c.depths, 100 * static_cast<double>(c.color_within_8bit) / static_cast<double>(c.pixels),
      c.color_max, c.color_max_x, c.color_max_y);
  if (!report.shots->is_float)
    text += "  POV-Ray wrote no float picture: colours are compared as 16-bit values from 0 to 1.\n";
  const std::vector<ObjectName> names = object_names(*report.description);
  for (std::size_t i = 0; i < std::min(c.outliers.size(), lines_of_outliers); ++i)
    text += pixel_text(report, names, c.outliers[i]);
  if (c.outliers.size() > lines_of_outliers)
    text += fmt::format("  and {} more pixels\n", c.outliers.size() - lines_of_outliers);
  return text;
}

std::string report_json(const Report& report) {
  using nlohmann::json;
  const Comparison& c = report.comparison;
  json gates = json::array();
  for (const Verdict& v : report.verdicts())
    gates.push_back({{"name", v.name},
                     {"meaning", v.meaning},
                     {"value", v.is_measured ? finite(v.value) : json(nullptr)},
                     {v.at_least ? "at_least" : "at_most", v.gate},
                     {"holds", v.holds()}});
  json inexact = json::array();
  for (const Inexact& i : report.inexact)
    inexact.push_back({{"message", i.message}, {"place", place_text(*report.description, i.origin)}});
  const std::vector<ObjectName> names = object_names(*report.description);
  json outliers = json::array();
  for (std::size_t i = 0; i < std::min(c.outliers.size(), json_outliers); ++i) {
    const Outlier& o = c.outliers[i];
    json entry{{"pixel", {o.x, o.y}},
               {"cause", cause_name(o.cause)},
               {"explained", is_explained(o.cause)},
               {"object", object_text(*report.description, names, o.our_id)},
               {"povray_object", object_text(*report.description, names, o.their_id)},
               {"distance_error", finite(o.depth_error)},
               {"normal_error", finite(o.normal_error)},
               {"color_error", finite(o.color_error)},
               {"color", color_json(o.ours)},
               {"povray_color", color_json(o.theirs)}};
    if (o.is_traced_again) entry["color_with_povray_limits"] = color_json(o.again);
    outliers.push_back(std::move(entry));
  }
  return json{{"scene", report.scene},
              {"size", {c.width, c.height}},
              {"povray", report.povray_version},
              {"holds", report.holds()},
              {"gates", gates},
              {"inexact", inexact},
              {"pixels_with_another_object", c.id_mismatches},
              {"distances_compared", c.depths},
              {"colors_within_8_bits", c.color_within_8bit},
              {"colors_equal", c.color_equal},
              {"largest_color_difference", {{"value", finite(c.color_max)}, {"pixel", {c.color_max_x, c.color_max_y}}}},
              {"float_colors", report.shots->is_float},
              {"render_seconds", report.render_seconds},
              {"povray_seconds", report.povray_seconds},
              {"outlier_count", c.outliers.size()},
              {"outliers", outliers}}
             .dump(2) +
         "\n";
}

} // namespace rt::tools::povray
