#include "tools/explain/why/why_surface.hpp"

#include "renderer/compile/geometries.hpp"
#include "renderer/scene/names.hpp"
#include "renderer/shading/optics.hpp"
#include "tools/explain/naming.hpp"
#include "tools/explain/why/pattern_readings.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::tools::explain {
namespace {

std::string text_of(const Quantity& q) {
  const std::string value = std::holds_alternative<double>(q.value) ? number_text(std::get<double>(q.value))
                                                                    : vector_text(std::get<Vec3>(q.value));
  return fmt::format("{} = {}", q.label, value);
}

std::string agreement_text(const Derivation& d) {
  if (d.disagreement == 0) return "the renderer has the same t";
  const std::string part = fmt::format("the renderer's t differs by {:.0e} of itself", d.disagreement);
  return d.disagreement < 1e-6 ? part : part + ": it avoids the cancellation in these formulas";
}

void write_derivation(const Derivation& d, Page& page, int indent) {
  page.line(indent, fmt::format("{}: {}", d.shape, d.equation));
  if (d.is_own_space)
    page.line(indent + 2, fmt::format("in object space, where t is the same: o = {}, d = {}", vector_text(d.ray.origin),
                                      vector_text(d.ray.direction)));
  for (const DerivationLine& line : d.lines) {
    std::string text;
    for (const Quantity& q : line.quantities) text += (text.empty() ? "" : ", ") + text_of(q);
    const bool is_comparison =
        line.words.starts_with('<') || line.words.starts_with('>') || line.words.starts_with("≤");
    if (!line.words.empty()) text += (text.empty() ? "" : is_comparison ? " " : ": ") + line.words;
    page.line(indent + 2, text);
  }
  page.line(indent + 2, (d.choice.empty() ? "" : d.choice + "; ") + agreement_text(d));
}

std::string text_of(const LineIntervals& intervals) {
  if (intervals.empty()) return "nowhere";
  constexpr std::size_t most = 6;
  std::string text = "for t in ";
  for (std::size_t i = 0; i < std::min(intervals.size(), most); ++i)
    text += fmt::format("{}[{}, {}]", i == 0 ? "" : " and ", number_text(intervals[i].enter),
                        number_text(intervals[i].leave));
  if (intervals.size() > most) text += fmt::format(" and {} more", intervals.size() - most);
  return text;
}

void write_combination(const Answer& answer, const SurfaceNode& s, const CombinationIntervals& c, Page& page,
                       int indent) {
  constexpr std::size_t most = 12;
  page.line(indent, fmt::format("{} of solids, each a list of intervals of the line", noun(c.operation)));
  std::size_t written = 0, missed = 0;
  for (std::size_t i = 0; i < c.operands.size(); ++i) {
    const OperandIntervals& operand = c.operands[i];
    const bool decides = i == 0 && c.operation == scene::Combination::Operation::subtract;
    if ((operand.inside.empty() && !decides && c.operation != scene::Combination::Operation::intersect) ||
        written >= most) {
      ++missed;
      continue;
    }
    ++written;
    const bool is_taken_away = c.operation == scene::Combination::Operation::subtract && i > 0;
    page.line(indent + 2, fmt::format("{}{}: inside {}", is_taken_away ? "less " : "",
                                      answer.namer.object(*operand.object), text_of(operand.inside)));
  }
  if (missed > 0)
    page.line(indent + 2, fmt::format("and {} more that {}", missed,
                                      written >= most ? "are not listed" : "the line does not meet"));
  page.line(indent + 2, fmt::format("together: inside {}", text_of(c.inside)));
  const auto objects = objects_on(answer.scene, s.path);
  const std::string operand = answer.namer.whole(std::span<const scene::Object* const>(objects).subspan(c.depth + 1));
  std::string words = fmt::format("the first end ahead is t = {}, on the surface of {}", number_text(s.hit.t), operand);
  if (s.hit.is_flipped) words += ", which is subtracted: its normal is flipped";
  page.line(indent + 2, words);
}

std::string_view side_text(const Answer& answer, const SurfaceNode& s) {
  const bool is_front = dot(s.surface.normal, s.ray.direction) < 0;
  const scene::ShapeRef shape = objects_on(answer.scene, s.path).back()->shape;
  const bool has_inside = answer.scene.shapes.visit(shape, []<class S>(const S& described) -> bool {
    if constexpr (scene::is_composite<S>)
      return true;
    else
      return is_solid(geometry(described));
  });
  if (has_inside) return is_front ? "from outside" : "from inside";
  return is_front ? "on the side that its normal points to" : "on the side that its normal points away from";
}

std::string material_text(const SurfaceNode& s) {
  const MaterialValues& m = s.material;
  std::string text =
      fmt::format("c = color = {}, a = 1 − refract = {}", color_text(m.color), number_text(1 - m.refract));
  return text;
}

// "n·l = 0.8 (36.87°)"
std::string cosine_text(std::string_view name, double cosine) {
  return fmt::format("{} = {} ({})", name, number_text(cosine), angle_text(cosine));
}

// Of a light, or of a branch.
std::string left_out_text(const Answer& answer, double weight) {
  return fmt::format("not traced: its weight is at most {} of white, within the allowance of min_weight {}",
                     number_text(weight), number_text(scene::min_weight(answer.scene)));
}

std::string left_out_text(const Answer& answer, const LeftOut& left_out) {
  return fmt::format("{}; the mean of what the other rays bring, {}, stands for it",
                     left_out_text(answer, left_out.weight), color_text(left_out.estimate));
}

std::string in_the_way_text(const Answer& answer, const LightNode& light) {
  if (light.in_the_way.empty()) return "nothing is in the way";
  const InTheWay& last = light.in_the_way.back();
  if (last.transmittance == black)
    return fmt::format("{} blocks it at distance {}", answer.namer.whole(last.path), number_text(last.distance));
  return fmt::format("filter {} by {} surface{} on the way", color_text(light.record.filter), light.in_the_way.size(),
                     light.in_the_way.size() == 1 ? "" : "s");
}

void write_filters(const Answer& answer, const LightNode& light, Page& page, int indent) {
  constexpr std::size_t most = 8;
  if (light.in_the_way.empty() || (light.in_the_way.size() == 1 && light.in_the_way[0].transmittance == black)) return;
  for (std::size_t i = 0; i < std::min(light.in_the_way.size(), most); ++i) {
    const InTheWay& w = light.in_the_way[i];
    page.line(indent, fmt::format("{} at distance {} {}", answer.namer.whole(w.path), number_text(w.distance),
                                  w.transmittance == black ? "blocks it" : "transmits " + color_text(w.transmittance)));
  }
  if (light.in_the_way.size() > most) page.line(indent, fmt::format("and {} more", light.in_the_way.size() - most));
}

bool fades(const scene::LightSource& source) {
  return std::visit(
      [](const auto& light) {
        if constexpr (requires { light.fade; })
          return light.fade.law != scene::Fade::Law::none;
        else
          return false;
      },
      source);
}

bool has_cone(const scene::LightSource& source) {
  return std::holds_alternative<scene::SpotLight>(source);
}

std::string where_text(const scene::LightSource& source, const LightSample& sample) {
  std::string text =
      std::isinf(sample.distance) ? "infinitely far" : fmt::format("distance {}", number_text(sample.distance));
  if (fades(source)) text += fmt::format(", fade {}", number_text(sample.fade));
  if (has_cone(source)) text += fmt::format(", in the cone {}", number_text(sample.spot));
  return text;
}

void write_light(const Answer& answer, const SurfaceNode& s, const LightNode& node, Page& page, int indent) {
  const LightRecord& r = node.record;
  const Light& light = answer.compiled.lights()[r.light];
  const scene::LightSource& source = answer.scene.lights[r.light].source;
  const MaterialValues& m = s.material;
  const std::string name = fmt::format("{}: {}", answer.namer.light(r.light), where_text(source, r.sample));
  if (!scene::is_lamp(answer.scene.lights[r.light]))
    return page.line(indent, answer.namer.light(r.light) + ": it lights surfaces only in path mode");
  if (r.sample.distance == 0) return page.line(indent, name + ": it is at this very point and does not light it");
  if (!(r.cos_light > 0))
    return page.line(indent, fmt::format("{}, {}: the surface faces away", name, cosine_text("n·l", r.cos_light)));
  const std::string facing = fmt::format("{}, {}", name, cosine_text("n·l", r.cos_light));
  if (r.sample.color == black)
    return page.line(indent,
                     fmt::format("{}: {}", facing, r.sample.spot == 0 ? "outside its cone" : "it gives no light"));
  if (r.left_out > 0) return page.line(indent, fmt::format("{}: {}", facing, left_out_text(answer, r.left_out)));
  page.line(indent,
            fmt::format("{}; {}", facing,
                        light.shadows ? in_the_way_text(answer, node) : "nothing can block it (shadows: false)"));
  write_filters(answer, node, page, indent + 2);
  if (r.filter == black) return;
  const Color arriving = r.sample.color * r.filter;
  page.line(indent + 2, fmt::format("C_L = color·intensity{}{}{} = {}", fades(source) ? "·fade" : "",
                                    has_cone(source) ? "·cone" : "", node.in_the_way.empty() ? "" : "·filter",
                                    color_text(arriving)));
  page.line(indent + 2,
            fmt::format("diffuse = C_L·a·c·{}·(n·l) = {}", color_text(m.diffuse), color_text(r.reflected.diffuse)));
  if (m.specular == 0) return;
  if (!light.shadows) return page.line(indent + 2, "no highlight: a light without shadows gives none");
  const bool is_blinn = m.highlight == scene::Highlight::blinn;
  const std::string cosine = cosine_text(is_blinn ? "n·h" : "r·l", r.reflected.cos_highlight);
  if (!(r.reflected.cos_highlight > 0)) return page.line(indent + 2, fmt::format("no highlight: {}", cosine));
  page.line(indent + 2, fmt::format("{}, highlight = C_L·{}·({})^{}{} = {}", cosine, number_text(m.specular),
                                    is_blinn ? "n·h" : "r·l", number_text(m.shininess),
                                    m.metallic != 0 ? "·M with M = " + color_text(r.reflected.tint) : "",
                                    color_text(r.reflected.highlight)));
}

// "color: a gradient at [0, 0.4, 0] of its own space; its value is 0.4, in its stops 0.4, …"
std::string text_of(const PatternReading& r) {
  std::string text = fmt::format("{}: `{}` at {} of its own space", r.property, r.noun, vector_text(r.point));
  if (r.in_stops)
    text += fmt::format(", value {}, place {} in its stops, {} of the way from one to the next",
                        number_text(r.in_stops->value), number_text(r.in_stops->place), number_text(r.in_stops->share));
  return fmt::format("{}, shows {}", text, color_text(r.shown));
}

} // namespace

