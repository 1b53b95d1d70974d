#include "tools/povray/export/export_parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

// POV-Ray's fade is 2 / (1 + (D / fade_distance)^fade_power): the colour is halved to compensate. 1 / D² is the limit
// of (1/e²) / (1 + (D/e)²) for small e, with a relative error of (e/D)²: 1e-12 at distance 1.
std::string fade(const Fade& fade, Color& color) {
  constexpr double e = 1e-6;
  switch (fade.law) {
  case Fade::Law::none:
    return {};
  case Fade::Law::linear:
    color = color * 0.5;
    return fmt::format(" fade_distance {} fade_power 1", number(fade.distance));
  case Fade::Law::quadratic:
    color = color * 0.5;
    return fmt::format(" fade_distance {} fade_power 2", number(fade.distance));
  case Fade::Law::inverse_square:
    color = color * (0.5 / (e * e));
    return fmt::format(" fade_distance {} fade_power 2", number(e));
  }
  return {};
}

std::string all_transforms(const Light& light) {
  std::string text;
  for (const Step& step : light.chain) text += transform(step);
  for (const Placement& placement : light.enclosing) text += transforms(placement);
  return text;
}

std::string body(const PointLight& source, const Light& light, const Camera&) {
  Color color = source.color * source.intensity;
  const std::string fading = fade(source.fade, color);
  return fmt::format("{}, {}{}{}{}", vector(source.at), rgb(color), fading, source.shadows ? "" : " shadowless",
                     all_transforms(light));
}

std::string body(const SpotLight& source, const Light& light, const Camera&) {
  Color color = source.color * source.intensity;
  const std::string fading = fade(source.fade, color);
  return fmt::format("{}, {} spotlight point_at {} radius {} falloff {} tightness 0{}{}{}", vector(source.at),
                     rgb(color), vector(source.look_at), number(source.angle / 2),
                     number(source.falloff.value_or(source.angle) / 2), fading, source.shadows ? "" : " shadowless",
                     all_transforms(light));
}

// POV-Ray's parallel lights are on a plane, and what is beyond that plane casts no shadow: it is placed farther away
// than anything POV-Ray sees.
std::string body(const SunLight& source, const Light& light, const Camera& camera) {
  Vec3 way = source.direction;
  for (const Step& step : light.chain) way = map_of(step).vector(way);
  for (const Placement& placement : light.enclosing) way = map_of(placement).vector(way);
  const double distance = std::max(10 * farthest_hit, 100 * std::hypot(camera.at.x, camera.at.y, camera.at.z));
  return fmt::format("{}, {} parallel point_at 0{}", vector(unit(way) * -distance),
                     rgb(source.color * source.intensity), source.shadows ? "" : " shadowless");
}

// A gradient repeats from 0 to 1 along its axis: stretched, it extends from the nadir to the zenith.
std::string body(const SkyLight& source, const Light& light, const Camera&) {
  Vec3 up{0, 1, 0};
  for (const Step& step : light.chain) up = map_of(step).vector(up);
  for (const Placement& placement : light.enclosing) up = map_of(placement).vector(up);
  up = unit(up);
  const std::string below = rgb(source.ground.value_or(source.horizon * 0.3) * source.intensity);
  return fmt::format(
      "pigment {{ gradient {0} color_map {{ [0 {1}] [0.5 {1}] [0.5 {2}] [1 {3}] }} scale 2 translate {4} }}",
      vector(up), below, rgb(source.horizon * source.intensity), rgb(source.zenith * source.intensity), vector(-up));
}

} // namespace

void write_light(Writer& out, const Light& light, const Camera& camera) {
  out.line(fmt::format("{} {{ {} }}", is_lamp(light) ? "light_source" : "sky_sphere",
                       std::visit([&](const auto& source) { return body(source, light, camera); }, light.source)));
}

namespace {

struct ViewVectors {
  Vec3 direction, right, up; // right and up as long as the picture is wide and high
};

ViewVectors view_of(const Camera& camera, Resolution size) {
  const Vec3 forward = unit(camera.look_at - camera.at);
  const Vec3 right = unit(cross(forward, camera.up));
  const bool is_orthographic = camera.projection == Projection::orthographic;
  const double width = is_orthographic ? camera.width : 2 * std::tan(camera.fov * (std::numbers::pi / 360));
  const double height = width * size[1] / size[0];
  return {forward, right * width, cross(right, forward) * height};
}

} // namespace

std::vector<Vec3> ray_origins(const Camera& camera, Resolution size) {
  std::vector<Vec3> origins{camera.at};
  if (camera.projection == Projection::perspective) return origins;
  const ViewVectors view = view_of(camera, size);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) origins.push_back(camera.at + view.right * x + view.up * y);
  return origins;
}

// The four vectors that define POV-Ray's rays: direction + x·right + y·up with x and y from −½ to ½, or, in an
// orthographic view, location + x·right + y·up. This way neither its handedness nor its field of view matters.
void write_camera(Writer& out, const Camera& camera, Resolution size) {
  const ViewVectors view = view_of(camera, size);
  out.open("camera");
  out.line(camera.projection == Projection::orthographic ? "orthographic" : "perspective");
  out.line("location " + vector(camera.at));
  out.line("direction " + vector(view.direction));
  out.line("right " + vector(view.right));
  out.line("up " + vector(view.up));
  out.close();
}

