#pragma once

#include "renderer/scene/scene.hpp"
#include "renderer/shading/lights.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers and lines as explanations write them.
namespace rt::tools::explain {

/// With as many digits as can be compared by eye: nine for a number, six for the components of vectors and colours.
std::string number_text(double v);
std::string vector_text(const Vec3& v);
/// Linear: one number for a grey, else "(r, g, b)".
std::string color_text(const Color& c);
/// For an angle with this cosine: "36.87°".
std::string angle_text(double cosine);
/// "62 %".
std::string percent_text(double share);
/// "a, b and c".
std::string list_text(std::span<const std::string> items);

/// Indented lines of at most 100 columns; longer ones continue below, indented by `hang` more.
class Page {
public:
  void line(int indent, std::string_view text, int hang = 4);
  void blank() { text_ += '\n'; }
  std::string take() { return std::move(text_); }

private:
  std::string text_;
};

} // namespace rt::tools::explain
