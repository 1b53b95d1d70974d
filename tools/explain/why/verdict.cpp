#include "tools/explain/why/light_path.hpp"
#include "tools/explain/why/why.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rt::tools::explain {
namespace {

constexpr double dark_below = 0.05; // the largest component, linear: #3f3f3f and darker

// The reasons why a light contributes little to a surface, and why all lights together do.
class Surfaces {
public:
  explicit Surfaces(const Answer& answer) : answer_(answer), namer_(answer.namer) {}

  std::string title(const SurfaceNode& s) const { return namer_.title(s.path); }

  // Why the lights contribute so little that one would ask; lights with the same reason share a phrase. `lit_by` are
  // not to blame; `is_strict`: only reasons that exclude a light entirely count.
  std::vector<std::string> why_unlit(const SurfaceNode& s, const std::set<std::uint32_t>& lit_by = {},
                                     bool is_strict = false) const {
    std::vector<Reason> reasons;
    for (const LightNode& light : s.lights) {
      if (lit_by.contains(light.record.light)) continue;
      std::optional<Reason> reason = keeps_off(s, light);
      if (!reason && !is_strict) reason = weakens(light);
      if (!reason) continue;
      const auto same = std::find_if(reasons.begin(), reasons.end(), [&](const Reason& r) {
        return r.before == reason->before && r.after == reason->after;
      });
      if (same == reasons.end())
        reasons.push_back(*reason), reasons.back().lights = {light.record.light};
      else
        same->lights.push_back(light.record.light);
    }
    std::vector<std::string> phrases;
    for (const Reason& r : reasons) phrases.push_back(r.before + lights_text(r.lights) + r.after);
    if (phrases.size() > 4) {
      phrases.resize(3);
      phrases.push_back("as little light comes from the other lights");
    }
    return phrases;
  }

private:
  struct Reason {
    std::string before, after; // the words around the lights' names
    std::vector<std::uint32_t> lights;
  };

  std::string lights_text(const std::vector<std::uint32_t>& lights) const {
    std::vector<std::string> names;
    std::map<std::string, int> counts;
    for (const std::uint32_t light : lights)
      if (const std::string name = namer_.light(light); ++counts[name] == 1) names.push_back(name);
    for (std::string& name : names)
      if (const int count = counts[name]; count > 1) name = fmt::format("{} × {}", count, name);
    return list_text(names);
  }

  std::optional<Reason> keeps_off(const SurfaceNode& s, const LightNode& light) const {
    const LightRecord& r = light.record;
    if (answer_.compiled.lights()[r.light].color == black) return Reason{"no light comes from ", "", {}};
    if (r.sample.distance == 0) return Reason{"", " is at the very point that is seen and does not light it", {}};
    if (r.sample.spot == 0) return Reason{"it is outside the cone of ", "", {}};
    if (!(r.cos_light > 0)) return Reason{"it faces away from ", "", {}};
    if (max_component(r.filter) < 0.05) return blocks(s, light);
    return std::nullopt;
  }

  static std::optional<Reason> weakens(const LightNode& light) {
    const LightRecord& r = light.record;
    if (r.sample.fade < 0.05)
      return Reason{"it is too far away for the light of ", fmt::format(" (fade {:.2g})", r.sample.fade), {}};
    if (r.cos_light < 0.1) return Reason{"it is only grazed by the light of ", "", {}};
    if (r.sample.spot < 0.05) return Reason{"it is at the rim of the cone of ", "", {}};
    return std::nullopt;
  }

  Reason blocks(const SurfaceNode& s, const LightNode& light) const {
    if (light.in_the_way.empty()) return {"something blocks ", "", {}};
    const InTheWay& last = light.in_the_way.back();
    const std::size_t count = light.in_the_way.size();
    if (last.transmittance != black && count > 1)
      return {fmt::format("{} surfaces on the way take nearly all light of ", count), "", {}};
    const std::string_view verb = last.transmittance == black ? "blocks" : "all but blocks";
    if (last.path == s.path) return {fmt::format("it {} ", verb), " itself", {}};
    return {fmt::format("{} {} ", namer_.title(last.path), verb), "", {}};
  }

