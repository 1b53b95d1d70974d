#pragma once

#include "renderer/math/color.hpp"
#include "renderer/scene/transform.hpp"
#include "tools/povray/export/map.hpp"

#include <string>
#include <string_view>

/// Text in POV-Ray's scene description language.
namespace rt::tools::povray {

/// The shortest decimal that reads back as the same double: at most 17 digits.
std::string number(double value);
/// `<x, y, z>`
std::string vector(const Vec3& v);
/// `rgb <r, g, b>`, or `rgbf <r, g, b, filter>` if `filter` is not 0.
std::string rgb(const Color& color, double filter = 0);

/// A transform of POV-Ray's own, with a leading blank: ` scale <2, 1, 1>`; nothing for the identity. `rotate`, `scale`
/// and `translate` use POV-Ray's arithmetic; the steps it has no keyword for become a `matrix`.
std::string transform(const scene::Step& step);
/// All steps of a placement in order, each with a leading blank.
std::string transforms(const scene::Placement& placement);
std::string matrix(const Map& map);

/// Collects lines, indented by the open blocks.
class Writer {
public:
  void line(std::string_view text);
  /// Writes `head {` and indents what follows.
  void open(std::string_view head);
  /// Ends the innermost block; `tail` precedes its brace, on a line of its own.
  void close(std::string_view tail = {});
  /// To the end of the line: control characters become blanks.
  void comment(std::string_view text);
  void blank() { text_ += '\n'; }
  std::string take() { return std::move(text_); }

private:
  std::string text_;
  std::size_t depth_ = 0;
};

} // namespace rt::tools::povray
