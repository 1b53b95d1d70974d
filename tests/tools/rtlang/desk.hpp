#pragma once

#include "renderer/image/image.hpp"
#include "tests/support/program.hpp"

#include <string>
#include <vector>

/// The real program, end to end: what it prints, what it writes, and what it ends with.
namespace rt::tests {

/// Small, and written in full, so that nothing is assumed.
inline constexpr const char* small_scene = R"(
param radius = 1
size: [40, 30]
background: #9cc4e8
camera { at: [0, 1, 5], look_at: [0, 0, 0] }
sun { direction: [-1, -2, -1] }
sphere { radius: radius, material: material { color: tomato, reflect: 0.3 } }
plane { y: -1, material: checker { a: white, b: #333 } }
)";

/// A folder with a scene in it, in which rtlang runs.
struct Desk {
  TestFolder folder;
  RunOptions options;
  explicit Desk(const std::string& scene = small_scene) {
    folder.write("scene.rtl", scene);
    options.folder = folder.path();
  }
  Outcome run(const std::vector<std::string>& arguments) const { return rtlang(arguments, options); }
  Image image(const std::string& name) const { return read_image(folder / name); }
};

} // namespace rt::tests
