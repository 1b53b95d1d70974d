#include "lang/check/errors/dialects.hpp"

#include "lang/text/suggest.hpp"

#include <fmt/format.h>

namespace rt::lang {
namespace {

struct ForeignName {
  std::string_view theirs;
  std::string_view advice;
};

/// Names of things and functions in POV-Ray, OpenSCAD, three.js and the like.
constexpr ForeignName foreign_names[] = {
    {"cube", "write `box`"},
    {"cuboid", "write `box`"},
    {"block", "write `box`"},
    {"ball", "write `sphere`"},
    {"tube", "write `cylinder { open: true }`"},
    {"circle", "write `disc`"},
    {"square", "write `quad`"},
    {"rectangle", "write `quad` with `corner`, `edge_u` and `edge_v`"},
    {"rect", "write `quad` with `corner`, `edge_u` and `edge_v`"},
    {"parallelogram", "write `quad`"},
    {"ellipse", "write `disc { scale: [x, y, z] }`"},
    {"hemisphere", "write `sphere {} - plane { y: 0 }`"},
    {"dome", "write `sphere {} - plane { y: 0 }`"},
    {"pipe", "write `cylinder { open: true }`"},
    {"floor", "write `plane { y: 0 }`"},
    {"ground", "write `plane { y: 0 }`"},
    {"infinite_plane", "write `plane { y: 0 }`"},
    {"object", "write the thing's own name: `ball { at: … }`"},
    {"instance", "write the thing's own name: `ball { at: … }`"},
    {"clone", "write the thing's own name: `ball { at: … }`"},
    {"copy", "write the thing's own name: `ball { at: … }`"},
    {"array", "write `for i in 0..9 { … }`"},
    {"grid", "write `for x in 0..9 { for z in 0..9 { … } }`"},
    {"polyhedron", "write a `group` of `polygon`s"},
    {"mesh", "write a `group` of `triangle`s"},
    {"Mesh", "write a `group` of `triangle`s"},
    {"triangle_mesh", "write a `group` of `triangle`s"},
    {"prism", "write a `group` of `polygon`s"},
    {"wedge", "write a `group` of `polygon`s"},
    {"pyramid", "write a `cone`, or a `group` of `triangle`s"},
    {"tetrahedron", "write a `group` of `triangle`s"},
    {"octahedron", "write a `group` of `triangle`s"},
    {"icosahedron", "write a `group` of `triangle`s"},
    {"dodecahedron", "write a `group` of `polygon`s"},
    {"height_field", "write a `group` of `triangle`s"},
    {"heightfield", "write a `group` of `triangle`s"},
    {"terrain", "write a `group` of `triangle`s"},
    {"bicubic_patch", "write a `group` of `triangle`s"},
    {"obj", "models cannot be imported; use a `group` of `triangle`s"},
    {"stl", "models cannot be imported; use a `group` of `triangle`s"},
    {"ply", "models cannot be imported; use a `group` of `triangle`s"},
    {"lathe", "stack `cone`s and `cylinder`s"},
    {"sor", "stack `cone`s and `cylinder`s"},
    {"blob", "write a `union` of `sphere`s"},
    {"rounded_box", "write a `union` of `box`es, `cylinder`s and `sphere`s"},
    {"superellipsoid", "there is none: the shapes are listed by `rtlang doc`"},
    {"isosurface", "there is none: the shapes are listed by `rtlang doc`"},
    {"parametric", "there is none: the shapes are listed by `rtlang doc`"},
    {"julia_fractal", "there is none: the shapes are listed by `rtlang doc`"},
    {"ellipsoid", "write `sphere { scale: [x, y, z] }`"},
    {"ring", "write `disc { radius: …, hole: … }`"},
    {"annulus", "write `disc { radius: …, hole: … }`"},
    {"line", "write a thin `cylinder { from: …, to: …, radius: 0.01 }`"},
    {"curve", "a `for` sets `sphere`s or `cylinder`s along it"},
    {"spline", "a `for` sets `sphere`s or `cylinder`s along it"},
    {"bezier", "a `for` sets `sphere`s or `cylinder`s along it"},
    {"capsule", "write a `cylinder` and two `sphere`s, joined by `|`"},
    {"torus", "there is none yet: a `for` sets `sphere`s or `cylinder`s around a circle"},
    {"text", "there are no letters; a `polygon` draws any outline"},
    {"text3d", "there are no letters; a `polygon` draws any outline"},
    {"image", "there are no image textures; `brick`, `marble`, `noise` and others are patterns"},
    {"image_map", "there are no image textures; `brick`, `marble`, `noise` and others are patterns"},
    {"plastic", "write `material { color: …, specular: 0.5 }`"},
    {"metal", "write `gold`, `silver`, `copper`, `chrome`, `iron`, …"},
    {"phong", "write `material { color: …, specular: 0.5 }`"},
    {"lambert", "write `material { color: … }`, or `matte`"},
    {"bump_map", "write `material { bump: noise { scale: 0.1 } }`: a pattern of heights"},
    {"normal_map", "write `material { bump: noise { scale: 0.1 } }`: a pattern of heights"},
    {"hull", "solids are combined with `|`, `&` and `-`"},
    {"minkowski", "solids are combined with `|`, `&` and `-`"},
    {"linear_extrude", "write a `box`, a `cylinder` or a `group` of `polygon`s"},
    {"rotate_extrude", "write a `cylinder`, a `cone` or a `sphere`"},
    {"extrude", "write a `box`, a `cylinder` or a `group` of `polygon`s"},
    {"transform", "write `thing.rotate(…).move(…)`, or `thing.transform(matrix)`"},
    {"emitter", "write `mode: path`, and a shape whose material has `emission`"},
    {"area_light", "write `mode: path`, and a shape whose material has `emission`"},
    {"AreaLight", "write `mode: path`, and a shape whose material has `emission`"},
    {"RectAreaLight", "write `mode: path`, and a shape whose material has `emission`"},
    {"lamp", "write `light { at: …, color: … }`"},
    {"sky_sphere", "write `sky { zenith: …, horizon: … }`"},
    {"skybox", "write `sky { zenith: …, horizon: … }`"},
    {"hdri", "write `sky { zenith: …, horizon: … }`"},
    {"environment", "write `sky { zenith: …, horizon: … }`"},
    {"background", "write `background: skyblue` at the top level"},
    {"ambient", "write `ambient: 0.1` at the top level"},
    {"scene", "the file is the scene: set its properties at the top level"},
    {"world", "the file is the scene: set its properties at the top level"},
    {"fog", "there is no fog"},
    {"smoke", "there is no fog"},
    {"color", "write `material: red`, or `rgb(r, g, b)`"},
    {"Color", "write `rgb(r, g, b)`"},
    {"size", "write `size: [800, 600]` at the top level"},
    {"look_at", "write `camera { at: …, look_at: … }`"},
    {"merge", "write `union { … }`, or `a | b`"},
    {"subtract", "write `difference { … }`, or `a - b`"},
    {"intersect", "write `intersection { … }`, or `a & b`"},
    {"light_source", "write `light { at: …, color: … }`"},
    {"point_light", "write `light { at: …, color: … }`"},
    {"PointLight", "write `light { at: …, color: … }`"},
    {"pointlight", "write `light { at: …, color: … }`"},
    {"spotlight", "write `spot { at: …, look_at: …, angle: … }`"},
    {"spot_light", "write `spot { at: …, look_at: …, angle: … }`"},
    {"SpotLight", "write `spot { at: …, look_at: …, angle: … }`"},
    {"DirectionalLight", "write `sun { direction: … }`"},
    {"directional_light", "write `sun { direction: … }`"},
    {"sunlight", "write `sun { direction: … }`"},
    {"sun_light", "write `sun { direction: … }`"},
    {"parallel", "write `sun { direction: … }`"},
    {"hemisphere_light", "write `ambient: 0.1` at the top level"},
    {"AmbientLight", "write `ambient: 0.1` at the top level"},
    {"ambient_light", "write `ambient: 0.1` at the top level"},
    {"PerspectiveCamera", "write `camera { at: …, look_at: …, fov: … }`"},
    {"OrthographicCamera", "write `camera { projection: orthographic, width: … }`"},
    {"texture", "write `material { … }`"},
    {"pigment", "write `material { color: … }`"},
    {"finish", "write `material { … }`"},
    {"normal", "a vector is written `[x, y, z]`"},
    {"interior", "write `material { ior: … }`"},
    {"global_settings", "properties of the scene stand at the top level: `max_depth: 8`"},
    {"translate", "write `thing.move([x, y, z])`, or `at: [x, y, z]`"},
    {"rotate", "write `thing.rotate(y: 30)`, or `rotate: [x, y, z]`"},
    {"scale", "write `thing.scale(2)`, or `scale: 2`"},
    {"assert", "write `expect condition` on a line of its own: `rtlang test` checks it"},
    {"echo", "write `print(…)`"},
    {"printf", "write `print(…)`"},
    {"console", "write `print(…)`"},
    {"translated", "write `thing.move([x, y, z])`"},
    {"position", "write `at: [x, y, z]`"},
    {"location", "write `at: [x, y, z]`"},
    {"checkerboard", "write `checker { a: …, b: … }`"},
    {"checkered", "write `checker { a: …, b: … }`"},
    {"declare", "write `name = value`"},
    {"local", "write `name = value`"},
    {"let", "write `name = value`, without `let`"},
    {"var", "write `name = value`, without `var`"},
    {"const", "write `name = value`, without `const`"},
    {"module", "write `def name(…) { … }`"},
    {"macro", "write `def name(…) { … }`, or `fn name(…) = …`"},
    {"function", "write `fn name(…) = …`"},
    {"import", "write `use \"file.rtl\" as name`, or `include \"file.rtl\"`"},
    {"while", "write `for x in … { … }`"},
    {"True", "write `true`"},
    {"False", "write `false`"},
    {"None", "write `none`"},
    {"null", "write `none`"},
    {"nil", "write `none`"},
    {"rgbt", "write `rgb(r, g, b)`, and `refract` in the material"},
    {"rgbf", "write `rgb(r, g, b)`, and `refract` in the material"},
    {"srgb", "write `rgb(r, g, b)`"},
    {"vec3", "write `[x, y, z]`"},
    {"Vector3", "write `[x, y, z]`"},
    {"vcross", "write `cross(a, b)`"},
    {"vdot", "write `dot(a, b)`"},
    {"vlength", "write `length(v)`"},
    {"vnormalize", "write `normalize(v)`"},
    {"norm", "write `length(v)`"},
    {"rand", "write `random(key)`: equal keys give equal numbers"},
    {"rands", "write `random(key)`: equal keys give equal numbers"},
    {"noise", "write `noise_at(p)`"},
    {"snoise", "write `noise_at(p)`"},
    {"concatenate", "write `concat(a, b)`"},
    {"size_of", "write `len(list)`"},
    {"ln", "write `log(x)`"},
    {"asind", "write `asin(x)`: angles are degrees"},
    {"acosd", "write `acos(x)`: angles are degrees"},
    {"radians", "angles are degrees everywhere; `0.5rad` is a number in radians"},
    {"degrees", "angles are degrees everywhere; `0.5rad` is a number in radians"},
    {"PI", "write `pi`"},
};

struct ForeignProperty {
  std::string_view theirs;
  std::string_view ours; ///< mentioned only if the noun has it
};

constexpr ForeignProperty properties[] = {
    {"location", "at"},
    {"center", "at"},
    {"centre", "at"},
    {"position", "at"},
    {"pos", "at"},
    {"translate", "at"},
    {"origin", "at"},
    {"eye", "at"},
    {"x", "at"},
    {"y", "at"},
    {"z", "at"},
    {"lookat", "look_at"},
    {"direction", "look_at"},
    {"target", "look_at"},
    {"point_at", "look_at"},
    {"sky", "up"},
    {"angle", "fov"},
    {"field_of_view", "fov"},
    {"rotation", "rotate"},
    {"orientation", "rotate"},
    {"texture", "material"},
    {"pigment", "material"},
    {"finish", "material"},
    {"surface", "material"},
    {"from", "at"},
    {"to", "look_at"},
    {"width", "size"},
    {"height", "size"},
    {"depth", "size"},
    {"w", "size"},
    {"edge", "size"},
    {"side", "size"},
    {"color", "background"},
    {"sky", "background"},
    {"r", "radius"},
    {"d", "radius"},
    {"diameter", "radius"},
    {"size", "radius"},
    {"h", "height"},
    {"length", "height"},
    {"length", "size"},
    {"dimensions", "size"},
    {"colour", "color"},
    {"diffuse_color", "color"},
    {"albedo", "color"},
    {"phong", "specular"},
    {"phong_size", "shininess"},
    {"exponent", "shininess"},
    {"reflection", "reflect"},
    {"reflectivity", "reflect"},
    {"mirror", "reflect"},
    {"transmit", "refract"},
    {"filter", "refract"},
    {"transparency", "refract"},
    {"opacity", "refract"},
    {"refraction", "ior"},
    {"index", "ior"},
    {"emissive", "emission"},
    {"glow", "emission"},
    {"metalness", "metallic"},
    {"clearcoat", "coat"},
    {"absorption", "absorb"},
    {"brightness", "intensity"},
    {"power", "intensity"},
    {"strength", "intensity"},
    {"attenuation", "fade"},
    {"fade_distance", "fade"},
    {"decay", "fade"},
    {"shadowless", "shadows"},
    {"no_shadow", "casts_shadow"},
    {"cast_shadow", "casts_shadow"},
    {"dir", "direction"},
    {"radius1", "radius"},
    {"radius2", "top_radius"},
    {"r1", "radius"},
    {"r2", "top_radius"},
    {"base_radius", "radius"},
    {"cap_radius", "top_radius"},
    {"open_ended", "open"},
    {"vertices", "points"},
    {"corners", "points"},
    {"p1", "from"},
    {"p2", "to"},
    {"start", "from"},
    {"end", "to"},
    {"distance", "offset"},
    {"inner_radius", "hole"},
    {"resolution", "size"},
    {"background_color", "background"},
    {"max_trace_level", "max_depth"},
    {"max_bounces", "max_depth"},
    {"antialias", "samples"},
    {"antialiasing", "samples"},
    {"spp", "samples"},
    {"falloff_angle", "falloff"},
};

} // namespace

std::string dialect_name(std::string_view name) {
  for (const ForeignName& word : foreign_names) {
    if (word.theirs == name) return std::string(word.advice);
  }
  return {};
}

namespace {

std::string size_advice(const NodeType& type) {
  switch (type.properties[*type.find("size")].type) {
  case PropertyType::size:
    return "write `size: [width, height, depth]`";
  case PropertyType::resolution:
    return "write `size: [width, height]`";
  default:
    return "write `size`, the length of an edge";
  }
}

} // namespace

std::string dialect_property(std::string_view property, const NodeType* type) {
  for (const ForeignProperty& word : properties) {
    if (word.theirs != property || !type->find(word.ours)) continue;
    if (property == "diameter" || property == "d") return "write `radius`, half of the diameter";
    if (property == "x" || property == "y" || property == "z") return "write `at: [x, y, z]`";
    if (property == "direction" && word.ours == "look_at") return "write `look_at`, a point on the way";
    if (property == "opacity") return "write `refract`, which is 0 where nothing shines through";
    if (word.ours == "size" && property != "dimensions" && property != "resolution") return size_advice(*type);
    return fmt::format("write `{}`", word.ours);
  }
  if (type->has_chain() && property == "move") return "write `at`, or `.move(…)` behind the thing";
  if (type->is_shape() && (property == "color1" || property == "color2")) return "colours belong to the material";
  return {};
}

void advise_on_property(Diagnostic& d, std::string_view whose, std::string_view property, const NodeType& type,
                        std::span<const std::string_view> known) {
  d.label = dialect_property(property, &type);
  if (d.label.empty())
    if (const auto guess = nearest(property, known)) d.label = fmt::format("did you mean `{}`?", *guess);
  d.notes.push_back({std::nullopt, fmt::format("{} takes {}", whose, fmt::join(known, ", "))});
}

} // namespace rt::lang
