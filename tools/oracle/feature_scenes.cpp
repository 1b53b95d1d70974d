#include "tools/oracle/feature_scenes.hpp"

#include <string_view>

namespace rt::tools::oracle {
namespace {

// Everything but the subject of the scene.
constexpr std::string_view stage = R"(size: [64, 48]
background: #334b66
ambient: 0.15
floor = checker { a: #c8c0b0, b: #54606c }
)";
constexpr std::string_view usual_camera = "camera { at: [1.7, 1.9, 4.6], look_at: [0.1, 0.2, 0], fov: 42 }\n";
constexpr std::string_view usual_light = "light { at: [3.1, 4.7, 3.3], intensity: 0.8 }\n";
constexpr std::string_view usual_floor = "box { from: [-3, -1.4, -3], to: [3, -1.2, 3], material: floor }\n";

struct FeatureEntry {
  const char* name;
  const char* text;
};

constexpr FeatureEntry shapes[] = {
    {"sphere", "sphere { radius: 1.1, material: tomato }"},
    {"plane_normal", "plane { normal: [0.2, 1, 0.3], offset: -0.7, material: floor }"},
    {"plane_x", "plane { x: -0.9, material: khaki }"},
    {"plane_y", "plane { y: -0.4, material: floor }"},
    {"plane_z", "plane { z: -1.1, material: floor }"},
    {"cylinder_from_to", "cylinder { from: [-0.7, -0.9, 0.2], to: [0.8, 0.9, -0.3], radius: 0.5, material: teal }"},
    {"cylinder_axis", "cylinder { axis: [0.3, 1, 0.2], height: 1.7, radius: 0.6, material: teal }"},
    {"cylinder_open", "cylinder { axis: [0.7, 0.6, 0.4], height: 1.6, radius: 0.7, open: true, material: teal }"},
    {"cylinder_infinite", "cylinder { axis: [1, 0.4, -0.3], radius: 0.5, infinite: true, material: teal }"},
    {"cone", "cone { from: [0, -1, 0], to: [0.2, 1.1, 0], radius: 0.9, material: orchid }"},
    {"cone_frustum", "cone { from: [0, -1, 0], to: [0.3, 0.8, 0.2], radius: 0.4, top_radius: 0.9, material: orchid }"},
    {"cone_open",
     "cone { from: [0, -1, 0], to: [0, 0.8, 0.3], radius: 0.9, top_radius: 0.5, open: true, material: orchid }"},
    {"cone_even", "cone { from: [0, -1, 0], to: [0, 0.8, 0.3], radius: 0.6, top_radius: 0.6, material: orchid }"},
    {"box_size", "box { size: [1.3, 1.1, 0.9], rotate: [10, 25, 5], material: peru }"},
    {"box_corners", "box { from: [0.8, -0.9, 0.7], to: [-0.7, 0.6, -0.5], material: peru }"},
    {"disc", "disc { normal: [0.4, 1, 0.7], radius: 1.2, material: gold_paint }"},
    {"disc_hole", "disc { normal: [0.4, 1, 0.7], radius: 1.2, hole: 0.45, material: gold_paint }"},
    {"triangle", "triangle { points: [[-1.1, -0.8, 0.1], [1.2, -0.7, 0.3], [0.1, 1.2, -0.4]], material: skyblue }"},
    {"triangle_smooth", "triangle { points: [[-1.1, -0.8, 0.1], [1.2, -0.7, 0.3], [0.1, 1.2, -0.4]], normals: [[-0.6, "
                        "-0.3, 1], [0.7, -0.2, 1], [0, 0.9, 1]], material: skyblue }"},
    {"triangle_smooth_scaled",
     "triangle { points: [[-1.1, -0.8, 0.1], [1.2, -0.7, 0.3], [0.1, 1.2, -0.4]], normals: [[-0.4, -0.1, 1], [0.5, "
     "0.1, 1], [0, 0.7, 1]], scale: [1.2, 0.6, 1.7], material: skyblue }.shear(xy: 0.4)"},
    {"triangle_smooth_kept",
     "triangle { points: [[-1.1, -0.8, 0.1], [1.2, -0.7, 0.3], [0.1, 1.2, -0.4]], normals: [[-0.6, -0.3, 1], [0.7, "
     "-0.2, 1], [0, 0.9, 1]], scale: [1.2, 0.6, 1.7], material: floor }.shear(xy: 0.4).shear(xy: -0.4)"},
    {"quad_square", "quad { size: 1.7, normal: [0.3, 0.5, 1], material: floor }"},
    {"quad_edges",
     "quad { corner: [-0.9, -0.8, 0.3], edge_u: [1.6, 0.2, -0.4], edge_v: [0.3, 1.5, 0.2], material: khaki }"},
    {"quad_points", "quad { points: [[-1, -0.9, 0], [1.1, -0.7, 0], [0.8, 1, 0], [-0.7, 0.8, 0]], material: khaki }"},
    {"polygon", "polygon { points: [[-1.1, -0.9, 0], [1, -0.8, 0], [0.2, -0.1, 0], [0.9, 1.1, 0], [-0.8, 0.7, 0]], "
                "rotate: [0, 20, 0], material: khaki }"},
    {"union_of_solids", "(sphere { radius: 0.8 } | box { size: 1.1, at: [0.6, 0.3, 0.2] }) { material: peru }"},
    {"intersection_of_solids",
     "(sphere { radius: 0.9, material: tomato } & box { size: 1.4, rotate: [20, 30, 0] }) { material: peru }"},
    {"difference_of_solids", "difference { material: peru, box { size: 1.6, rotate: [15, 30, 0] }, sphere { radius: "
                             "0.95, at: [0.2, 0.2, 0.3], material: tomato } }"},
    {"half_space",
     "(sphere { radius: 1 } & plane { normal: [0.4, 1, 0.5], offset: 0.2, material: khaki }) { material: peru }"},
    {"solid_of_solids",
     "((box { size: 1.5 } & sphere { radius: 1 }) - cylinder { axis: [0, 1, 0.2], height: 3, radius: 0.4 } - cylinder "
     "{ axis: [1, 0, 0], height: 3, radius: 0.4 }) { material: peru, rotate: [10, 30, 0] }"},
    {"group", "group { at: [0.2, 0, 0], rotate: [10, 40, 0], scale: 0.9, material: floor, sphere { radius: 0.6 }, box "
              "{ size: 0.7, at: [0.9, 0.2, 0], material: tomato } }"},
    {"instances", "part = group { sphere { radius: 0.4 }, cone { from: [0, 0.3, 0], to: [0, 0.9, 0], radius: 0.3 } "
                  "}\npart { at: [-0.9, 0, 0], material: peru }\npart { at: [0.9, 0, 0.2], rotate: [0, 0, 40], "
                  "material: floor }.scale(1.3)\npart { at: [0, 0.3, -0.8] }.shear(xy: 0.5)"},
};

constexpr FeatureEntry transforms[] = {
    {"scale_uneven", "sphere { radius: 0.8, scale: [1.4, 0.7, 1.1], rotate: [20, 30, 40], material: floor }"},
    {"scale_mirrored", "cone { radius: 0.8, scale: [-1.2, 0.9, 1], rotate: [0, 0, 60], material: floor }"},
    {"chain_scale_about", "box { rotate: [10, 20, 0], material: peru }.scale([1.4, 0.8, 1.2], about: [0.3, 0.2, 0])"},
    {"chain_rotate_axis",
     "box { size: [1.4, 0.6, 1], material: floor }.rotate(axis: [1, 2, 3], angle: 50, about: [0.1, 0, 0])"},
    {"chain_shear", "box { size: 1.1, material: floor }.shear(xy: 0.5, zx: 0.3)"},
    {"chain_mirror",
     "cone { from: [0.2, -0.5, 0], to: [0.9, 0.8, 0.3], radius: 0.6, material: floor }.mirror([1, 0.4, 0.2])"},
    {"chain_matrix", "cylinder { height: 1.4, radius: 0.6, material: floor }.transform([[1, 0.3, 0, 0.1], [0, 0.9, "
                     "0.2, 0], [0.2, 0, 1.1, 0.3]])"},
    {"shear_then_turn",
     "torus_like = (cylinder { height: 0.5, radius: 1 } - cylinder { height: 1, radius: 0.6 })\ntorus_like { material: "
     "peru, scale: [1.2, 1, 0.8] }.shear(yx: 0.4).rotate([50, 20, 10]).move(y: 0.2)"},
};

constexpr FeatureEntry materials[] = {
    {"color_only", "color: peru"},
    {"ambient_high", "color: peru, ambient: 2.2"},
    {"diffuse_low", "color: peru, diffuse: 0.35"},
    {"emission", "color: peru, emission: 0.4, diffuse: 0.2"},
    {"specular_blinn", "color: peru, specular: 0.7, shininess: 35"},
    {"specular_phong", "color: peru, specular: 0.7, shininess: 35, highlight: phong"},
    {"specular_metallic", "color: peru, specular: 0.9, shininess: 12, metallic: 0.8"},
    {"reflect_grey", "color: peru, reflect: 0.45"},
    {"reflect_color", "color: white, reflect: linear_rgb(0.7, 0.4, 0.2), diffuse: 0.3"},
    {"reflect_metallic", "color: gold, reflect: 0.6, metallic: 1, diffuse: 0.3, specular: 0.5"},
    {"reflect_fresnel", "color: peru, reflect: 1, fresnel: true, ior: 1.5"},
    {"refract_straight", "color: khaki, refract: 0.7"},
    {"refract_glass", "color: white, refract: 0.95, ior: 1.5, diffuse: 0.05"},
    {"refract_fresnel",
     "color: #e0f0e8, refract: 0.95, ior: 1.5, reflect: 1, fresnel: true, diffuse: 0.05, specular: 0.5"},
    {"refract_thin", "color: white, refract: 0.9, ior: 0.75, diffuse: 0.1"},
    {"refract_mirror", "color: skyblue, refract: 0.6, reflect: 0.3, ior: 1.25, specular: 0.4, metallic: 0.4"},
    {"pattern_nested",
     "color: checker { a: checker { a: tomato, b: white, scale: 0.13 }, b: teal, scale: 0.45, rotate: [10, 20, 30] }"},
    {"pattern_of_numbers", "color: checker { a: khaki, b: teal, scale: 0.3 }, ambient: checker { a: 0, b: 2, scale: "
                           "0.5 }, diffuse: checker { a: 0.9, b: 0.3, scale: 0.23, at: [0.1, 0.1, 0.1] }, emission: "
                           "checker { a: 0, b: 0.3, scale: 0.4, rotate: [0, 0, 45] }"},
    {"pattern_of_finish",
     "color: peru, specular: checker { a: 0.8, b: 0.1, scale: 0.4 }, shininess: checker { a: 60, b: "
     "5, scale: 0.3 }, metallic: checker { scale: 0.5 }, reflect: checker { a: skyblue, b: 0.05, "
     "scale: 0.35 }"},
    {"pattern_of_refract",
     "color: khaki, refract: checker { a: 0.9, b: 0, scale: 0.45 }, ior: 1.25, reflect: 0.5, fresnel: true"},
    {"pattern_by_function", "color: fn(p) => hsv(400 * length(p), 0.7, 0.5 + 0.5 * sin(900 * p.y))"},
    {"pattern_by_function_of_numbers",
     "color: khaki, specular: fn(p) => abs(sin(400 * p.x)), reflect: pattern { of: fn(p) => rgb(p.x % 1, 0.2, "
     "p.y % 1), scale: 0.4, rotate: [10, 20, 30] }, emission: fn(p) => if p.z > 0.2 { 0.3 } else { 0 }"},
    {"stripes", "color: stripes { a: teal, b: checker { a: khaki, b: tomato, scale: 0.3 }, width: 0.3, scale: 0.3, "
                "rotate: [0, 20, 30] }"},
    {"tiles", "color: tiles { a: teal, b: white, mortar: tomato, joint: 0.125, scale: 0.3, at: [0.1, 0.1, 0.1] }"},
    {"brick", "color: brick { size: [0.4, 0.2, 0.3], joint: 0.03125 }, specular: brick { mortar: 0, color: 0.8, size: "
              "[0.4, 0.2, 0.3], joint: 0.03125 }"},
    {"hexagon", "color: hexagon { a: teal, b: khaki, c: tomato, scale: 0.25, rotate: [70, 0, 10] }"},
    {"dots", "color: dots { ground: khaki, color: crimson, radius: 0.3, scale: 0.35 }"},
    {"gradient", "color: gradient { direction: [1, 2, 0], frequency: 2.5, phase: 0.2, stops: [[0, navy], [0.4, teal], "
                 "[1, white]] }"},
    {"gradient_of_kinds", "color: gradient { kind: radial, wave: triangle, frequency: 4, stops: [[0.1, gradient { "
                          "kind: angular, frequency: 3, wave: sine }], [1, tomato]] }, emission: gradient { "
                          "kind: cylindrical, exponent: 2 }, reflect: gradient { kind: box, stops: [[0, 0], [1, teal]] "
                          "}, specular: gradient { kind: spherical, repeat: false, stepped: true }"},
    {"onion", "color: onion { scale: 0.3, at: [0.5, 0.2, 0.1], wave: cubic, stops: [[0, peru], [0.7, khaki]] }, "
              "refract: onion { scale: 0.5, stops: [[0, 0], [1, 0.9]] }"},
    {"rings", "color: rings { scale: 0.2, at: [0.4, 0, 0.1], rotate: [80, 0, 0], wave: scallop, stops: [[0, sienna], "
              "[1, tan]] }"},
    {"spiral",
     "color: spiral { arms: 3, scale: 0.5, rotate: [70, 0, 0], stepped: true, stops: [[0, crimson], [0.5, ivory]] }"},
    {"leopard", "color: leopard { scale: 0.06, exponent: 0.5, stops: [[0.2, orange], [0.3, black], [0.8, peru]] }"},
    {"pattern_in_glass",
     "color: checker { a: white, b: skyblue, scale: 0.37 }, refract: 0.85, ior: 1.25, diffuse: 0.3"},
};

constexpr FeatureEntry lights[] = {
    {"light_point", "light { at: [2, 3, 2.5], color: #ffe0b0, intensity: 0.9 }"},
    {"light_sun", "sun { direction: [-1, -2, -0.7], color: #e0f0ff }"},
    {"light_spot", "spot { at: [1.5, 3.5, 2], look_at: [0, 0, 0], angle: 25, falloff: 45 }"},
    {"light_spot_sharp", "spot { at: [1.5, 3.5, 2], look_at: [0, 0, 0], angle: 33, intensity: 0.9 }"},
    {"light_no_shadows", "light { at: [2, 3, 2.5], shadows: false }"},
    {"light_fade_linear", "light { at: [2, 3, 2.5], fade: linear(2), intensity: 2 }"},
    {"light_fade_quadratic", "light { at: [2, 3, 2.5], fade: quadratic(2.5), intensity: 2 }"},
    {"light_fade_inverse", "light { at: [2, 3, 2.5], fade: inverse_square, intensity: 14 }"},
    {"light_in_group",
     "group { rotate: [0, 30, 10], at: [0.2, 0.3, 0], scale: [1, 1.2, 0.9], light { at: [2, 3, 2] }, spot { at: [-2, "
     "3, 1], look_at: [0, 0.2, 0], angle: 20, falloff: 35 }, sun { direction: [1, -2, -1], intensity: 0.3 } }"},
    {"lights_three", "light { at: [2, 3, 2.5], color: tomato }\nsun { direction: [1, -1, -0.5], intensity: 0.4 }\nspot "
                     "{ at: [-2, 3, 2], angle: 20, falloff: 40, color: skyblue }"},
    {"light_through_glass",
     "sun { direction: [-1, -2, -0.7] }\nbox { size: [0.9, 0.05, 0.9], at: [0.9, 1.5, 0.6], material: material { "
     "color: orchid, refract: 0.9, diffuse: 0.1 } }\nsphere { radius: 0.3, at: [0.2, 1.3, 0.6], casts_shadow: false }"},
};

constexpr FeatureEntry media[] = {
    {"media_bubble", "sphere { radius: 1.1, material: clear { ior: 1.5 } }\nsphere { radius: 0.6, at: [0.1, 0.1, 0.2], "
                     "material: clear { ior: 1 } }"},
    {"media_marble", "sphere { radius: 1.1, material: clear { ior: 1.25 } }\nsphere { radius: 0.5, at: [0.2, 0, 0.1], "
                     "material: tomato }"},
    {"media_overlap", "sphere { radius: 0.8, at: [-0.4, 0, 0], material: clear { ior: 1.5 } }\nsphere { radius: 0.8, "
                      "at: [0.5, 0.1, 0.2], material: clear { ior: 1.25, color: skyblue } }"},
    {"media_eye_inside", "sphere { at: [1.7, 1.9, 4.6], radius: 1.5, material: clear { ior: 1.25 } }\nbox { rotate: "
                         "[10, 30, 0], material: peru }"},
    {"media_eye_in_group", "group { at: [0.1, 0, 0], sphere { at: [1.6, 1.9, 4.6], radius: 1.5, material: clear { ior: "
                           "1.25 } }, box { rotate: [10, 30, 0], material: peru } }"},
    {"media_solid", "(sphere { radius: 1 } - sphere { radius: 0.7, at: [0.3, 0.3, 0.4] }) { material: clear { ior: "
                    "1.5, reflect: 1, fresnel: true } }"},
    {"media_pane", "quad { size: 2.2, normal: [0.3, 0.2, 1], material: clear { ior: 1.25, color: khaki } }\nsphere { "
                   "radius: 0.5, at: [-0.2, 0, -0.9], material: tomato }"},
    {"media_depth_0", "max_depth: 0\nsphere { radius: 1, material: clear { ior: 1.5 } }"},
    {"media_depth_2", "max_depth: 2\nsphere { radius: 1, material: clear { ior: 1.5, reflect: 0.3 } }\nplane { z: "
                      "-1.6, material: mirror }"},
    {"media_half_space", "plane { y: -0.2, material: clear { ior: 1.25, color: skyblue, reflect: 1, fresnel: true } "
                         "}\nsphere { radius: 0.6, at: [0, -0.5, 0], material: tomato }"},
    {"media_tube",
     "cylinder { from: [1.2, 1.5, 3.6], to: [3.4, 4, 9], radius: 1.6, open: true, material: clear { ior: 1.25, "
     "reflect: 1, fresnel: true } }\nsphere { radius: 0.9, material: clear { ior: 1.5, reflect: 1, fresnel: true } }"},
    {"media_room", "box { size: 13, material: khaki }\nsphere { radius: 0.9, material: clear { ior: 1.5, reflect: 1, "
                   "fresnel: true } }"},
};

constexpr FeatureEntry cameras[] = {
    {"camera_orthographic",
     "camera { at: [1.7, 1.9, 4.6], look_at: [0.1, 0.2, 0], projection: orthographic, width: 4.2 }"},
    {"camera_orthographic_disc",
     "camera { at: [1.7, 1.9, 4.6], look_at: [0.1, 0.2, 0], projection: orthographic, width: 4.2 }\ndisc { normal: "
     "[0.9, -0.3, 0.1], radius: 0.9, hole: 0.3, at: [1.7, 1.9, 2], material: tomato }\nsphere { radius: 0.5, at: [0, "
     "0.9, 0.8], material: clear { ior: 1.5, reflect: 1, fresnel: true } }"},
    {"camera_wide", "camera { at: [0.6, 1, 2.2], look_at: [0, 0, 0], fov: 110 }"},
    {"camera_tilted", "camera { at: [1.7, 1.9, 4.6], look_at: [0.1, 0.2, 0], up: [0.5, 1, 0.2], fov: 42 }"},
    {"camera_from_below", "camera { at: [1.2, -4, 3], look_at: [0, 0, 0], fov: 50 }"},
    {"samples", "samples: 9\ncamera { at: [1.7, 1.9, 4.6], look_at: [0.1, 0.2, 0], fov: 42 }"},
};

std::string base() {
  return std::string(stage) + "gold_paint = material { color: gold, specular: 0.5 }\n"
                              "clear = material { color: white, refract: 0.9, diffuse: 0.1, specular: 0.3 }\n";
}

std::string with_all(const std::string& text) {
  return base() + std::string(usual_camera) + std::string(usual_light) + std::string(usual_floor) + text + "\n";
}

} // namespace

std::vector<FeatureScene> feature_scenes() {
  std::vector<FeatureScene> all;
  for (const FeatureEntry& e : shapes) all.push_back({std::string("shape_") + e.name, with_all(e.text)});
  for (const FeatureEntry& e : transforms) all.push_back({std::string("transform_") + e.name, with_all(e.text)});
  for (const FeatureEntry& e : materials) {
    const std::string material = std::string("material { ") + e.text + " }";
    all.push_back(
        {std::string("material_") + e.name,
         with_all("sphere { radius: 0.8, at: [-0.5, 0, 0.2], material: " + material +
                  " }\nbox { size: 1, at: [0.9, -0.1, -0.4], rotate: [0, 30, 0], material: " + material + " }")});
  }
  const std::string things = "sphere { radius: 0.7, material: material { color: peru, specular: 0.5 } }\nbox { size: "
                             "0.7, at: [1.1, -0.4, 0.3], rotate: [0, 30, 0] }\n";
  for (const FeatureEntry& e : lights)
    all.push_back({e.name, base() + std::string(usual_camera) + std::string(usual_floor) + things + e.text + "\n"});
  for (const FeatureEntry& e : media) all.push_back({e.name, with_all(e.text)});
  for (const FeatureEntry& e : cameras)
    all.push_back({e.name, base() + std::string(usual_light) + std::string(usual_floor) + things + e.text + "\n"});
  return all;
}

} // namespace rt::tools::oracle
