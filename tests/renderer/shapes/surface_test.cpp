// What holds of every shape alike: random ones of each kind, of all sizes and at all places.

#include "renderer/math/rounding.hpp"
#include "tests/support/shapes.hpp"

#include <numbers>
#include <set>
#include <typeindex>

using namespace rt;
using namespace rt::tests;

namespace {

Vec3 perpendicular(Random& random, const Vec3& direction) {
  return normalize(reject(random.direction(), direction));
}

PolygonGeometry random_star(Random& random, double size) {
  const Vec3 u = random.direction(), v = perpendicular(random, u);
  scene::Polygon raw;
  raw.points.clear();
  for (int i = 0; i < 9; ++i) {
    const double radius = size * random.between(0.3, 1), angle = 2 * std::numbers::pi * i / 9;
    raw.points.push_back(u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)));
  }
  return geometry(raw);
}

/// Calls f with a shape of each kind, of about the given size, about the origin.
template <class F>
void for_each_kind(Random& random, double size, F&& f) {
  const auto part = [&] { return size * random.between(0.2, 1); };
  const Vec3 axis = random.direction();
  f(SphereGeometry{{}, size});
  f(PlaneGeometry{axis, size * random.between(-1, 1)});
  for (const bool is_open : {false, true}) {
    scene::Cylinder cylinder;
    cylinder.axis = axis, cylinder.height = part(), cylinder.radius = part(), cylinder.open = is_open;
    f(geometry(cylinder));
    cylinder.infinite = !is_open;
    f(geometry(cylinder));
    f(geometry(scene::Cone{axis * -part(), axis * part(), part(), 0, is_open}));
    f(geometry(scene::Cone{axis * -part(), axis * part(), part(), part(), is_open}));
  }
  f(BoxGeometry{Vec3{-part(), -part(), -part()}, Vec3{part(), part(), part()}});
  f(DiscGeometry{{}, axis, size, size * random.between(0, 0.5)});
  f(TriangleGeometry{{random.direction() * size, random.direction() * size, random.direction() * size}});
  scene::Quad quad;
  quad.corner = random.vector(-size, 0), quad.edge_u = random.direction() * size,
  quad.edge_v = random.direction() * size;
  f(geometry(quad));
  f(random_star(random, size));
}

/// Calls f(shape, ray, center) for rays towards shapes of all kinds, from close by, from inside and from far away.
template <class F>
void for_each_encounter(std::uint64_t seed, int count, F&& f) {
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const double size = i % 2 == 0 ? 1 : random.magnitude(1e-6, 1e6);
    const Vec3 center = i % 3 == 0 ? Vec3{} : random.within_ball(std::min(1e6, 1e6 * size));
    for_each_kind(random, size, [&](const auto& about_origin) {
      const auto shape = placed(about_origin, Affine::translating(center));
      REQUIRE(shape);
      const Vec3 origin = center + random.step(0.1 * size, 1000 * size);
      const Vec3 target = center + random.within_ball(size);
      f(*shape, Ray{origin, (target - origin) * random.magnitude(1e-3, 1e3)}, random);
    });
  }
}

Box3 grown(const Box3& box, double by) {
  return {box.lower - Vec3{by, by, by}, box.upper + Vec3{by, by, by}};
}

/// A direction out of a surface, or into it: anywhere, or so flat that it all but runs within.
Vec3 spawned_direction(Random& random, const Vec3& normal, double side) {
  const double rise = random.bits() % 2 == 0 ? random.between(0.01, 1) : random.magnitude(1e-15, 1);
  return perpendicular(random, normal) * std::sqrt(std::max(0.0, 1 - rise * rise)) + normal * (side * rise);
}

template <class G>
constexpr bool is_flat =
    std::is_same_v<G, PlaneGeometry> || std::is_same_v<G, DiscGeometry> || std::is_same_v<G, TriangleGeometry> ||
    std::is_same_v<G, QuadGeometry> || std::is_same_v<G, PolygonGeometry>;

} // namespace

TEST_CASE("every shape: none is left out of what is tried here") {
  Random random(0);
  std::set<std::type_index> tried;
  for_each_kind(random, 1, [&]<class G>(const G&) { tried.insert(typeid(G)); });
  scene::ShapeKinds::for_each([&]<class S>() {
    INFO(std::string(S::noun));
    if constexpr (!scene::is_composite<S>) CHECK(tried.contains(typeid(geometry(S{}))));
  });
}

TEST_CASE("every shape: its box contains its hits") {
  int count = 0;
  for_each_encounter(1, 300, [&](const auto& shape, const Ray& ray, Random&) {
    for (const Hit& hit : hits(shape, ray)) {
      const SurfacePoint point = surface_point(shape, ray, hit);
      if constexpr (!std::is_same_v<std::decay_t<decltype(shape)>, PlaneGeometry>) {
        if (!grown(bounds(shape), point.error).contains(point.position)) FAIL_CHECK("a hit outside the box");
      }
      ++count;
    }
  });
  CHECK(count > 2000);
}

