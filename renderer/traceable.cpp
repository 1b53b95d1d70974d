#include "renderer/traceable.hpp"

#include "renderer/accel/tree.hpp"

namespace rt {
namespace {

struct Placed {
  std::uint32_t order;
  std::uint32_t material;
};

struct NearestQuery : accel::Query {
  NearestQuery(const Ray& r, double from, RayHit& h) : Query(r, {from, h.t}), hit(h) {}
  RayHit& hit;
  std::uint32_t order = 0;
  bool found = false;
};

struct ShadowQuery : accel::Query {
  using Query::Query;
};

int roots(const SphereGeometry& s, const Ray& ray, double& near, double& far) {
  const Vec3 to_center = s.center - ray.origin;
  const double a = dot(ray.direction, ray.direction), b = dot(to_center, ray.direction);
  const Vec3 off = to_center - ray.direction * (b / a);
  const double h2 = s.radius * s.radius - dot(off, off);
  if (h2 < 0) return 0;
  const double q = b + std::copysign(std::sqrt(h2 * a), b);
  const double c = dot(to_center, to_center) - s.radius * s.radius;
  near = c / q, far = q / a;
  if (near > far) std::swap(near, far);
  return 2;
}

struct Spheres {
  std::vector<SphereGeometry> shapes;
  std::vector<Placed> placed;
  std::uint32_t size() const { return static_cast<std::uint32_t>(shapes.size()); }
  Box3 bounds(std::uint32_t i) const {
    const Vec3 r{shapes[i].radius, shapes[i].radius, shapes[i].radius};
    return {shapes[i].center - r, shapes[i].center + r};
  }
  void nearest(std::uint32_t i, NearestQuery& q) const {
    double near, far;
    if (!roots(shapes[i], q.ray, near, far)) return;
    const double t = near > q.interval.lower ? near : far;
    if (!(t > q.interval.lower) || t > q.interval.upper) return;
    if (t == q.interval.upper && q.found && placed[i].order > q.order) return;
    q.interval.upper = t, q.found = true, q.order = placed[i].order;
    q.hit = {t, 0, i, 0};
  }
  bool blocks(std::uint32_t i, ShadowQuery& q) const {
    double near, far;
    if (!roots(shapes[i], q.ray, near, far)) return false;
    return (near > q.interval.lower && near <= q.interval.upper) || (far > q.interval.lower && far <= q.interval.upper);
  }
};

struct Plane : PlaneGeometry {
  Placed placed;
};

} // namespace

struct Traceable::Geometry {
  accel::Device device;
  Spheres spheres;
  std::vector<Plane> planes;
  accel::Tree tree;
  explicit Geometry(int threads) : device(threads) {}
};

Traceable::Traceable(const scene::Scene& scene, int threads)
    : geometry_(std::make_unique<Geometry>(threads)), materials_(scene), background_(scene.background),
      ambient_(scene.ambient), max_depth_(scene.max_depth) {
  for (const scene::Light& light : scene.lights) lamps_.push_back(make_lamp(light));
  Geometry& g = *geometry_;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    if (!object.is_visible) continue;
    const Placed where{i, object.material == scene::no_material ? materials_.default_material()
                                                                : static_cast<std::uint32_t>(object.material)};
    if (object.shape.kind == scene::kind_of<scene::Sphere>) {
      const auto sphere = placed(geometry(scene.shapes.get<scene::Sphere>(object.shape)), to_parent(scene, object));
      if (!sphere) continue;
      g.spheres.shapes.push_back(*sphere);
      g.spheres.placed.push_back(where);
    } else if (object.shape.kind == scene::kind_of<scene::Plane>) {
      const auto plane = placed(geometry(scene.shapes.get<scene::Plane>(object.shape)), to_parent(scene, object));
      g.planes.push_back({*plane, where});
    }
  }
  Box3 box;
  for (std::uint32_t i = 0; i < g.spheres.size(); ++i) box.extend(g.spheres.bounds(i));
  if (!box.is_empty()) {
    g.tree = accel::Tree(g.device, box);
    g.tree.add<NearestQuery, ShadowQuery>(g.spheres);
    g.tree.build();
  }
}

Traceable::~Traceable() = default;

bool Traceable::nearest(const Ray& ray, double t_min, RayHit& hit, TraceScratch&) const {
  NearestQuery query(ray, t_min, hit);
  for (std::uint32_t i = 0; i < geometry_->planes.size(); ++i) {
    const Plane& p = geometry_->planes[i];
    const double t = (p.offset - dot(p.normal, ray.origin)) / dot(p.normal, ray.direction);
    if (!(t > t_min) || !(t < query.interval.upper)) continue;
    query.interval.upper = t, query.found = true, query.order = p.placed.order;
    hit = {t, 1, i, 0};
  }
  if (!geometry_->tree.is_empty()) geometry_->tree.nearest(query);
  return query.found;
}

Surface Traceable::surface(const Ray& ray, const RayHit& hit) const {
  Surface s;
  s.point = ray.at(hit.t);
  const Placed* placed;
  if (hit.kind == 0) {
    const SphereGeometry& sphere = geometry_->spheres.shapes[hit.index];
    s.geometric_normal = normalize(s.point - sphere.center);
    s.point = sphere.center + s.geometric_normal * sphere.radius;
    placed = &geometry_->spheres.placed[hit.index];
  } else {
    s.geometric_normal = geometry_->planes[hit.index].normal;
    placed = &geometry_->planes[hit.index].placed;
  }
  s.shading_normal = s.geometric_normal;
  s.offset = 0x1p-46 * (max_component(abs(s.point)) + hit.t);
  s.order = s.interior = placed->order;
  s.material = placed->material;
  s.pattern_point = s.point;
  s.ior = materials_.constant(s.material).ior;
  return s;
}

Color Traceable::transmittance(const Ray& ray, double from, double to, TraceScratch&) const {
  for (const Plane& p : geometry_->planes) {
    const double t = (p.offset - dot(p.normal, ray.origin)) / dot(p.normal, ray.direction);
    if (t > from && t <= to) return black;
  }
  ShadowQuery query(ray, {from, to});
  if (!geometry_->tree.is_empty() && geometry_->tree.blocks(query)) return black;
  return white;
}

std::uint64_t Traceable::primitive_count() const {
  return geometry_->spheres.size() + geometry_->planes.size();
}

} // namespace rt
