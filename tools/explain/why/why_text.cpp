#include "tools/explain/why/why_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace rt::tools::explain {
namespace {

std::string_view name_of(RayKind kind) {
  switch (kind) {
  case RayKind::camera:
    return "the ray";
  case RayKind::reflected:
    return "mirrored ray";
  case RayKind::refracted:
    return "refracted ray";
  case RayKind::total_reflection:
    return "totally reflected ray";
  }
  return "";
}

// Writes the tree.
class TreeWriter {
public:
  TreeWriter(const Answer& answer, int depth, Page& page) : answer_(answer), depth_(depth), page_(page) {}

  void ray(const RayNode& node, int indent) {
    page_.line(indent,
               fmt::format("{}, depth {}, weight {}: from {} along {}", name_of(node.kind), node.depth,
                           color_text(node.weight), vector_text(node.ray.origin), vector_text(node.ray.direction)));
    if (!node.is_expanded || node.depth > depth_) {
      page_.line(indent + 2, fmt::format("returns {}", color_text(node.radiance)));
      return;
    }
    for (const SurfaceNode& s : node.surfaces) surface(s, indent + 2);
    end(node, indent + 2);
    if (!node.surfaces.empty()) total(node, indent + 2);
  }

private:
  void surface(const SurfaceNode& s, int indent) {
    write_surface(answer_, s, page_, indent);
    if (s.total_reflection) {
      write_total_reflection(answer_, s, page_, indent);
      ray(*s.total_reflection->ray, indent);
    }
    if (s.mirror) {
      write_mirror(answer_, s, page_, indent);
      if (s.mirror->ray) ray(*s.mirror->ray, indent);
    }
    if (s.transition) {
      write_passage(answer_, s, page_, indent);
      if (s.transition->ray) ray(*s.transition->ray, indent);
    }
  }

  void end(const RayNode& node, int indent) {
    const std::string_view subject = node.surfaces.empty() ? "it" : "behind it the ray";
    if (node.end == RayNode::End::background)
      page_.line(indent, fmt::format("{} meets nothing: the background, {}", subject, color_text(node.background)));
    if (node.end == RayNode::End::too_deep)
      page_.line(indent,
                 node.surfaces.empty()
                     ? fmt::format("depth {} is beyond max_depth {}: black", node.depth, answer_.scene.max_depth)
                     : fmt::format("depth {} is max_depth: what lies beyond is not traced, black", node.depth));
  }

  // The parts of the ray's radiance.
  void total(const RayNode& node, int indent) {
    std::string text;
    int parts = 0;
    const auto add = [&](std::string_view name, const Color& value) {
      if (value == black) return;
      text += fmt::format("{}{} {}", parts++ == 0 ? "" : " + ", name, color_text(value));
    };
    for (const SurfaceNode& s : node.surfaces) {
      add("shading", s.passed * s.shading());
      if (s.total_reflection) add("total reflection", s.passed * s.total_reflection->ray->radiance);
      if (s.mirror && s.mirror->ray) add("mirrored", s.passed * s.mirror->rho * s.mirror->ray->radiance);
      if (s.transition && s.transition->ray)
        add("refracted", s.passed * s.transition->tau * s.transition->ray->radiance);
    }
    if (node.end == RayNode::End::background) {
      const SurfaceNode& last = node.surfaces.back();
      add("background", last.passed * last.transition->tau * node.background);
    }
    const std::string_view name = node.kind == RayKind::camera ? "the ray" : "this ray";
    if (parts > 1)
      text = fmt::format("{} returns {} = {}", name, color_text(node.radiance), text);
    else
      text = fmt::format("{} returns {}", name, color_text(node.radiance));
    page_.line(indent, text);
  }

  const Answer& answer_;
  int depth_;
  Page& page_;
};

std::string term_text(const Answer& answer, const Contribution& term) {
  const std::string where = term.surface ? answer.namer.title(term.surface->path) : "";
  std::string text;
  switch (term.kind) {
  case Contribution::Kind::ambient:
    text = fmt::format("ambient light on {}", where);
    break;
  case Contribution::Kind::emission:
    text = fmt::format("emission of {}", where);
    break;
  case Contribution::Kind::diffuse:
    text = fmt::format("{} on {}", answer.namer.light(term.light), where);
    break;
  case Contribution::Kind::highlight:
    text = fmt::format("highlight of {} on {}", answer.namer.light(term.light), where);
    break;
  case Contribution::Kind::background:
    text = "the background";
    break;
  case Contribution::Kind::unexpanded:
    text = "rays that are summed up";
    break;
  }
  return text + way_text(answer.namer, answer.sum, term.last_step);
}

// The terms from the largest on, and their sum beside what was traced.
void write_sum(const Answer& answer, Page& page) {
  constexpr std::size_t most = 12;
  std::vector<const Contribution*> terms;
  for (const Contribution& term : answer.sum.terms) terms.push_back(&term);
  std::stable_sort(terms.begin(), terms.end(),
                   [](const auto* a, const auto* b) { return size_of(a->value) > size_of(b->value); });
  const double whole = size_of(answer.sum.total);
  page.line(0, terms.empty() ? "no contributions" : "contributions, the largest first");
  Color rest = black;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Contribution& term = *terms[i];
    if (i >= most && terms.size() > most + 1) {
      rest += term.value;
      continue;
    }
    page.line(2,
              fmt::format("{:>9}  {}  {}", percent_text(whole > 0 ? size_of(term.value) / whole : 0),
                          color_text(term.value), term_text(answer, term)),
              13);
  }
  if (terms.size() > most + 1)
    page.line(2,
              fmt::format("{:>9}  {}  {} smaller terms", percent_text(size_of(rest) / whole), color_text(rest),
                          terms.size() - most),
              13);
  const Color traced = answer.tree->radiance, difference = answer.sum.total - traced;
  const double gap = std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
  page.line(2,
            fmt::format("{:>9}  {}  {}", "sum", color_text(answer.sum.total),
                        gap == 0 ? "as the renderer has it" : fmt::format("as the renderer has it, to {:.1g}", gap)));
}

std::string headline(const Answer& answer) {
  const Color seen = answer.tree->radiance;
  return fmt::format("{} of {}: {} linear, shown as {}", answer.ray.name,
                     std::filesystem::path(answer.file).filename().string(), color_text(seen),
                     shown(seen, scene::tone_mapping(answer.scene)));
}

} // namespace

std::string why_text(const Answer& answer, int depth) {
  Page page;
  page.line(0, headline(answer));
  if (answer.pixel)
    page.line(2, fmt::format("the pixel itself is the mean of its {} samples: {} linear, shown as {}",
                             answer.scene.samples, color_text(*answer.pixel),
                             shown(*answer.pixel, scene::tone_mapping(answer.scene))));
  page.blank();
  TreeWriter(answer, depth, page).ray(*answer.tree, 0);
  page.blank();
  write_sum(answer, page);
  page.blank();
  page.line(0, verdict(answer));
  return page.take();
}

} // namespace rt::tools::explain