Derivation derivation_of(const Answer& answer, const SurfaceNode& s) {
  const auto objects = objects_on(answer.scene, s.path);
  const bool is_of_combination = std::any_of(objects.begin(), objects.end(), [](const scene::Object* o) {
    return o->shape.kind == scene::kind_of<scene::Combination>;
  });
  return derive(answer.scene, s.path, s.ray, s.hit, is_of_combination);
}

std::optional<CombinationIntervals> intervals_of(const Answer& answer, const SurfaceNode& s) {
  return intervals_along(answer.scene, s.path, s.ray);
}

void write_meeting(const Answer& answer, const SurfaceNode& s, Page& page, int indent) {
  if (!s.touching.empty()) {
    std::vector<std::string> names;
    for (const auto& path : s.touching) names.push_back(answer.namer.whole(path));
    page.line(indent, fmt::format("hits {} coincident surfaces, closer to each other than rounding can tell: {}",
                                  names.size(), list_text(names)));
  }
  page.line(indent, fmt::format("meets {} at t = {}, {}, {}", answer.namer.whole(s.path), number_text(s.hit.t),
                                vector_text(s.surface.position), side_text(answer, s)));
  if (s.absorbed)
    page.line(indent + 2, fmt::format("absorb: {} of the light is left after {} inside", color_text(s.absorbed->left),
                                      number_text(s.absorbed->length)));
}

