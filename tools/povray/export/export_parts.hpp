#pragma once

#include "tools/povray/export/export.hpp"
#include "tools/povray/export/sdl.hpp"

#include <optional>
#include <string>
#include <vector>

/// The parts of the exporter, each for one kind of description.
namespace rt::tools::povray {

/// POV-Ray drops whatever is farther away along a ray.
inline constexpr double farthest_hit = 1e7;

/// A primitive of POV-Ray: `keyword { body … }`.
struct Primitive {
  std::string keyword;
  std::string body;
};
/// For a shape that is not a composite.
Primitive primitive(const scene::Shapes& shapes, scene::ShapeRef shape);

/// A disc with almost no inside: POV-Ray treats everything below a disc as its inside.
Primitive thin_primitive(const scene::Disc& disc);

/// Whether the shape is a triangle with vertex normals, and whether it contains one.
bool is_smooth(const scene::Shapes& shapes, scene::ShapeRef shape);
bool has_smooth(const scene::Scene& scene, const scene::Object& object);
/// POV-Ray silently drops a triangle with vertex normals that are not all on the same side of it; it checks this after
/// each transform.
bool is_dropped(const scene::Triangle& triangle);
/// The places of the triangles that POV-Ray would drop however their own transforms are written.
std::vector<scene::Origin> dropped_triangles(const scene::Scene& scene);
/// The triangle with its own transforms applied, if POV-Ray would drop it before or between them but not after.
std::optional<scene::Triangle> moved_to_be_kept(const scene::Scene& scene, const scene::Object& object);
Primitive primitive(const scene::Triangle& triangle);

/// What the file is and how to render the same picture with POV-Ray, as comments.
void write_introduction(Writer& out, const scene::Scene& scene);
/// The version of the language and the global settings. A ray of less weight than `bailout` is not traced.
void write_settings(Writer& out, const scene::Scene& scene, double bailout, std::vector<Inexact>& inexact);

/// `head` is what precedes the brace: `texture` or `#declare name = texture`.
void write_texture(Writer& out, const std::string& head, const scene::Scene& scene, const scene::Material& material,
                   std::vector<std::string>& inexact);
/// Whether surfaces of this material need to know the index of refraction.
bool needs_interior(const scene::Material& material);
std::string interior(const scene::Material& material);

/// Whether POV-Ray considers the point, in object space, inside. Every shape that is not a composite defines it.
bool holds(const scene::Sphere& sphere, const Vec3& point);
bool holds(const scene::Plane& plane, const Vec3& point);
bool holds(const scene::Box& box, const Vec3& point);
bool holds(const scene::Cylinder& cylinder, const Vec3& point);
bool holds(const scene::Cone& cone, const Vec3& point);
bool holds(const scene::Disc& disc, const Vec3& point);
bool holds(const scene::Triangle& triangle, const Vec3& point);
bool holds(const scene::Quad& quad, const Vec3& point);
bool holds(const scene::Polygon& polygon, const Vec3& point);
/// Whether POV-Ray considers the point, in the space that `placement` leads to, inside the object.
bool holds_in_povray(const scene::Scene& scene, const scene::Object& object, const Map& placement, const Vec3& point);
/// The object's complete placement in its parent.
scene::Placement placement_of(const scene::Scene& scene, const scene::Object& object);

void write_light(Writer& out, const scene::Light& light, const scene::Camera& camera);
/// Where the view's rays start: the eye, or the centre and corners of an orthographic view.
std::vector<Vec3> ray_origins(const scene::Camera& camera, scene::Resolution size);
void write_camera(Writer& out, const scene::Camera& camera, scene::Resolution size);

/// Declarations that `Pass::depth` needs, and the texture that shows the distance from the camera.
void write_depth_functions(Writer& out, const scene::Camera& camera);
inline constexpr const char* depth_texture = "texture { distance_texture }";
std::string id_texture(std::uint32_t id);
/// Six lights without shadows: what they illuminate shows its normal.
void write_normal_lights(Writer& out);

} // namespace rt::tools::povray
