// What is inside what, and transforms that leave almost nothing.

#include "renderer/compile/geometries.hpp"
#include "tools/explain/lint/lint_parts.hpp"
#include "tools/explain/naming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::tools::explain {
namespace {

/// Solids that a ray leaves without having entered them, by order.
std::map<std::uint64_t, Around> left_first(const LintContext& context, const Ray& ray) {
  std::map<std::uint64_t, Around> found;
  std::set<std::uint64_t> met;
  for (const HitReport& hit : context.query.all_hits(ray)) {
    if (!met.insert(hit.order).second || hit.enters) continue;
    Around around{hit.order, objects_on(context.scene, hit.path), hit.material.refract > 0, true};
    if (!is_solid(context.scene, around.objects)) continue;
    for (const scene::Object* object : around.objects) around.casts_shadow &= object->casts_shadow;
    found.emplace(hit.order, std::move(around));
  }
  return found;
}

void find_eye_inside(LintContext& context) {
  for (const Around& around : context.around_eye) {
    const Line camera = line_of(context.scene.camera_origin), solid = line_of(around.objects.front()->origin);
    const std::string name = context.findings.name(*around.objects.front());
    if (around.is_transparent) {
      lang::Diagnostic& d =
          context.findings.warn(lang::lint_rule::camera_inside, camera, fmt::format("the camera is inside {}", name));
      d.label = "everything is seen through its surface";
      d.notes.push_back(context.findings.note(solid, "this transparent solid surrounds the camera"));
      continue;
    }
    const bool is_all_there_is =
        std::ranges::all_of(context.view.orders, [&](std::uint64_t order) { return order == around.order; });
    const auto holds_a_light = [&] {
      return std::ranges::any_of(context.query.scene().lights(), [&](const Light& light) {
        const std::optional<Vec3> at = position(light);
        if (!at) return false;
        const auto solids = solids_around(context, *at);
        return std::ranges::any_of(solids, [&](const Around& a) { return a.order == around.order; });
      });
    };
    if (!is_all_there_is || holds_a_light()) continue; // a room
    context.is_eye_shut_in = true;
    lang::Diagnostic& d = context.findings.warn(lang::lint_rule::camera_inside, camera,
                                                fmt::format("the camera is inside {} and sees nothing else", name));
    d.label = "every ray hits its inside";
    d.notes.push_back(context.findings.note(solid, "this opaque solid surrounds the camera"));
    d.notes.push_back({std::nullopt, "move the camera out of it"});
  }
}

void find_lights_inside(LintContext& context) {
  constexpr std::size_t most_lights = 10'000;
  const auto& lights = context.query.scene().lights();
  const auto is_around_eye = [&](const Around& around) {
    return std::ranges::any_of(context.around_eye, [&](const Around& a) { return a.order == around.order; });
  };
  std::set<std::pair<Line, Line>> reported;
  for (std::size_t i = 0; i < std::min(lights.size(), most_lights); ++i) {
    const std::optional<Vec3> at = position(lights[i]);
    if (!at || !lights[i].shadows) continue;
    for (const Around& around : solids_around(context, *at)) {
      if (around.is_transparent || !around.casts_shadow || is_around_eye(around)) continue;
      const scene::Light& light = context.scene.lights[i];
      const Line place = line_of(light.origin), solid = line_of(thing_of(around.objects).origin);
      context.shut_in_lights.insert(place);
      if (!reported.emplace(place, solid).second) continue;
      const std::string name = Findings::subject(name_of(context.scene, light), 1);
      lang::Diagnostic& d = context.findings.warn(
          lang::lint_rule::light_inside, place,
          fmt::format("{} is inside {}, which is opaque", name, context.findings.name(thing_of(around.objects))));
      d.label = "no light gets out";
      d.notes.push_back(context.findings.note(
          solid, "this solid surrounds it: add `casts_shadow: false` there, or move one of them"));
    }
  }
}

/// What is wrong with a transform, if anything.
std::string smallness(const Affine& map) {
  constexpr double least = 1e-6;
  const double x = length(map.x), y = length(map.y), z = length(map.z);
  const double smallest = std::min({x, y, z}), largest = std::max({x, y, z});
  if (largest < least) return fmt::format("it is {:.3g} times as large as it was written", largest);
  if (smallest < least * largest) return fmt::format("its thickness is {:.3g} times what it was written", smallest);
  const double slant = std::abs(map.determinant()) / (x * y * z);
  if (slant < least * least) return "its sides coincide";
  return {};
}

} // namespace

const scene::Object& thing_of(const std::vector<const scene::Object*>& objects) {
  const auto is_combination = [](const scene::Object* object) {
    return object->shape.kind == scene::kind_of<scene::Combination>;
  };
  const auto found = std::ranges::find_if(objects, is_combination);
  return found == objects.end() ? *objects.back() : **found;
}

bool is_solid(const scene::Scene& scene, const std::vector<const scene::Object*>& objects) {
  for (const scene::Object* object : objects)
    if (object->shape.kind == scene::kind_of<scene::Combination>) return true;
  return scene.shapes.visit(objects.back()->shape, []<class S>(const S& shape) -> bool {
    if constexpr (scene::is_composite<S> || std::is_same_v<S, scene::Plane>)
      return false;
    else
      return rt::is_solid(geometry(shape));
  });
}

std::vector<Around> solids_around(const LintContext& context, const Vec3& p) {
  // Two directions that no scene is likely to be built along: what only one of them finds was grazed.
  const auto one = left_first(context, {p, {0.35417, 0.84393, 0.40277}});
  const auto other = left_first(context, {p, {-0.61873, 0.23419, -0.74988}});
  std::vector<Around> both;
  for (const auto& [order, around] : one)
    if (other.contains(order)) both.push_back(around);
  return both;
}

void find_insides(LintContext& context) {
  find_eye_inside(context);
  find_lights_inside(context);
}

void find_small_scales(LintContext& context) {
  const scene::Scene& scene = context.scene;
  std::vector<std::string> problems;
  problems.reserve(scene.transforms.size());
  for (const scene::Placement& placement : scene.transforms) problems.push_back(smallness(scene::matrix(placement)));
  struct Small {
    const scene::Object* first = nullptr;
    std::uint64_t count = 0;
  };
  std::map<Line, Small> lines;
  const auto look = [&](const std::vector<scene::Object>& objects) {
    for (const scene::Object& object : objects) {
      if (object.transform == scene::no_transform || problems[static_cast<std::size_t>(object.transform)].empty())
        continue;
      Small& small = lines[line_of(object.origin)];
      if (!small.first) small.first = &object;
      ++small.count;
    }
  };
  look(scene.objects);
  for (const scene::Group& group : scene.shapes.all<scene::Group>()) look(group.members);
  for (const scene::Combination& combination : scene.shapes.all<scene::Combination>()) look(combination.operands);
  for (const auto& [line, small] : lines) {
    const std::string subject = Findings::subject(name_of(scene, *small.first), small.count);
    lang::Diagnostic& d = context.findings.warn(lang::lint_rule::nearly_flat, line,
                                                fmt::format("the transform leaves almost nothing of {}", subject));
    d.label = problems[static_cast<std::size_t>(small.first->transform)];
    d.notes.push_back(
        {std::nullopt, "check for a wrong unit or an extra 0; what is meant to be flat can be a `disc` or a `quad`"});
  }
}

} // namespace rt::tools::explain
