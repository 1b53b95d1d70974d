#include "renderer/image/image.hpp"
#include "tools/povray/compare/heat.hpp"
#include "tools/povray/compare/report.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::tools::povray {
namespace {

constexpr std::size_t enlarged_pixels = 24;

// A template: words in percent signs are replaced.
constexpr std::string_view page = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>%TITLE%: check against POV-Ray</title>
<style>
  :root { color-scheme: light dark; --line: #8885; --bad: #c22; --good: #2a7d3c; }
  @media (prefers-color-scheme: dark) { :root { --bad: #f77; --good: #7c8; } }
  body { font: 15px/1.45 system-ui, sans-serif; max-width: 72rem; margin: 1.5rem auto; padding: 0 1rem; }
  h1 { font-size: 1.35rem; margin: 0 0 .2rem; } h2 { font-size: 1.05rem; margin: 1.6rem 0 .5rem; }
  table { border-collapse: collapse; } th, td { text-align: left; padding: .2rem .9rem .2rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
  td.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
  .wide { overflow-x: auto; }
  .good { color: var(--good); font-weight: 600; } .bad { color: var(--bad); font-weight: 600; }
  fieldset { border: 0; padding: 0; margin: 0 0 .6rem; display: flex; flex-wrap: wrap; gap: .2rem 1.1rem; }
  #stage { position: relative; width: min(100%, %STAGE%px); aspect-ratio: %WIDTH% / %HEIGHT%; background: #000; touch-action: pan-y; }
  #stage img { position: absolute; inset: 0; width: 100%; height: 100%; image-rendering: pixelated; }
  #cut { position: absolute; top: 0; bottom: 0; width: 2px; background: #fff; mix-blend-mode: difference; pointer-events: none; }
  #share { width: min(100%, %STAGE%px); margin: .4rem 0 0; display: block; }
  .legend { display: inline-block; height: .8rem; width: 16rem; vertical-align: middle; background: linear-gradient(to right, %LEGEND%); }
  .zoom { display: flex; flex-wrap: wrap; gap: 1.2rem; }
  .zoom figure { margin: 0; width: 21rem; } .zoom canvas { width: 10rem; height: 10rem; image-rendering: pixelated; border: 1px solid var(--line); }
  figcaption { font-size: .85rem; } code { font-size: .95em; }
</style>
</head>
<body>
<h1>%TITLE%</h1>
<p>%SUMMARY%</p>
%INEXACT%
<div class="wide"><table>
<thead><tr><th></th><th>gate</th><th>value</th><th>bound</th><th>meaning</th></tr></thead>
<tbody>
%GATES%</tbody>
</table></div>
<h2>Pictures</h2>
<fieldset id="views">
  <label><input type="radio" name="view" value="slider" checked> slider: ours left, POV-Ray right</label>
  <label><input type="radio" name="view" value="ours"> ours</label>
  <label><input type="radio" name="view" value="theirs"> POV-Ray</label>
  <label><input type="radio" name="view" value="color"> difference of colour</label>
  <label><input type="radio" name="view" value="objects"> other objects</label>
  <label><input type="radio" name="view" value="distance"> difference of distance</label>
  <label><input type="radio" name="view" value="normals"> difference of normals</label>
</fieldset>
<div id="stage">
  <img id="theirs" alt="the picture by POV-Ray" src="%THEIRS%">
  <img id="ours" alt="our picture" src="%OURS%">
  <img id="color" alt="map of the differences of colour" src="%COLOR%" hidden>
  <img id="objects" alt="pixels with another object, white" src="%OBJECTS%" hidden>
  <img id="distance" alt="map of the relative differences of distance" src="%DISTANCE%" hidden>
  <img id="normals" alt="map of the angles between normals" src="%NORMALS%" hidden>
  <div id="cut"></div>
</div>
<input id="share" type="range" min="0" max="1000" value="500" aria-label="position of the divider">
<p>Maps: 0 is black; <code>1e-8</code> <span class="legend"></span> <code>1</code>, logarithmic.</p>
<h2>Worst pixels</h2>
%OUTLIERS%
<script>
const find = id => document.getElementById(id);
const layers = ["theirs", "ours", "color", "objects", "distance", "normals"];
function show() {
  const view = document.querySelector("input[name=view]:checked").value, share = find("share").value / 10;
  const slides = view === "slider";
  for (const id of layers) find(id).hidden = slides ? id !== "ours" && id !== "theirs" : id !== view;
  find("ours").style.clipPath = slides ? `inset(0 ${100 - share}% 0 0)` : "";
  find("cut").hidden = !slides;
  find("cut").style.left = `${share}%`;
  find("share").disabled = !slides;
}
find("views").addEventListener("change", show);
find("share").addEventListener("input", show);
for (const name of ["pointerdown", "pointermove"]) find("stage").addEventListener(name, event => {
  if (event.buttons !== 1) return;
  event.preventDefault();
  const box = find("stage").getBoundingClientRect();
  find("share").value = 1000 * (event.clientX - box.left) / box.width;
  show();
});
function enlarge() {
  const side = 15, scale = 16;
  for (const canvas of document.querySelectorAll("canvas")) {
    const { x, y, of } = canvas.dataset, image = find(of);
    canvas.width = canvas.height = side * scale;
    const context = canvas.getContext("2d");
    context.imageSmoothingEnabled = false;
    context.drawImage(image, x - 7, y - 7, side, side, 0, 0, side * scale, side * scale);
    context.strokeStyle = "#fff";
    context.strokeRect(7 * scale - .5, 7 * scale - .5, scale + 1, scale + 1);
    context.strokeStyle = "#000";
    context.strokeRect(7 * scale - 1.5, 7 * scale - 1.5, scale + 3, scale + 3);
  }
}
show();
addEventListener("load", enlarge);
</script>
</body>
</html>
)html";

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

std::string picture(const Film& film) {
  return "data:image/png;base64," + base64(encode(film, ImageFormat::png, {}));
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string css(const Rgb32& c) {
  const auto byte = [](float v) { return static_cast<int>(std::lround(255 * linear_to_srgb(v))); };
  return fmt::format("rgb({} {} {})", byte(c.r), byte(c.g), byte(c.b));
}

std::string legend() {
  std::string text;
  for (int power = -8; power <= 0; ++power) text += (power > -8 ? ", " : "") + css(heat(std::pow(10.0, power)));
  return text;
}

Film object_map(const Report& r) {
  std::vector<Rgb32> color(r.film->object_id.size());
  for (std::size_t i = 0; i < color.size(); ++i)
    if (r.film->object_id[i] != r.shots->ids[i]) color[i] = {1, 1, 1};
  return film_of(std::move(color), r.film->width, r.film->height);
}

std::string gate_rows(const Report& report) {
  std::string text;
  for (const Verdict& v : report.verdicts()) {
    const auto number = [&](double value) {
      return v.name == "color_share" ? fmt::format("{:.5f} %", 100 * value) : fmt::format("{:.3g}", value);
    };
    text += fmt::format("<tr><td class=\"{}\">{}</td><td><code>{}</code></td><td class=\"number\">{}</td><td "
                        "class=\"number\">{} {}</td>"
                        "<td>{}</td></tr>\n",
                        v.holds() ? "good" : "bad", v.holds() ? "holds" : "fails", v.name,
                        v.is_measured ? number(v.value) : "not measured", v.at_least ? "≥" : "≤", number(v.gate),
                        escaped(v.meaning));
  }
  return text;
}

std::string figure(const Report& report, const std::vector<ObjectName>& names, const Outlier& o) {
  const auto canvas = [&](const char* of) {
    return fmt::format("<canvas data-x=\"{}\" data-y=\"{}\" data-of=\"{}\"></canvas>", o.x, o.y, of);
  };
  const auto values = [](const Rgb32& c) { return fmt::format("{:.6g}, {:.6g}, {:.6g}", c.r, c.g, c.b); };
  const std::string object = object_text(*report.description, names, o.our_id);
  const std::string other = object_text(*report.description, names, o.their_id);
  std::string text = fmt::format("<figure>{}{}<figcaption><b>({}, {})</b> <span class=\"{}\">{}</span><br>{}",
                                 canvas("ours"), canvas("theirs"), o.x, o.y, is_explained(o.cause) ? "good" : "bad",
                                 cause_name(o.cause), escaped(object));
  if (o.our_id != o.their_id) text += fmt::format("; POV-Ray: {}", escaped(other));
  text += fmt::format("<br>ours <code>{}</code><br>POV-Ray <code>{}</code>", values(o.ours), values(o.theirs));
  if (o.is_traced_again) text += fmt::format("<br>with its limits <code>{}</code>", values(o.again));
  if (o.depth_error > 0) text += fmt::format("<br>distance {:.3g}", o.depth_error);
  if (o.normal_error > 0) text += fmt::format(", normal {:.3g}", o.normal_error);
  return text + "</figcaption></figure>\n";
}

std::string outliers(const Report& report) {
  const auto& all = report.comparison.outliers;
  if (all.empty()) return "<p>None.</p>";
  const std::vector<ObjectName> names = object_names(*report.description);
  std::string text = fmt::format("<p>{} of {} pixels; ours left, POV-Ray's right.</p>\n<div class=\"zoom\">\n",
                                 all.size(), report.comparison.pixels);
  for (std::size_t i = 0; i < std::min(all.size(), enlarged_pixels); ++i) text += figure(report, names, all[i]);
  return text + "</div>";
}

std::string inexact(const Report& report) {
  if (report.inexact.empty()) return {};
  std::string text = "<p class=\"bad\">POV-Ray cannot compute exactly:</p>\n<ul>\n";
  for (const Inexact& i : report.inexact)
    text += fmt::format("<li>{} {}</li>\n", escaped(place_text(*report.description, i.origin)), escaped(i.message));
  return text + "</ul>";
}

std::string filled(const std::vector<std::pair<std::string_view, std::string>>& words) {
  std::string result;
  for (std::size_t at = 0; at < page.size();) {
    std::size_t next = page.size();
    const std::pair<std::string_view, std::string>* found = nullptr;
    for (const auto& word : words) {
      const std::size_t place = page.find(word.first, at);
      if (place < next) next = place, found = &word;
    }
    result += page.substr(at, next - at);
    at = next;
    if (found) result += found->second, at += found->first.size();
  }
  return result;
}

} // namespace

std::string report_html(const Report& r) {
  const Comparison& c = r.comparison;
  const bool holds = r.holds();
  const std::string summary = fmt::format("<span class=\"{}\">{}</span> {} × {} pixels, in {:.2f} s by rtlang and "
                                          "{:.2f} s by POV-Ray {}, side by side. Largest "
                                          "difference of colour {:.3g} at ({}, {}).",
                                          holds ? "good" : "bad", holds ? "Every gate holds." : "A gate fails.",
                                          c.width, c.height, r.render_seconds, r.povray_seconds,
                                          escaped(r.povray_version), c.color_max, c.color_max_x, c.color_max_y);
  return filled({{"%TITLE%", escaped(r.scene)},
                 {"%SUMMARY%", summary},
                 {"%STAGE%", std::to_string(std::max(c.width, 640))},
                 {"%WIDTH%", std::to_string(c.width)},
                 {"%HEIGHT%", std::to_string(c.height)},
                 {"%LEGEND%", legend()},
                 {"%INEXACT%", inexact(r)},
                 {"%GATES%", gate_rows(r)},
                 {"%OURS%", picture(film_of(r.film->color, c.width, c.height))},
                 {"%THEIRS%", picture(film_of(r.shots->color, c.width, c.height))},
                 {"%COLOR%", picture(heat_map(c.color_error, c.width, c.height))},
                 {"%OBJECTS%", picture(object_map(r))},
                 {"%DISTANCE%", picture(heat_map(c.depth_error, c.width, c.height))},
                 {"%NORMALS%", picture(heat_map(c.normal_error, c.width, c.height))},
                 {"%OUTLIERS%", outliers(r)}});
}

} // namespace rt::tools::povray
