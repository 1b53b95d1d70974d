#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The scenes that are measured, as plain numbers, and the formats that they are written in. They only contain what
/// rtlang, POV-Ray and Tachyon can all express.
namespace rt::tools::bench {

/// How a surface reflects light: ambient and diffuse with its own colour, a Blinn highlight, a mirror and (white
/// surfaces only) transmission.
struct Finish {
  Color color;
  double ambient = 0.1, diffuse = 0.7, specular = 0.3, shininess = 60, reflect = 0, refract = 0, ior = 1;
};

struct BallShape {
  Vec3 center;
  double radius;
  std::uint32_t finish;
};

/// Without caps.
struct TubeShape {
  Vec3 from, to;
  double radius;
  std::uint32_t finish;
};

struct TriangleShape {
  std::array<Vec3, 3> points;
  std::uint32_t finish;
};

/// An infinite horizontal plane.
struct FloorShape {
  double height;
  std::uint32_t finish;
};

struct BenchLight {
  Vec3 at;
  Color color;
};

struct Layout {
  std::string name;
  Vec3 eye, target;
  double fov = 45; ///< degrees, in both directions: pictures are square
  Color background = black;
  std::vector<BenchLight> lights;
  std::vector<Finish> finishes;
  std::vector<BallShape> balls;
  std::vector<TubeShape> tubes;
  std::vector<TriangleShape> triangles;
  std::vector<FloorShape> floors;

  std::size_t primitive_count() const { return balls.size() + tubes.size() + triangles.size() + floors.size(); }
};

inline constexpr int picture_size = 1024;
inline constexpr int mirror_depth = 5; ///< reflected rays after the camera's

/// In the order of the tables. The arrangement of the first ones follows Haines's Standard Procedural Databases (A
/// Proposal for Standard Graphics Environments, IEEE Computer Graphics and Applications 7(11), 1987).
inline constexpr std::array<std::string_view, 7> layout_names = {"sphereflake_4", "sphereflake_6", "rings",  "mixed",
                                                                 "random_10k",    "random_1m",     "whitted"};

/// Throws std::invalid_argument for an unknown name.
Layout make_layout(std::string_view name);

enum class Format { rtl, povray, tachyon };

/// The scene as text; all formats contain the same decimal numbers.
std::string write(const Layout& layout, Format format);

} // namespace rt::tools::bench
