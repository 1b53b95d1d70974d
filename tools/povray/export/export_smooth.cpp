#include "tools/povray/export/export_parts.hpp"

#include <algorithm>
#include <cmath>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

Triangle moved(Triangle t, const Map& map) {
  const Map back = inverse(map);
  for (Vec3& p : t.points) p = map.point(p);
  // By the inverse transpose; in a row-vector map its rows are the inverse's columns.
  for (Vec3& n : t.normals) n = unit({dot(back.row[0], n), dot(back.row[1], n), dot(back.row[2], n)});
  return t;
}

// One by one, as written.
std::vector<Map> steps_of(const Placement& placement) {
  std::vector<Map> steps{map_of(ScaleStep{placement.scale, {}}), map_of(RotateStep{placement.rotate, {}}),
                         map_of(MoveStep{placement.at})};
  for (const Step& step : placement.chain) steps.push_back(map_of(step));
  return steps;
}

// Whether it is dropped before or after any of the steps; `t` is transformed by them.
bool is_dropped_on_the_way(Triangle& t, const Placement& placement) {
  bool is_lost = is_dropped(t);
  for (const Map& step : steps_of(placement)) {
    t = moved(std::move(t), step);
    is_lost = is_lost || is_dropped(t);
  }
  return is_lost;
}

class DroppedTriangles {
public:
  explicit DroppedTriangles(const Scene& scene) : scene_(scene) {}

  std::vector<Origin> run() {
    walk(scene_.objects);
    return std::move(found_);
  }

private:
  void walk(const std::vector<Object>& objects) {
    for (const Object& o : objects) {
      if (!has_smooth(scene_, o)) continue;
      if (is_smooth(scene_.shapes, o.shape))
        triangle(o);
      else {
        around_.push_back(placement_of(scene_, o));
        walk(scene_.shapes.get<Group>(o.shape).members);
        around_.pop_back();
      }
    }
  }

  void triangle(const Object& o) {
    Triangle t = moved(scene_.shapes.get<Triangle>(o.shape), map_of(placement_of(scene_, o)));
    bool is_lost = is_dropped(t);
    for (auto placement = around_.rbegin(); placement != around_.rend() && !is_lost; ++placement)
      is_lost = is_dropped_on_the_way(t, *placement);
    if (is_lost) found_.push_back(o.origin);
  }

  const Scene& scene_;
  std::vector<Placement> around_; // outermost first
  std::vector<Origin> found_;
};

} // namespace

bool is_smooth(const Shapes& shapes, ShapeRef shape) {
  return shape.kind == kind_of<Triangle> && shapes.get<Triangle>(shape).normals.size() == 3;
}

bool has_smooth(const Scene& scene, const Object& o) {
  if (!o.is_visible || o.shape.kind != kind_of<Group>) return o.is_visible && is_smooth(scene.shapes, o.shape);
  const auto& members = scene.shapes.get<Group>(o.shape).members;
  return std::any_of(members.begin(), members.end(), [&](const Object& member) { return has_smooth(scene, member); });
}

bool is_dropped(const Triangle& t) {
  if (t.normals.size() != 3) return false;
  const Vec3 flat = cross(t.points[0] - t.points[1], t.points[2] - t.points[1]);
  const auto side = [&](std::size_t i) { return dot(flat, t.normals[i]); };
  return !(side(0) > 0 && side(1) > 0 && side(2) > 0) && !(side(0) < 0 && side(1) < 0 && side(2) < 0);
}

std::vector<Origin> dropped_triangles(const Scene& scene) {
  return DroppedTriangles(scene).run();
}

std::optional<Triangle> moved_to_be_kept(const Scene& scene, const Object& o) {
  if (!is_smooth(scene.shapes, o.shape)) return std::nullopt;
  Triangle t = scene.shapes.get<Triangle>(o.shape);
  if (!is_dropped_on_the_way(t, placement_of(scene, o)) || is_dropped(t)) return std::nullopt;
  return t;
}

} // namespace rt::tools::povray