// A distance d is (1 + u)/2 · 2^e with 0 ≤ u < 1. The 16-bit channels hold u's first 16 bits, its next 16, and e + 32
// in 7 bits with the last 9 bits of u. A pattern's value must not leave [0, 1]; `average` divides by three, which the
// colour maps undo.
void write_depth_functions(Writer& out, const Camera& camera) {
  if (camera.projection == Projection::orthographic) {
    const Vec3 f = unit(camera.look_at - camera.at);
    out.line(fmt::format("#declare distance_to = function {{ (x - ({}))*({}) + (y - ({}))*({}) + (z - ({}))*({}) }}",
                         number(camera.at.x), number(f.x), number(camera.at.y), number(f.y), number(camera.at.z),
                         number(f.z)));
  } else {
    out.line(fmt::format("#declare distance_to = function {{ sqrt((x - ({0}))*(x - ({0})) + (y - ({1}))*(y - ({1})) + "
                         "(z - ({2}))*(z - ({2}))) }}",
                         number(camera.at.x), number(camera.at.y), number(camera.at.z)));
  }
  for (const char* line : {
           "#declare distance_exponent = function { ceil(ln(max(distance_to(x, y, z), 1e-9))/ln(2)) }",
           "#declare distance_mantissa = function { min(max(2*distance_to(x, y, z)/pow(2, distance_exponent(x, y, z)) "
           "- 1, 0), 1 - 1e-15) }",
           "#declare distance_high = function { floor(distance_mantissa(x, y, z)*65536) }",
           "#declare distance_middle = function { floor((distance_mantissa(x, y, z)*65536 - distance_high(x, y, "
           "z))*65536) }",
           "#declare distance_low = function { floor(((distance_mantissa(x, y, z)*65536 - distance_high(x, y, "
           "z))*65536 - distance_middle(x, y, z))*512) }",
       })
    out.line(line);
  out.open("#declare distance_texture = texture");
  out.open("pigment");
  out.line("average");
  out.open("pigment_map");
  out.line("[1 function { distance_high(x, y, z)/65535 } color_map { [0 rgb 0] [1 rgb <3, 0, 0>] }]");
  out.line("[1 function { distance_middle(x, y, z)/65535 } color_map { [0 rgb 0] [1 rgb <0, 3, 0>] }]");
  out.line("[1 function { ((distance_exponent(x, y, z) + 32)*512 + distance_low(x, y, z))/65535 } color_map { [0 rgb "
           "0] [1 rgb <0, 0, 3>] }]");
  out.close();
  out.close();
  out.line("finish { ambient 0 diffuse 0 emission 1 }");
  out.close();
}

double decode_depth(Packed pixel) {
  if (pixel.r == 0 && pixel.g == 0 && pixel.b == 0) return std::numeric_limits<double>::infinity();
  const int exponent = pixel.b / 512 - 32;
  const double u = (pixel.r + (pixel.g + (pixel.b % 512 + 0.5) / 512) / 65536) / 65536;
  return std::ldexp(0.5 + u / 2, exponent);
}

Packed encode_depth(double distance) {
  if (std::isinf(distance)) return {};
  int exponent = 0;
  double rest = (2 * std::frexp(distance, &exponent) - 1) * 65536;
  const auto next = [&](double steps) {
    const double whole = std::floor(rest);
    rest = (rest - whole) * steps;
    return static_cast<int>(whole);
  };
  const int high = next(65536), middle = next(512), low = next(1);
  return {static_cast<std::uint16_t>(high), static_cast<std::uint16_t>(middle),
          static_cast<std::uint16_t>((exponent + 32) * 512 + low)};
}

std::string id_texture(std::uint32_t id) {
  return fmt::format("texture {{ pigment {{ rgb <{}, {}, {}>/255 }} finish {{ ambient 0 diffuse 0 emission 1 }} }}",
                     id % 256, id / 256 % 256, id / 65536);
}

Packed encode_id(std::uint32_t id) {
  const auto byte = [&](int shift) { return static_cast<std::uint16_t>((id >> shift) % 256 * 257); };
  return {byte(0), byte(8), byte(16)};
}

std::uint32_t decode_id(Packed pixel) {
  const auto byte = [](std::uint16_t v) { return (static_cast<std::uint32_t>(v) + 128) / 257; };
  return byte(pixel.r) + 256 * byte(pixel.g) + 65536 * byte(pixel.b);
}

void write_normal_lights(Writer& out) {
  for (const char* axis : {"x", "y", "z"}) {
    out.line(fmt::format("light_source {{ {0}*1e8, rgb {0} parallel point_at 0 shadowless }}", axis));
    out.line(fmt::format("light_source {{ -{0}*1e8, rgb -{0} parallel point_at 0 shadowless }}", axis));
  }
}

} // namespace rt::tools::povray
