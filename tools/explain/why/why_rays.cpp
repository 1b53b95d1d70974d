#include "tools/explain/why/why_rays.hpp"

#include "tools/explain/why/why_surface.hpp"

#include <fmt/format.h>

#include <algorithm>

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

class RayWriter {
public:
  RayWriter(const Answer& answer, Page& page) : answer_(answer), page_(page) {}

  void head(const RayNode& node, int indent) {
    page_.line(indent,
               fmt::format("{}, depth {}, weight {}: from {} along {}", name_of(node.kind), node.depth,
                           color_text(node.weight), vector_text(node.ray.origin), vector_text(node.ray.direction)));
  }

  void end(const RayNode& node, int indent) {
    const std::string_view subject = node.surfaces.empty() ? "it" : "behind it the ray";
    if (node.end == RayNode::End::background)
      page_.line(indent, fmt::format("{} hits nothing: the background, {}", subject, color_text(node.background)));
    if (node.end == RayNode::End::too_deep)
      page_.line(indent, node.surfaces.empty()
                             ? fmt::format("depth {} is beyond max_depth {}: black", node.depth,
                                           scene::depth_limit(answer_.scene))
                             : fmt::format("depth {} is max_depth: what is beyond is not traced, black", node.depth));
  }

  void radiance(const RayNode& node, int indent) {
    page_.line(indent, fmt::format("returns {}", color_text(node.radiance)));
  }

  // The radiance and its parts.
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
      if (s.mirror) add("mirrored", s.passed * s.mirror->rho * radiance_of(*s.mirror));
      if (s.transition) add("refracted", s.passed * s.transition->tau * radiance_of(*s.transition));
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

private:
  // What comes in along a branch, or what takes its place.
  template <class Branch>
  static Color radiance_of(const Branch& branch) {
    return branch.left_out ? branch.left_out->estimate : branch.ray ? branch.ray->radiance : black;
  }

  const Answer& answer_;
  Page& page_;
};

class TreeWriter {
public:
  TreeWriter(const Answer& answer, const Detail& detail, Page& page)
      : answer_(answer), detail_(detail), page_(page), rays_(answer, page) {}

  void ray(const RayNode& node, int indent) {
    rays_.head(node, indent);
    if (!shows(answer_, detail_, node)) return rays_.radiance(node, indent + 2);
    for (const SurfaceNode& s : node.surfaces) surface(s, indent + 2);
    rays_.end(node, indent + 2);
    if (!node.surfaces.empty()) rays_.total(node, indent + 2);
  }

private:
  void surface(const SurfaceNode& s, int indent) {
    write_meeting(answer_, s, page_, indent);
    write_derivation(answer_, s, page_, indent + 2);
    write_normal(answer_, s, page_, indent + 2);
    write_shading(answer_, s, page_, indent + 2);
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

  const Answer& answer_;
  const Detail& detail_;
  Page& page_;
  RayWriter rays_;
};

// How the path continues from a surface.
void write_onwards(const Answer& answer, const SurfaceNode& s, WayStep::How how, Page& page, int indent) {
  switch (how) {
  case WayStep::How::mirrored:
    return write_mirror(answer, s, page, indent);
  case WayStep::How::refracted:
  case WayStep::How::crossed:
    return write_passage(answer, s, page, indent);
  case WayStep::How::totally_reflected:
    return write_total_reflection(answer, s, page, indent);
  }
}

int number_of_rays(const RayNode& ray) {
  int number = 1;
  for (const SurfaceNode& s : ray.surfaces) {
    if (s.mirror && s.mirror->ray) number += number_of_rays(*s.mirror->ray);
    if (s.transition && s.transition->ray) number += number_of_rays(*s.transition->ray);
    if (s.total_reflection) number += number_of_rays(*s.total_reflection->ray);
  }
  return number;
}

// What is omitted if there is more than this path.
void write_title(const Answer& answer, Page& page) {
  const int rays = number_of_rays(*answer.tree);
  if (rays == 1) return;
  const double whole = size_of(answer.sum.total);
  const std::string title = whole > 0 ? fmt::format("the path that carries most of the light, {} of it",
                                                    percent_text(size_of(answer.path.light) / whole))
                                      : "no light arrives; this is the path along which most would be seen";
  page.line(0, fmt::format("{} (--all shows all {} rays)", title, rays));
}

void write_step(const Answer& answer, const PathStep& step, bool is_first, Page& page) {
  const SurfaceNode& s = *step.surface;
  write_meeting(answer, s, page, 2);
  if (is_first) write_derivation(answer, s, page, 4);
  write_normal(answer, s, page, 4);
  if (step.onwards)
    write_onwards(answer, s, *step.onwards, page, 2);
  else
    write_shading(answer, s, page, 4);
}

} // namespace

void write_tree(const Answer& answer, const Detail& detail, Page& page) {
  TreeWriter(answer, detail, page).ray(*answer.tree, 0);
}

void write_path(const Answer& answer, Page& page) {
  write_title(answer, page);
  RayWriter rays(answer, page);
  const std::vector<PathStep>& steps = answer.path.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const RayNode& ray = *steps[i].ray;
    if (i == 0 || steps[i - 1].ray != &ray) rays.head(ray, 0);
    if (steps[i].surface)
      write_step(answer, steps[i], i == 0, page);
    else
      rays.end(ray, 2);
    const bool is_last = i + 1 == steps.size() || steps[i + 1].ray != &ray;
    if (!ray.is_expanded)
      rays.radiance(ray, 2);
    else if (is_last && !ray.surfaces.empty())
      rays.total(ray, 2);
  }
}

} // namespace rt::tools::explain
