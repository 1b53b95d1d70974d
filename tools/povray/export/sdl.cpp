#include "tools/povray/export/sdl.hpp"

#include <fmt/format.h>

namespace rt::tools::povray {
namespace {

std::string about(const Vec3& fixed, const std::string& step) {
  if (step.empty() || fixed == Vec3{}) return step;
  return fmt::format(" translate {}{} translate {}", vector(-fixed), step, vector(fixed));
}

std::string scale(const Vec3& factors) {
  if (factors == Vec3{1, 1, 1}) return {};
  return " scale " + (factors.x == factors.y && factors.y == factors.z ? number(factors.x) : vector(factors));
}
std::string rotate(const Vec3& degrees) {
  return degrees == Vec3{} ? std::string{} : " rotate " + vector(degrees);
}
std::string translate(const Vec3& offset) {
  return offset == Vec3{} ? std::string{} : " translate " + vector(offset);
}

std::string transform_of(const scene::ScaleStep& step) {
  return about(step.about, scale(step.factors));
}
std::string transform_of(const scene::RotateStep& step) {
  return about(step.about, rotate(step.degrees));
}
std::string transform_of(const scene::MoveStep& step) {
  return translate(step.offset);
}
template <class Other>
std::string transform_of(const Other& step) {
  return fmt::format(" {}", matrix(povray::map_of(scene::Step(step))));
}

} // namespace

// Without the sign of a negative zero, which is meaningless in a scene.
std::string number(double value) {
  return fmt::format("{}", value == 0 ? 0.0 : value);
}

std::string vector(const Vec3& v) {
  return fmt::format("<{}, {}, {}>", number(v.x), number(v.y), number(v.z));
}

std::string rgb(const Color& color, double filter) {
  if (filter == 0) return "rgb " + vector({color.r, color.g, color.b});
  return fmt::format("rgbf <{}, {}, {}, {}>", number(color.r), number(color.g), number(color.b), number(filter));
}

std::string transform(const scene::Step& step) {
  return std::visit([](const auto& s) { return transform_of(s); }, step);
}

std::string transforms(const scene::Placement& placement) {
  std::string text = scale(placement.scale) + rotate(placement.rotate) + translate(placement.at);
  for (const scene::Step& step : placement.chain) text += transform(step);
  return text;
}

std::string matrix(const Map& map) {
  std::string text = "matrix <";
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      text += (row + column > 0 ? ", " : "") + number(map.row[row][column]);
  return text + ">";
}

void Writer::line(std::string_view text) {
  text_.append(2 * depth_, ' ');
  text_ += text;
  text_ += '\n';
}

void Writer::comment(std::string_view text) {
  std::string shown(text);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  line("// " + shown);
}

void Writer::open(std::string_view head) {
  line(std::string(head) + " {");
  ++depth_;
}

void Writer::close(std::string_view tail) {
  if (!tail.empty()) line(tail);
  --depth_;
  line("}");
}

} // namespace rt::tools::povray