TEST_CASE("every shape: normals are unit vectors, and rays enter against them and leave along them") {
  for_each_encounter(2, 300, [&](const auto& shape, const Ray& ray, Random&) {
    for (const Hit& hit : hits(shape, ray)) {
      const SurfacePoint point = surface_point(shape, ray, hit);
      if (!(std::abs(length(point.normal) - 1) < 1e-15)) FAIL_CHECK("length " << length(point.normal));
    }
    if constexpr (requires { crossings(shape, ray); }) {
      if (!is_solid(shape)) return;
      const Crossings found = crossings(shape, ray);
      for (int i = 0; i < found.count; ++i) {
        const Hit& hit = found.at[static_cast<std::size_t>(i)];
        if (!std::isfinite(hit.t)) continue;
        const double along = dot(surface_point(shape, ray, hit).normal, normalize(ray.direction));
        if (i % 2 == 0 ? along > 1e-6 : along < -1e-6) FAIL_CHECK("crossing " << i << " the wrong way, " << along);
      }
    }
  });
}

TEST_CASE("every shape: the refined point is where the ray is, up to its rounding") {
  for_each_encounter(3, 300, [&](const auto& shape, const Ray& ray, Random&) {
    for (const Hit& hit : hits(shape, ray)) {
      const double way = magnitude(ray.origin) + hit.t * magnitude(ray.direction);
      const double slack =
          1e-12 * way / std::max(1e-3, std::abs(dot(surface_point(shape, ray, hit).normal, normalize(ray.direction))));
      if (!near(surface_point(shape, ray, hit).position, ray.at(hit.t), slack)) FAIL_CHECK("moved away");
    }
  });
}

TEST_CASE("every solid: what is inside is what lies between its crossings") {
  int count = 0;
  for_each_encounter(4, 300, [&](const auto& shape, const Ray& ray, Random& random) {
    if constexpr (requires { crossings(shape, ray); }) {
      if (!is_solid(shape)) return;
      const Crossings found = crossings(shape, ray);
      if (found.count == 0) return;
      const double enter = std::max(found.at[0].t, 0.0), leave = std::min(found.at[1].t, enter + 10);
      if (!(leave > enter + 1e-6 * std::abs(enter))) return;
      const double inside = enter + (leave - enter) * random.between(0.1, 0.9);
      if (!contains(shape, ray.at(inside))) FAIL_CHECK("outside between the crossings");
      if (found.at[0].t > 0 && contains(shape, ray.at(found.at[0].t * 0.999))) FAIL_CHECK("inside before the crossing");
      // The surface's own hits are the crossings ahead.
      const auto ahead = distances(shape, ray);
      for (int i = 0; i < 2; ++i) {
        const double t = found.at[static_cast<std::size_t>(i)].t;
        if (t > 0 && std::isfinite(t) && std::find(ahead.begin(), ahead.end(), t) == ahead.end())
          FAIL_CHECK("no hit at a crossing");
      }
      ++count;
    }
  });
  CHECK(count > 500);
}

TEST_CASE("every shape: a ray that leaves a surface does not meet it where it starts") {
  int count = 0;
  for_each_encounter(5, 600, [&](const auto& shape, const Ray& ray, Random& random) {
    using G = std::decay_t<decltype(shape)>;
    Hit hit;
    if (!intersect(shape, ray, {}, hit)) return;
    const SurfacePoint from = surface_point(shape, ray, hit);
    for (int i = 0; i < 8; ++i) {
      const double side = i % 2 == 0 ? 1 : -1;
      const double speed = random.magnitude(1e-3, 1e3);
      const Vec3 direction = spawned_direction(random, from.normal, side) * speed;
      if (!(dot(direction, from.normal) * side > 0)) continue;
      const Ray spawned{from.position + from.normal * (side * from.error), direction};
      ++count;
      Hit again;
      if (!intersect(shape, spawned, {}, again)) continue;
      // Inwards, a curved surface is met across the inside: not sooner than its chord, which is the longer the steeper
      // the ray. All shapes here curve with a radius of at most their size.
      if (is_flat<G> || (side > 0 && is_solid(shape)) || (again.part == hit.part && std::is_same_v<G, BoxGeometry>))
        FAIL_CHECK("meets it again at " << again.t << ", offset " << from.error);
    }
  });
  CHECK(count > 20000);
}