void write_derivation(const Answer& answer, const SurfaceNode& s, Page& page, int indent) {
  if (const auto intervals = intervals_of(answer, s)) write_combination(answer, s, *intervals, page, indent);
  write_derivation(derivation_of(answer, s), page, indent);
}

void write_normal(const Answer& answer, const SurfaceNode& s, Page& page, int indent) {
  const bool is_own = s.surface.shading_normal == s.surface.normal;
  const bool is_bent = is_bumpy(answer.scene, s.surface);
  const std::string origin =
      is_own ? ""
             : fmt::format(", {} (the face's own is {})", is_bent ? "bent by `bump`" : "from the corners' normals",
                           vector_text(s.surface.normal));
  page.line(indent, fmt::format("unit normal to the viewer n = {}{}", vector_text(s.normal), origin));
}

void write_shading(const Answer& answer, const SurfaceNode& s, Page& page, int indent) {
  const MaterialValues& m = s.material;
  page.line(indent, fmt::format("shading with {}", material_text(s)));
  for (const PatternReading& r : pattern_readings(answer.scene, s.surface))
    page.line(indent + 2 + 2 * r.depth, text_of(r));
  page.line(indent + 2, fmt::format("ambient = a·c·{}·{} = {}", color_text(m.ambient),
                                    color_text(answer.compiled.ambient()), color_text(s.ambient)));
  if (m.emission != black)
    page.line(indent + 2, fmt::format("emission = a·c·{} = {}", color_text(m.emission), color_text(s.emission)));
  for (const LightNode& light : s.lights) write_light(answer, s, light, page, indent + 2);
  if (s.lights.empty()) page.line(indent + 2, "there is no light");
  page.line(indent + 2, fmt::format("together {}{}", color_text(s.shading()),
                                    s.passed == white ? ""
                                                      : fmt::format(", of which the surfaces before it transmit {}",
                                                                    color_text(s.passed * s.shading()))));
}