  const Answer& answer_;
  const Namer& namer_;
};

std::string join(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? ", and " : ", ") + parts[i];
  return text;
}

// Names the surface that "it" refers to if something else was named last.
std::vector<std::string> with_subject(std::vector<std::string> reasons, const std::string& title, bool is_named) {
  for (std::string& reason : reasons) {
    const bool is_about_it = reason.starts_with("it ");
    if (is_about_it && !is_named) reason.replace(0, 2, title);
    is_named = is_about_it;
  }
  return reasons;
}

// Why a ray carries next to nothing.
class Darkness {
public:
  explicit Darkness(const Answer& answer) : answer_(answer), surfaces_(answer) {}

  std::string of(const RayNode& ray) const { return of(ray, 0); }

private:
  std::string of(const RayNode& ray, std::size_t first) const {
    if (first < ray.surfaces.size()) return of(ray, first, ray.surfaces[first]);
    if (ray.end == RayNode::End::background) {
      if (max_component(ray.background) >= dark_below) return "little of the background's light gets through";
      return first == 0 ? background() : "nothing is behind it, and the background is dark there";
    }
    return fmt::format("the ray ends at max_depth {}", scene::depth_limit(answer_.scene));
  }

  std::string background() const {
    return fmt::format("the ray hits nothing, and the background is {}",
                       answer_.scene.background == black ? "black" : "dark");
  }

  std::string of(const RayNode& ray, std::size_t i, const SurfaceNode& s) const {
    const std::string title = surfaces_.title(s);
    switch (prospect(s)) {
    case Prospect::totally_reflected:
      return deeper(*s.total_reflection->ray, fmt::format("{} reflects the ray totally", title));
    case Prospect::through:
      if (s.material.color == black) return fmt::format("{} transmits nothing: its color is black", title);
      if (max_component(s.transition->tau) < dark_below)
        return fmt::format("{} lets through only {}", title, percent_text(max_component(s.transition->tau)));
      if (s.transition->ray) return deeper(*s.transition->ray, fmt::format("it is seen through {}", title));
      return chained(fmt::format("it is seen through {}", title), of(ray, i + 1));
    case Prospect::mirrored:
      return deeper(*s.mirror->ray, fmt::format("{} mirrors", title));
    case Prospect::own_shading:
      break;
    }
    return lit(s, title);
  }

  // The two sides of one thing are named only once.
  static std::string chained(const std::string& how, const std::string& rest) {
    return rest.starts_with(how) ? rest : fmt::format("{}, and {}", how, rest);
  }

  std::string deeper(const RayNode& ray, const std::string& how) const {
    if (max_component(ray.radiance) >= dark_below) return how + ", but little of the light from there gets through";
    if (ray.surfaces.empty() && ray.end == RayNode::End::background)
      return fmt::format("{}, and the background there is {}", how, ray.background == black ? "black" : "dark");
    if (!ray.is_expanded) return how + ", and little light comes from there";
    return chained(how, of(ray, 0));
  }

  std::string lit(const SurfaceNode& s, const std::string& title) const {
    const MaterialValues& m = s.material;
    if (max_component(s.shading()) >= dark_below) return fmt::format("little of the light of {} gets through", title);
    if (max_component(m.color) < dark_below)
      return fmt::format("the color of {} is {}", title, m.color == black ? "black" : "dark");
    std::vector<std::string> reasons = surfaces_.why_unlit(s);
    if (s.lights.empty())
      reasons.push_back("there is no light");
    else if (max_component(m.diffuse) < dark_below)
      reasons.push_back(fmt::format("the diffuse of {} is {}", title, color_text(m.diffuse)));
    if (reasons.empty())
      reasons.push_back(max_component(m.color) < 0.25 ? fmt::format("the color of {} is dark", title)
                                                      : fmt::format("little light falls on {}", title));
    if (const std::string ambient = about_ambient(s, title); !ambient.empty()) reasons.push_back(ambient);
    return join(with_subject(std::move(reasons), title, false));
  }

