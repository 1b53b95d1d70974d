#pragma once

#include "renderer/scene/scene.hpp"
#include "renderer/shading/lights.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers, names and lines as an explanation writes them.
namespace rt::tools::explain {

/// With as many digits as one can compare by eye: nine for a number, six for the parts of vectors and colours.
std::string number_text(double v);
std::string vector_text(const Vec3& v);
/// Linear: one number for a grey, else "(r, g, b)".
std::string color_text(const Color& c);
/// Of an angle with this cosine: "36.87°".
std::string angle_text(double cosine);
/// "62 %".
std::string percent_text(double share);
/// "a, b and c".
std::string list_text(std::span<const std::string> items);

/// Names with the shortest place that tells where they are written: "`ball` (line 7)", with the file where it is not
/// the scene's own.
class Namer {
public:
  /// `file` is what the scene's own file is called in `scene.files`.
  Namer(const scene::Scene& scene, std::string_view file) : scene_(scene), file_(file) {}

  /// The whole of what was hit, outermost first: "`table` (line 12), its box (line 4)".
  std::string whole(std::span<const std::uint32_t> path) const;
  /// The name that answers for it: of the outermost object that has one, else of the shape.
  std::string title(std::span<const std::uint32_t> path) const;
  /// The same for objects that stand within each other.
  std::string whole(std::span<const scene::Object* const> objects) const;
  std::string object(const scene::Object& object) const;
  std::string light(std::uint32_t index) const;

private:
  std::string with_place(std::string name, scene::Origin origin) const;

  const scene::Scene& scene_;
  std::string_view file_;
};

/// Indented lines of at most 100 columns; what is longer goes on below, indented by `hang` more.
class Page {
public:
  void line(int indent, std::string_view text, int hang = 4);
  void blank() { text_ += '\n'; }
  std::string take() { return std::move(text_); }

private:
  std::string text_;
};

} // namespace rt::tools::explain