TEST_CASE("every round shape: inwards the next hit is across the inside") {
  Random random(6);
  int count = 0;
  for (int i = 0; i < 20000; ++i) {
    const double size = random.magnitude(1e-6, 1e6);
    const Vec3 center = random.within_ball(std::min(1e6, 1e6 * size));
    const Vec3 normal = random.direction();
    const SphereGeometry sphere{center, size};
    const SurfacePoint from = surface_point(sphere, {center + normal * (2 * size), -normal}, {size, 0});
    const Vec3 direction = spawned_direction(random, from.normal, -1);
    const double rise = -dot(direction, from.normal);
    if (!(rise > 0)) continue; // the flattest are rounded to what does not lead inwards
    ++count;
    const auto found = distances(sphere, {from.position - from.normal * from.error, direction});
    REQUIRE(found.size() == 1);
    // The chord of a circle under the angle α to the tangent: 2 r sin α; the offset is worth error / sin α.
    CHECK(std::abs(found[0] - 2 * size * rise) <= 1e-9 * size * rise + 4 * from.error / rise);
  }
  CHECK(count > 19900);
}

TEST_CASE("every shape: carrying the ray to the shape and placing the shape agree") {
  Random random(8);
  int count = 0;
  for (int i = 0; i < 300; ++i) {
    const double scale = random.magnitude(0.01, 100);
    const Affine mirror = Affine::scaling({random.sign() * scale, scale, scale});
    const Affine turn = Affine::rotating_xyz(random.vector(-180, 180)) * mirror;
    const Affine map = Affine::translating(random.vector(-10, 10)) * turn;
    const Affine back = *inverse(map);
    for_each_kind(random, 1, [&](const auto& shape) {
      const auto image = placed(shape, map);
      if (!image) return; // a box that is turned
      const Vec3 origin = map.point(random.vector(-6, 6)), target = map.point(random.vector(-0.8, 0.8));
      const Ray ray{origin, target - origin};
      Hit direct, carried;
      const bool is_hit = intersect(*image, ray, {}, direct);
      const bool is_hit_too = intersect(shape, back.ray(ray), {}, carried);
      if (is_hit != is_hit_too) { // only at a silhouette
        FAIL_CHECK("hit only one way");
        return;
      }
      if (!is_hit) return;
      ++count;
      const SurfacePoint a = surface_point(*image, ray, direct);
      const SurfacePoint b = mapped(surface_point(shape, back.ray(ray), carried), map, back);
      const double cosine = std::abs(dot(a.normal, normalize(ray.direction)));
      CHECK(std::abs(direct.t - carried.t) <= 1e-12 * direct.t / std::max(cosine, 1e-3));
      CHECK(near(a.position, b.position, 1e-11 * (1 + length(ray.direction)) / std::max(cosine, 1e-3)));
      // A triangle's face turns with the order of its corners.
      const bool is_turned = std::is_same_v<std::decay_t<decltype(shape)>, TriangleGeometry> && map.determinant() < 0;
      CHECK(near(a.normal, is_turned ? -b.normal : b.normal, 1e-9));
    });
  }
  CHECK(count > 500);
}

TEST_CASE(
    "every shape: a ray that leaves an instance, stretched, sheared and far away, does not meet it where it starts") {
  Random random(12);
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    const Affine shear{{1, random.between(-1, 1), 0}, {0, 1, random.between(-1, 1)}, {random.between(-1, 1), 0, 1}, {}};
    const auto factor = [&] { return random.signed_magnitude(0.01, 100); };
    const Affine stretch = Affine::scaling({factor(), factor(), factor()});
    const Affine turn = Affine::rotating_xyz(random.vector(-180, 180));
    const Affine map = Affine::translating(random.step(1, 1e6)) * turn * shear * stretch;
    const auto back = inverse(map);
    if (!back) continue;
    for_each_kind(random, 1, [&](const auto& shape) {
      using G = std::decay_t<decltype(shape)>;
      const Vec3 origin = map.point(random.vector(-6, 6)), target = map.point(random.vector(-0.8, 0.8));
      const Ray local = back->ray({origin, target - origin});
      Hit hit;
      if (!intersect(shape, local, {}, hit)) return;
      const SurfacePoint from = mapped(surface_point(shape, local, hit), map, *back);
      for (int k = 0; k < 4; ++k) {
        const double side = k % 2 == 0 ? 1 : -1;
        const double rise = random.magnitude(1e-6, 1); // carrying a direction over leaves an error of its own
        const Vec3 direction = perpendicular(random, from.normal) + from.normal * (side * rise);
        const Ray spawned = back->ray({from.position + from.normal * (side * from.error), direction});
        ++count;
        Hit again;
        if (intersect(shape, spawned, {}, again) && (is_flat<G> || (side > 0 && is_solid(shape))))
          FAIL_CHECK("meets it again at " << again.t);
      }
    });
  }
  CHECK(count > 5000);
}