  std::string about_ambient(const SurfaceNode& s, const std::string& title) const {
    if (answer_.compiled.ambient() == black) return "ambient is 0";
    if (s.material.ambient == black) return fmt::format("the ambient of {} is 0", title);
    return "there is little ambient light";
  }

  const Answer& answer_;
  Surfaces surfaces_;
};

// Where most of the light comes from.
class Brightness {
public:
  explicit Brightness(const Answer& answer) : answer_(answer), surfaces_(answer), whole_(size_of(answer.sum.total)) {}

  std::string sentence() const {
    const RayNode& root = *answer_.tree;
    if (root.surfaces.empty()) return "this is the background: the ray hits nothing";
    std::map<std::uint32_t, double> by_way; // the terms that came the same way from the same surface
    double direct = 0, mirrored = 0, through = 0;
    for (const Contribution& term : answer_.sum.terms) {
      const double size = size_of(term.value);
      if (term.last_step == no_step) {
        direct += size;
        continue;
      }
      by_way[term.last_step] += size;
      (answer_.sum.way(term.last_step).front().how == WayStep::How::mirrored ? mirrored : through) += size;
    }
    if (direct >= mirrored && direct >= through) return own(root.surfaces.front(), mirrored, through);
    const bool is_mirrored = mirrored > through;
    std::uint32_t best = no_step;
    for (const auto& [step, size] : by_way) {
      const bool is_one = (answer_.sum.way(step).front().how == WayStep::How::mirrored) == is_mirrored;
      if (is_one && (best == no_step || size > by_way.at(best))) best = step;
    }
    return far(best, by_way.at(best), is_mirrored ? mirrored : through, is_mirrored);
  }

private:
  double share(double size) const { return whole_ > 0 ? size / whole_ : 0; }

  // What the surface itself shows.
  std::string own(const SurfaceNode& s, double mirrored, double through) const {
    double ambient = 0, emission = 0;
    std::map<std::uint32_t, double> diffuse, highlight;
    for (const Contribution& term : answer_.sum.terms) {
      if (term.last_step != no_step) continue;
      const double size = size_of(term.value);
      switch (term.kind) {
      case Contribution::Kind::ambient:
        ambient += size;
        break;
      case Contribution::Kind::emission:
        emission += size;
        break;
      case Contribution::Kind::diffuse:
        diffuse[term.light] += size;
        break;
      case Contribution::Kind::highlight:
        highlight[term.light] += size;
        break;
      default:
        break;
      }
    }
    const std::string title = surfaces_.title(s);
    for (const auto& [light, size] : highlight)
      if (size > 0.5 * whole_)
        return fmt::format("bright because {} shows the highlight of {} here ({})", title, name(light),
                           percent_text(share(size)));
    if (emission > 0.5 * whole_)
      return fmt::format("{} emits light: emission gives {}", title, percent_text(share(emission)));
    return lit(s, title, ambient, diffuse, highlight) + others(mirrored, through);
  }

  std::string lit(const SurfaceNode& s, const std::string& title, double ambient,
                  const std::map<std::uint32_t, double>& diffuse,
                  const std::map<std::uint32_t, double>& highlight) const {
    std::map<std::uint32_t, double> lights = diffuse;
    for (const auto& [light, size] : highlight) lights[light] += size;
    std::vector<std::string> givers;
    std::set<std::uint32_t> lit_by;
    for (const auto& [light, size] : lights)
      if (share(size) >= 0.1 && givers.size() < 4)
        lit_by.insert(light), givers.push_back(fmt::format("{} ({})", name(light), percent_text(share(size))));
    if (share(ambient) >= 0.1) givers.push_back(fmt::format("ambient light ({})", percent_text(share(ambient))));
    std::string text = fmt::format("{} is lit by {}", title, givers.empty() ? "many lamps" : list_text(givers));
    if (share(ambient) > 0.98)
      text = fmt::format("{} is lit by ambient light only", title);
    else if (lit_by.empty() && share(ambient) >= 0.1)
      text = fmt::format("{} is seen in ambient light ({})", title, percent_text(share(ambient)));
    const auto missing = surfaces_.why_unlit(s, lit_by, share(ambient) < 0.5);
    if (!missing.empty()) text += ": " + join(with_subject(missing, title, true));
    return text;
  }

