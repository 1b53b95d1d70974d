#include "renderer/image/file.hpp"
#include "renderer/image/image.hpp"
#include "tools/diff/diff.hpp"
#include "tools/povray/compare/heat.hpp"
#include "tools/rtlang/commands.hpp"
#include "tools/rtlang/gate_arguments.hpp"
#include "tools/terminal/console.hpp"
#include "tools/terminal/exit_code.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace rt::tools {
namespace {

struct DiffArguments {
  std::string a, b;
  std::string heat;
  std::vector<std::string> gates;
  bool is_json = false;
  bool is_linear = false;
};

struct Measure {
  std::string_view name;
  double value;
  bool at_least;
  std::string_view meaning;
};

std::vector<Measure> measures(const Difference& d) {
  const double pixels = static_cast<double>(d.color_error.size());
  std::vector<Measure> all{
      {"max", d.color_max, false, "largest difference of a linear colour"},
      {"equal", static_cast<double>(d.color_equal) / pixels, true, "fraction of pixels within 1e-5, linear"},
      {"equal_8bit", static_cast<double>(d.color_within_8bit) / pixels, true, "share of pixels within 1/255, as shown"},
      {"rmse", d.rmse, false, "root mean square difference, as shown, on a scale of 0 to 1"},
      {"psnr", d.psnr, true, "peak signal-to-noise ratio, decibels"},
      {"ssim", d.ssim, true, "structural similarity of the luma, 1 for equal pictures"},
  };
  if (d.layers) {
    all.push_back({"objects", static_cast<double>(d.layers->other_object), false, "pixels with another object"});
    all.push_back({"depth", d.layers->depth_max, false, "largest relative difference of distance"});
    all.push_back({"normals", d.layers->normal_max, false, "largest angle between normals, radians"});
  }
  return all;
}

// If no gates are given, pictures must be identical.
std::vector<std::optional<double>> bounds(const std::vector<Measure>& all, const std::vector<std::string>& given) {
  std::vector<double> values(all.size(), std::nan(""));
  std::vector<NamedNumber> known;
  for (std::size_t i = 0; i < all.size(); ++i) known.push_back({all[i].name, &values[i]});
  set_gates(given.empty() ? std::vector<std::string>{"max=0"} : given, known);
  std::vector<std::optional<double>> result;
  for (const double v : values) result.push_back(std::isnan(v) ? std::nullopt : std::optional(v));
  return result;
}

bool holds(const Measure& m, double bound) {
  return m.at_least ? m.value >= bound : m.value <= bound;
}

std::string as_text(const std::vector<Measure>& all, const std::vector<std::optional<double>>& gates,
                    const Difference& d) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Measure& m = all[i];
    const std::string gate = gates[i] ? fmt::format("{} {:<8.4g} {}", m.at_least ? "≥" : "≤", *gates[i],
                                                    holds(m, *gates[i]) ? "holds" : "FAILS")
                                      : "";
    text += fmt::format("{:<10} {:>12.6g}  {:<16}  {}\n", m.name, m.value, gate, m.meaning);
  }
  if (d.color_max > 0) text += fmt::format("The largest difference is at ({}, {}).\n", d.color_max_x, d.color_max_y);
  return text;
}

std::string as_json(const std::vector<Measure>& all, const std::vector<std::optional<double>>& gates,
                    const Difference& d, bool good) {
  nlohmann::json measures = nlohmann::json::object();
  for (std::size_t i = 0; i < all.size(); ++i) {
    nlohmann::json& entry = measures[std::string(all[i].name)];
    entry["value"] = std::isfinite(all[i].value) ? nlohmann::json(all[i].value) : nlohmann::json(nullptr);
    if (gates[i])
      entry[all[i].at_least ? "at_least" : "at_most"] = *gates[i], entry["holds"] = holds(all[i], *gates[i]);
  }
  return nlohmann::json{{"size", {d.width, d.height}},
                        {"holds", good},
                        {"measures", measures},
                        {"largest_at", {d.color_max_x, d.color_max_y}}}
             .dump(2) +
         "\n";
}

int run_diff(const DiffArguments& arguments) {
  const Transfer assumed = arguments.is_linear ? Transfer::linear : Transfer::srgb;
  const Image a = read_image(arguments.a, assumed), b = read_image(arguments.b, assumed);
  if (a.width != b.width || a.height != b.height) {
    print_error(fmt::format("rtlang: the pictures have different sizes: {} x {} and {} x {}\n", a.width, a.height,
                            b.width, b.height));
    return exit_scene_is_wrong;
  }
  const Difference d = difference(a, b);
  const std::vector<Measure> all = measures(d);
  const std::vector<std::optional<double>> gates = bounds(all, arguments.gates);
  if (!arguments.heat.empty()) {
    const auto format = format_of(arguments.heat);
    if (!format) throw UsageError(fmt::format("`{}` does not end in .png, .exr, .ppm or .pfm", arguments.heat));
    replace_file(arguments.heat, encode(heat_map(d.color_error, d.width, d.height), *format, {}));
  }
  bool good = true;
  for (std::size_t i = 0; i < all.size(); ++i) good = good && (!gates[i] || holds(all[i], *gates[i]));
  print(arguments.is_json ? as_json(all, gates, d, good) : as_text(all, gates, d));
  return good ? exit_fine : exit_scene_is_wrong;
}

} // namespace

Action declare_diff(CLI::App& app) {
  auto arguments = std::make_shared<DiffArguments>();
  app.add_option("A", arguments->a, "a picture: png, exr, ppm or pfm")->required()->group("");
  app.add_option("B", arguments->b, "another of the same size")->required()->group("");
  app.add_option("-o,--output", arguments->heat, "writes a difference map, logarithmic from 1e-8 to 1")
      ->type_name("PICTURE");
  app.add_option("--gate", arguments->gates, "a threshold, instead of max=0 (repeatable)")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_flag("--linear", arguments->is_linear, "takes integer samples of untagged files as linear light, not sRGB");
  app.add_flag("--json", arguments->is_json, "prints the result as JSON");
  app.footer(
      "The exit code is 0 if every gate holds, 1 if not. Gates: max, equal, equal_8bit, rmse, psnr, ssim; also "
      "objects, "
      "depth and normals if both pictures are exr files with layers. Measures \"as shown\" are of sRGB values from 0 "
      "to 1.");
  return [arguments] { return run_diff(*arguments); };
}

} // namespace rt::tools
