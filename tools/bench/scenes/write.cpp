#include "renderer/math/affine.hpp"
#include "tools/bench/scenes/layout.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace rt::tools::bench {
namespace {

template <class... T>
void put(std::string& out, fmt::format_string<T...> format, T&&... values) {
  fmt::format_to(std::back_inserter(out), format, std::forward<T>(values)...);
}

// Six digits, so that programs that read single precision get the same number.
std::string xyz(const Vec3& p, std::string_view separator) {
  return fmt::format("{:.6g}{}{:.6g}{}{:.6g}", p.x, separator, p.y, separator, p.z);
}
std::string rgb(const Color& c, std::string_view separator) {
  return xyz({c.r, c.g, c.b}, separator);
}

// Our own language.

std::string list(const Vec3& p) {
  return fmt::format("[{}]", xyz(p, ", "));
}
std::string linear(const Color& c) {
  return fmt::format("linear_rgb({})", rgb(c, ", "));
}

void rtl_header(std::string& out, const Layout& layout) {
  put(out, "size: [{0}, {0}]\nmax_depth: {1}\nambient: 1\nbackground: {2}\n\n", picture_size, mirror_depth,
      linear(layout.background));
  put(out, "camera {{ at: {}, look_at: {}, fov: {} }}\n", list(layout.eye), list(layout.target), layout.fov);
  for (const BenchLight& light : layout.lights)
    put(out, "light {{ at: {}, color: {} }}\n", list(light.at), linear(light.color));
  out += "\n";
  for (std::size_t i = 0; i < layout.finishes.size(); ++i) {
    const Finish& f = layout.finishes[i];
    put(out, "m{} = material {{ color: {}, ambient: {}, diffuse: {}, specular: {}, shininess: {}, reflect: {}", i,
        linear(f.color), f.ambient, f.diffuse, f.specular, f.shininess, f.reflect);
    if (f.refract > 0) put(out, ", refract: {}, ior: {}", f.refract, f.ior);
    out += " }\n";
  }
  out += "\n";
}

std::string rtl(const Layout& layout) {
  std::string out;
  rtl_header(out, layout);
  for (const FloorShape& s : layout.floors) put(out, "plane {{ y: {:.6g}, material: m{} }}\n", s.height, s.finish);
  for (const BallShape& s : layout.balls)
    put(out, "sphere {{ at: {}, radius: {:.6g}, material: m{} }}\n", list(s.center), s.radius, s.finish);
  for (const TubeShape& s : layout.tubes)
    put(out, "cylinder {{ from: {}, to: {}, radius: {:.6g}, open: true, material: m{} }}\n", list(s.from), list(s.to),
        s.radius, s.finish);
  for (const TriangleShape& s : layout.triangles)
    put(out, "triangle {{ points: [{}, {}, {}], material: m{} }}\n", list(s.points[0]), list(s.points[1]),
        list(s.points[2]), s.finish);
  return out;
}

// POV-Ray's scene description language. Its camera looks along `direction` with any given `right`, so a right-handed
// one needs no mirroring. Its trace level counts the camera's ray as one.

std::string angle(const Vec3& p) {
  return fmt::format("<{}>", xyz(p, ","));
}
std::string angle(const Color& c) {
  return fmt::format("<{}>", rgb(c, ","));
}

std::string povray(const Layout& layout) {
  std::string out = fmt::format(
      "#version 3.7;\nglobal_settings {{ assumed_gamma 1.0 max_trace_level {} adc_bailout 0 }}\n", mirror_depth + 1);
  put(out, "background {{ rgb {} }}\n", angle(layout.background));
  const Vec3 forward = normalize(layout.target - layout.eye), right = normalize(cross(forward, {0, 1, 0}));
  const double width = 2 * std::tan(layout.fov * std::acos(-1.0) / 360);
  const auto exact = [](const Vec3& p) { return fmt::format("<{:.17g},{:.17g},{:.17g}>", p.x, p.y, p.z); };
  put(out, "camera {{ perspective location {} direction {} right {} up {} }}\n", angle(layout.eye), exact(forward),
      exact(right * width), exact(cross(right, forward) * width));
  for (const BenchLight& light : layout.lights)
    put(out, "light_source {{ {} rgb {} }}\n", angle(light.at), angle(light.color));
  for (std::size_t i = 0; i < layout.finishes.size(); ++i) {
    const Finish& f = layout.finishes[i];
    put(out, "#declare m{} = texture {{ pigment {{ rgb {} filter {} }} finish {{ ambient {} diffuse {}", i,
        angle(f.color), f.refract, f.ambient, f.diffuse);
    if (f.specular > 0) put(out, " specular {} roughness {:.9g}", f.specular, 1 / f.shininess);
    if (f.reflect > 0) put(out, " reflection {}", f.reflect);
    out += " } }\n";
    put(out, "#declare i{} = interior {{ ior {} }}\n", i, f.ior);
  }
  const auto material = [&](std::uint32_t i) {
    return layout.finishes[i].refract > 0 ? fmt::format("texture {{ m{0} }} interior {{ i{0} }}", i)
                                          : fmt::format("texture {{ m{} }}", i);
  };
  for (const FloorShape& s : layout.floors) put(out, "plane {{ <0,1,0>, {:.6g} {} }}\n", s.height, material(s.finish));
  for (const BallShape& s : layout.balls)
    put(out, "sphere {{ {}, {:.6g} {} }}\n", angle(s.center), s.radius, material(s.finish));
  for (const TubeShape& s : layout.tubes)
    put(out, "cylinder {{ {}, {}, {:.6g} open {} }}\n", angle(s.from), angle(s.to), s.radius, material(s.finish));
  for (const TriangleShape& s : layout.triangles)
    put(out, "triangle {{ {}, {}, {} {} }}\n", angle(s.points[0]), angle(s.points[1]), angle(s.points[2]),
        material(s.finish));
  return out;
}

// Tachyon's text format. Its camera is left-handed: everything is mirrored in x. A transparent surface keeps all of its
// own light, so that is scaled here; rays are not bent. It samples a pixel at its upper right corner, so the view is
// shifted by half a pixel. RAYDEPTH counts the camera's ray.

std::string mirrored(const Vec3& p) {
  return xyz({-p.x, p.y, p.z}, " ");
}

std::string tachyon(const Layout& layout) {
  std::string out = fmt::format("BEGIN_SCENE\nRESOLUTION {0} {0}\n", picture_size);
  const double half = std::tan(layout.fov * std::acos(-1.0) / 360), shift = half / picture_size;
  put(out, "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH {}\nCENTER {}\nVIEWDIR {}\nUPDIR 0 1 0\n",
      mirror_depth + 1, mirrored(layout.eye), mirrored(normalize(layout.target - layout.eye)));
  put(out, "FRUSTUM {:.9g} {:.9g} {:.9g} {:.9g}\nEND_CAMERA\n", -half - shift, half - shift, -half - shift,
      half - shift);
  put(out, "BACKGROUND {}\n", rgb(layout.background, " "));
  for (const BenchLight& light : layout.lights)
    put(out, "LIGHT CENTER {} RAD 0.001 COLOR {}\n", mirrored(light.at), rgb(light.color, " "));
  for (std::size_t i = 0; i < layout.finishes.size(); ++i) {
    const Finish& f = layout.finishes[i];
    put(out, "TEXDEF m{} AMBIENT {} DIFFUSE {} SPECULAR {} OPACITY {} ", i, f.ambient * (1 - f.refract),
        f.diffuse * (1 - f.refract), f.reflect, 1 - f.refract);
    if (f.specular > 0) put(out, "PHONG PLASTIC {} PHONG_SIZE {} ", f.specular, f.shininess);
    put(out, "COLOR {} TEXFUNC 0\n", rgb(f.color, " "));
  }
  for (const FloorShape& s : layout.floors) put(out, "PLANE CENTER 0 {:.6g} 0 NORMAL 0 1 0 m{}\n", s.height, s.finish);
  for (const BallShape& s : layout.balls)
    put(out, "SPHERE CENTER {} RAD {:.6g} m{}\n", mirrored(s.center), s.radius, s.finish);
  for (const TubeShape& s : layout.tubes)
    put(out, "FCYLINDER BASE {} APEX {} RAD {:.6g} m{}\n", mirrored(s.from), mirrored(s.to), s.radius, s.finish);
  for (const TriangleShape& s : layout.triangles)
    put(out, "TRI V0 {} V1 {} V2 {} m{}\n", mirrored(s.points[0]), mirrored(s.points[1]), mirrored(s.points[2]),
        s.finish);
  return out + "END_SCENE\n";
}

} // namespace

std::string write(const Layout& layout, Format format) {
  switch (format) {
  case Format::rtl:
    return rtl(layout);
  case Format::povray:
    return povray(layout);
  case Format::tachyon:
    return tachyon(layout);
  }
  return {};
}

} // namespace rt::tools::bench