void write_mirror(const Answer& answer, const SurfaceNode& s, Page& page, int indent) {
  const MirrorNode& mirror = *s.mirror;
  const MaterialValues& m = s.material;
  std::string formula = "reflect";
  if (m.fresnel) formula += "·R_F";
  if (m.metallic != 0) formula += "·M";
  if (m.coat > 0) formula += fmt::format(" + {}·R_F({})", number_text(m.coat), number_text(m.coat_ior));
  page.line(indent,
            fmt::format("mirrored in {}: in and out at {} to the normal, weight ρ = {} = {}",
                        answer.namer.title(s.path), angle_text(mirror.cosine), formula, color_text(mirror.rho)));
  if (m.fresnel) {
    const double c = mirror.cosine, g2 = mirror.eta * mirror.eta + c * c - 1;
    page.line(indent + 2,
              fmt::format("Fresnel: η = {} (other side / this side), c = cos θ = {}, g² = η² + c² − 1 = {}, R_F = {}",
                          number_text(mirror.eta), number_text(c), number_text(g2), number_text(mirror.reflectance)));
  }
  if (m.metallic != 0)
    page.line(indent + 2,
              fmt::format("metallic {}: M = {}, reflect = {}", number_text(m.metallic),
                          color_text(metallic_tint(m.metallic, mirror.cosine, m.color)), color_text(m.reflect)));
  if (mirror.left_out)
    page.line(indent + 2, left_out_text(answer, *mirror.left_out));
  else if (!mirror.ray)
    page.line(indent + 2, "no reflection: weight 0");
}

namespace {

// Which solid is entered or left, and the indices.
std::string passage_text(const Answer& answer, const SurfaceNode& s, const MediumTransition& p) {
  const std::string title = answer.namer.title(s.path);
  switch (p.kind) {
  case MediumTransition::Kind::entering:
    return fmt::format("enters {}, ior {} to {}", title, number_text(p.ior_from), number_text(p.ior_to));
  case MediumTransition::Kind::leaving:
    return fmt::format("leaves {}, ior {} to {}", title, number_text(p.ior_from), number_text(p.ior_to));
  case MediumTransition::Kind::entering_outer:
    return fmt::format("enters {} together with a solid inside it, ior stays {}", title, number_text(p.ior_from));
  case MediumTransition::Kind::leaving_outer:
    return fmt::format("leaves {} while still inside a solid entered later, ior stays {}", title,
                       number_text(p.ior_from));
  case MediumTransition::Kind::through_sheet:
    return fmt::format("passes {}, a thin sheet", title);
  }
  return "";
}

double sine(double cosine) {
  return std::sqrt(std::max(0.0, 1 - cosine * cosine));
}

} // namespace

void write_passage(const Answer& answer, const SurfaceNode& s, Page& page, int indent) {
  const TransitionNode& p = *s.transition;
  const double eta = p.transition.eta();
  const bool is_bent = std::abs(eta - 1) >= 1e-10;
  page.line(indent, fmt::format("{}: weight τ = refract·c{} = {}", passage_text(answer, s, p.transition),
                                s.material.fresnel ? "·min(1, 1 − ρ)" : "", color_text(p.tau)));
  if (is_bent) {
    page.line(indent + 2, fmt::format("Snell: sin θ₂ = (n₁/n₂)·sin θ₁ = {}·{} = {}: {} becomes {}", number_text(eta),
                                      number_text(sine(p.cosine)), number_text(sine(p.cosine_behind)),
                                      angle_text(p.cosine), angle_text(p.cosine_behind)));
    if (p.left_out)
      page.line(indent + 2, left_out_text(answer, *p.left_out));
    else if (!p.ray)
      page.line(indent + 2, "no refraction: weight 0");
    return;
  }
  if (p.left_out) return page.line(indent + 2, left_out_text(answer, *p.left_out));
  page.line(indent + 2,
            p.tau == black ? "no refraction: weight 0"
            : s.material.thin
                ? fmt::format("no bending: the ray continues straight, at {}, without increasing the depth",
                              angle_text(p.cosine))
                : fmt::format("the ior is the same: the ray continues straight, at {}, without counting as deeper",
                              angle_text(p.cosine)));
}

void write_total_reflection(const Answer& answer, const SurfaceNode& s, Page& page, int indent) {
  const TotalReflectionNode& t = *s.total_reflection;
  const double eta = t.transition.eta();
  page.line(indent, fmt::format("total internal reflection in {}, ior {} to {}: sin θ₂ would be {}·{} = {} > 1",
                                answer.namer.title(s.path), number_text(t.transition.ior_from),
                                number_text(t.transition.ior_to), number_text(eta), number_text(sine(t.cosine)),
                                number_text(eta * sine(t.cosine))));
  page.line(indent + 2,
            fmt::format("{} is beyond the critical angle of {}; one reflected ray of weight 1 replaces both branches",
                        angle_text(t.cosine), angle_text(sine(1 / eta))));
}

} // namespace rt::tools::explain