  // What is added to the surface's own light.
  std::string others(double mirrored, double through) const {
    std::vector<std::string> parts;
    if (share(mirrored) >= 0.1)
      parts.push_back(fmt::format("{} of the light is reflected", percent_text(share(mirrored))));
    if (share(through) >= 0.1) parts.push_back(fmt::format("{} comes through it", percent_text(share(through))));
    return parts.empty() ? "" : "; " + list_text(parts);
  }

  // What is seen in a mirror or through something. `all` is the total that comes that way.
  std::string far(std::uint32_t step, double size, double all, bool is_mirrored) const {
    const Sum& sum = answer_.sum;
    const auto at_end = [step](const Contribution& t) { return t.last_step == step; };
    const Contribution& term = *std::find_if(sum.terms.begin(), sum.terms.end(), at_end);
    const std::string what = term.kind == Contribution::Kind::background ? "the background"
                             : term.surface                              ? surfaces_.title(*term.surface)
                                                                         : "what deeper rays see";
    const std::string way = way_text(answer_.namer, sum, step);
    if (size >= 0.5 * whole_)
      return fmt::format("{} of the light comes from {}{}", percent_text(share(size)), what, way);
    const std::string first = surfaces_.title(*sum.way(step).front().at);
    return fmt::format("{} of the light is what {} {}; the largest part, {}, comes from {}{}", percent_text(share(all)),
                       first, is_mirrored ? "mirrors" : "lets through", percent_text(share(size)), what, way);
  }

  std::string name(std::uint32_t light) const { return answer_.namer.light(light); }

  const Answer& answer_;
  Surfaces surfaces_;
  double whole_;
};

std::string clipping(const Color& linear, const ToneMapping& mapping) {
  const ToneCurve curve(mapping);
  const auto map = [&](double v) { return static_cast<double>(curve(static_cast<float>(v))); };
  const Color c{map(linear.r), map(linear.g), map(linear.b)};
  if (c.r > 1 && c.g > 1 && c.b > 1) return "; it is brighter than the picture can show and clipped to white";
  std::vector<std::string> names;
  if (c.r > 1) names.push_back("red");
  if (c.g > 1) names.push_back("green");
  if (c.b > 1) names.push_back("blue");
  return names.empty() ? ""
                       : fmt::format("; its {} {} clipped to 1 in the picture", list_text(names),
                                     names.size() == 1 ? "is" : "are");
}

std::string cuts(const Answer& answer) {
  double weight = 0;
  for (const Cut& cut : answer.sum.cuts) weight += max_component(cut.weight);
  if (weight < 0.05) return {};
  return fmt::format("; rays with {} of the weight ended at max_depth {}", percent_text(std::min(weight, 1.0)),
                     scene::depth_limit(answer.scene));
}

} // namespace

std::string verdict(const Answer& answer) {
  const Color& seen = answer.tree->radiance;
  const bool is_dark = max_component(seen) < dark_below;
  if (!is_dark) return Brightness(answer).sentence() + clipping(seen, scene::tone_mapping(answer.scene)) + cuts(answer);
  const std::string_view word = shown(seen, scene::tone_mapping(answer.scene)) == "#000000" ? "black" : "dark";
  const std::string reason = Darkness(answer).of(*answer.tree);
  const bool names_cut = reason.find("max_depth") != std::string::npos;
  return fmt::format("{} because {}", word, reason) + (names_cut ? "" : cuts(answer));
}

} // namespace rt::tools::explain
