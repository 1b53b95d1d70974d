#include "tools/oracle/generate.hpp"

#include "tools/oracle/generate_functions.hpp"
#include "tools/oracle/generate_patterns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rt::tools::oracle {
namespace {

Block block(std::string head) {
  return {std::move(head), {}, {}, {}, {}, false};
}

std::string rgb(Dice& dice, const char* function) {
  const double blue = dice.unit(), green = dice.unit(), red = dice.unit();
  return fmt::format("{}({}, {}, {})", function, text(red), text(green), text(blue));
}

std::string hsv(Dice& dice) {
  const double value = dice.between(0.4, 1), saturation = dice.unit(), hue = dice.between(0, 360);
  return fmt::format("hsv({}, {}, {})", text(hue), text(saturation), text(value));
}

std::string color(Dice& dice) {
  switch (dice.below(5)) {
  case 0:
    return fmt::format("#{:06x}", dice.below(0x1000000));
  case 1:
    return hsv(dice);
  case 2:
    return rgb(dice, "rgb");
  case 3:
    return text(dice.between(0.2, 1)); // a number is grey
  default: {
    constexpr const char* names[] = {"peru", "teal", "darkorange", "orchid", "white", "tomato", "khaki", "skyblue"};
    return names[dice.below(8)];
  }
  }
}

// A function that stands for its pattern, or is placed as one.
void set_function(Dice& dice, Block& owner, const char* name, std::string function) {
  if (dice.chance(0.6)) {
    owner.set(name, std::move(function));
    return;
  }
  Block pattern = block("pattern");
  pattern.set("of", std::move(function));
  const double unit = std::exchange(dice.length_unit, 1); // the function itself is in the scene's
  place_pattern(dice, pattern);
  dice.length_unit = unit;
  owner.set(name, std::move(pattern));
}

// POV-Ray keeps an index of refraction in 32 bits: multiples of 1/64 are exact there, and others show that the check
// knows why they differ.
std::string ior(Dice& dice) {
  return dice.chance(0.9) ? text((64 + dice.below(90)) / 64.0) : text(dice.between(1, 2.4));
}

// A value or a pattern of them: of few properties, since POV-Ray is given the product of a material's patterns.
void set_value(Dice& dice, Block& material, const char* name, const std::function<std::string(Dice&)>& value) {
  if (dice.chance(0.06))
    material.set(name, random_pattern(dice, value,
                                      name != std::string_view("shininess") && name != std::string_view("roughness")));
  else
    material.set(name, value(dice));
}

void set_number(Dice& dice, Block& material, const char* name, double low, double high) {
  if (dice.chance(0.1)) return set_function(dice, material, name, random_number_function(dice, low, high));
  set_value(dice, material, name, [&](Dice& d) { return text(d.between(low, high)); });
}

// With numbers of its own, so that the scenes of the long runs keep theirs.
void make_physical(Dice dice, Block& m) {
  constexpr const char* metals[] = {"gold", "iron", "{ n: 1.2, k: linear_rgb(1, 2, 3) }"};
  Dice own(dice.bits());
  if (own.chance(0.06)) m.set("metal", metals[own.below(3)]);
  if (own.chance(0.1)) set_value(own, m, "roughness", [](Dice& d) { return text(d.between(0.2, 1)); });
  // Heights that are level, and a coat that is none: POV-Ray has no others.
  if (own.chance(0.03))
    m.set("bump", random_pattern(
                      own, [](Dice&) { return "0.5"; }, true));
  if (own.chance(0.03)) {
    m.set("coat", random_pattern(
                      own, [](Dice&) { return "0"; }, true));
    m.set("coat_roughness", text(own.unit())).set("coat_ior", text(own.between(1.1, 2)));
  }
}

Block opaque(Dice& dice) {
  Block m = block("material");
  if (dice.chance(0.25))
    m.set("color", random_pattern(dice, color, true));
  else if (dice.chance(0.25))
    set_function(dice, m, "color", random_color_function(dice));
  else
    m.set("color", color(dice));
  if (dice.chance(0.25)) set_number(dice, m, "ambient", 0, 1.5);
  if (dice.chance(0.4)) set_number(dice, m, "diffuse", 0.2, 1);
  if (dice.chance(0.15)) set_number(dice, m, "emission", 0.1, 0.6);
  if (dice.chance(0.5)) {
    set_number(dice, m, "specular", 0.1, 1);
    if (dice.chance(0.8)) set_value(dice, m, "shininess", [](Dice& d) { return text(std::exp(d.between(0, 5.5))); });
    if (dice.chance(0.4)) m.set("highlight", dice.chance(0.85) ? "phong" : "blinn");
  }
  if (dice.chance(0.3)) set_value(dice, m, "metallic", [](Dice& d) { return text(d.chance(0.3) ? 1 : d.unit()); });
  if (dice.chance(0.3))
    set_value(dice, m, "reflect", [](Dice& d) { return d.chance(0.7) ? text(d.between(0.05, 0.6)) : color(d); });
  make_physical(dice, m);
  return m;
}

void make_clear(Dice& dice, Block& m, const std::string& index) {
  set_value(dice, m, "refract", [](Dice& d) { return text(d.chance(0.2) ? 1 : d.between(0.4, 0.98)); });
  if (!index.empty()) m.set("ior", index);
  if (dice.chance(0.45)) m.set("fresnel", "true");
}

// At a place that fits into the picture, where the eye sees something of it.
Block floor(Dice& dice) {
  Block b = block("plane");
  if (dice.chance(0.6))
    b.set("y", text(dice.length(-1.6, -1.1)));
  else
    b.set("normal", text(Vec3{dice.between(-0.3, 0.3), 1, dice.between(-0.2, 0.3)}))
        .set("offset", text(dice.length(-2.2, -1.6)));
  Block m = opaque(dice);
  // Cells far away hang on the last digits of a ray that was mirrored before.
  std::erase_if(m.props, [](const Prop& p) { return !p.block.empty() || p.text.starts_with("fn"); });
  // What is opaque has no inside, be it thin or not.
  Dice own(Dice(dice).bits());
  if (own.chance(0.2)) m.set("thin", "true");
  if (own.chance(0.2))
    m.set("absorb", fmt::format("{{ color: {}, distance: {} }}", color(own), text(own.between(1, 9))));
  return b.set("material", std::move(m));
}

// A tray: what a patterned floor would show, but finite.
Block tray(Dice& dice) {
  Block b = dice.chance(0.5)
                ? block("disc").set("radius", text(dice.length(3, 5)))
                : block("box").set("size", text(Vec3{dice.between(5, 9), 0.2, dice.between(5, 9)} * dice.length_unit));
  return b.set("at", text(Vec3{0, dice.length(-1.6, -1.2), 0})).set("material", opaque(dice));
}

// A shape under a name, placed several times: the description holds it once.
void add_copies(Dice& dice, Block& file) {
  Block shape = block("group");
  for (int i = 0; i < 2; ++i) {
    Block member = random_shape(dice, 1, false);
    place(dice, member, 0.4);
    if (dice.chance(0.5)) add_material(dice, member, false);
    shape.things.push_back(std::move(member));
  }
  shape.head = "unit_" + std::to_string(file.things.size()) + " = group";
  shape.is_definition = true;
  const std::string name = shape.head.substr(0, shape.head.find(' '));
  file.things.push_back(std::move(shape));
  const int copies = 2 + dice.below(2);
  for (int i = 0; i < copies; ++i) {
    Block copy = block(name);
    place(dice, copy, 2);
    if (dice.chance(0.6)) add_material(dice, copy, false);
    file.things.push_back(std::move(copy));
  }
}

// Balls in a row by a loop, each from a definition with a parameter.
void add_row(Dice& dice, Block& file) {
  Block definition = block(fmt::format("def bead(r = {})", text(0.3 * dice.length_unit)));
  definition.is_definition = true;
  definition.things.push_back(block("sphere").set("radius", "r"));
  definition.things.push_back(block("disc").set("radius", "1.6 * r").set("normal", text(dice.direction())));
  Block loop = block(fmt::format("for i in 0..<{}", 2 + dice.below(3)));
  loop.is_definition = true;
  Block bead =
      block("bead").set("r", fmt::format("{} + {} * i", text(dice.length(0.15, 0.3)), text(0.05 * dice.length_unit)));
  const Vec3 way = dice.point(0.4, 1), first = dice.point(-2, 0);
  bead.set("at", fmt::format("{} + i * {}", text(first), text(way)));
  add_material(dice, bead, false);
  loop.things.push_back(std::move(bead));
  file.things.push_back(std::move(definition));
  file.things.push_back(std::move(loop));
}

void add_settings(Dice& dice, Block& file) {
  if (dice.chance(0.8)) file.set("background", color(dice));
  if (dice.chance(0.7)) file.set("ambient", dice.chance(0.5) ? text(dice.between(0, 0.4)) : color(dice));
  if (dice.chance(0.6)) file.set("max_depth", std::to_string(dice.below(9)));
  if (dice.chance(0.08)) file.set("samples", dice.chance(0.5) ? "4" : "9");
  // What changes nothing in this mode, in a linear picture, or where every ray is followed.
  if (dice.chance(0.1)) file.set("mode", "whitted");
  if (dice.chance(0.1)) file.set("noise", "0.01").set("seed", "7").set("filter", "gaussian").set("reach", "2");
  if (dice.chance(0.1)) file.set("exposure", text(dice.between(-2, 2))).set("tone", "filmic").set("min_weight", "0.1");
}

Block random_sky(Dice& dice) {
  Block sky = block("sky").set("zenith", color(dice)).set("horizon", color(dice));
  if (dice.chance(0.5)) sky.set("ground", color(dice));
  if (dice.chance(0.5)) sky.set("intensity", text(dice.between(0.3, 1)));
  return sky;
}

void add_flags(Dice& dice, Block& thing) {
  if (dice.chance(0.08)) thing.set("casts_shadow", "false");
  if (dice.chance(0.05)) thing.set("visible", "false");
  if (dice.chance(0.1)) thing.set("name", "\"ball\"");
}

// A bubble, a marble or another glass, inside or half inside of a clear ball.
Block nested(Dice& dice) {
  Block b = block("group");
  const double outer = dice.between(0.7, 1.1);
  Block shell = block("sphere").set("radius", text(outer * dice.length_unit)), core = random_shape(dice, 1, true);
  Block glass = opaque(dice);
  make_clear(dice, glass, ior(dice));
  shell.set("material", std::move(glass));
  place(dice, core, dice.chance(0.5) ? 0.15 : 0.8);
  core.set("scale", text(dice.between(0.3, 0.7)));
  std::erase_if(core.props, [seen = false](const Prop& p) mutable {
    const bool is_second = p.name == "scale" && std::exchange(seen, true);
    return is_second;
  });
  add_material(dice, core, false);
  b.things.push_back(std::move(shell));
  b.things.push_back(std::move(core));
  b.set("at", text(dice.point(-1.5, 1.5)));
  return b;
}

} // namespace

void add_material(Dice& dice, Block& thing, bool is_in_solid) {
  const double kind = dice.unit();
  if (kind < 0.08) {
    thing.set("material", rgb(dice, "linear_rgb"));
  } else if (kind < 0.16) {
    thing.set("material", random_pattern(dice, color, true));
  } else if (kind < 0.24 && !is_in_solid) {
    constexpr const char* names[] = {"glass",  "water",  "diamond", "mirror", "gold",
                                     "silver", "copper", "chrome",  "rubber", "matte"};
    Block m = block(names[dice.below(10)]);
    if (dice.chance(0.5)) m.set("color", color(dice));
    thing.set("material", std::move(m));
  } else {
    Block m = opaque(dice);
    if (!is_in_solid && dice.chance(0.35))
      make_clear(dice, m, dice.chance(0.9) ? ior(dice) : "");
    else if (dice.chance(0.1))
      m.set("fresnel", "true").set("ior", ior(dice));
    thing.set("material", std::move(m));
  }
}

std::vector<Block> random_lights(Dice& dice) {
  std::vector<Block> lights;
  const int count = 1 + dice.below(3);
  for (int i = 0; i < count; ++i) {
    const Vec3 at{dice.length(-5, 5), dice.length(2.5, 7), dice.length(-1, 6)};
    const int kind = dice.below(3);
    Block light = block(kind == 0 ? "light" : kind == 1 ? "sun" : "spot");
    double intensity = dice.between(0.3, 0.9);
    if (kind == 1)
      light.set("direction", text(at * -dice.between(0.1, 1)));
    else
      light.set("at", text(at));
    if (kind == 2) {
      const double angle = dice.between(10, 60);
      light.set("look_at", text(dice.point(-1, 1))).set("angle", text(angle));
      if (dice.chance(0.7)) light.set("falloff", text(angle * dice.between(1, 2)));
    }
    if (kind != 1 && dice.chance(0.5)) {
      const double d = dice.length(2, 8);
      constexpr const char* laws[] = {"linear", "quadratic"};
      if (dice.chance(0.3))
        light.set("fade", "inverse_square"), intensity *= 30 * dice.length_unit * dice.length_unit;
      else
        light.set("fade", fmt::format("{}({})", laws[dice.below(2)], text(d))), intensity *= 2;
    }
    light.set("intensity", text(intensity));
    if (dice.chance(0.5)) light.set("color", color(dice));
    // Its size is path mode's.
    if (dice.chance(0.1)) light.set(kind == 1 ? "size" : "radius", text(dice.between(0.1, 0.5)));
    // POV-Ray has no spotlight without shadows.
    if (kind != 2 && dice.chance(0.12)) light.set("shadows", "false");
    if (dice.chance(0.1)) light.chain.push_back(fmt::format(".rotate(y: {})", text(dice.between(-40, 40))));
    if (dice.chance(0.12)) {
      Block around = block("group").set("rotate", text(dice.vector(-15, 15))).set("at", text(dice.point(-0.4, 0.4)));
      if (dice.chance(0.5)) around.set("scale", text(dice.vector(0.9, 1.2)));
      around.things.push_back(std::move(light));
      lights.push_back(std::move(around));
    } else
      lights.push_back(std::move(light));
  }
  return lights;
}

Block random_camera(Dice& dice) {
  Block camera = block("camera");
  const bool is_orthographic = dice.chance(0.25);
  // The whole of an orthographic view starts above the floor.
  const Vec3 way{dice.between(-1, 1), is_orthographic ? dice.between(0.6, 1) : dice.between(-0.05, 0.8),
                 dice.between(0.3, 1)};
  camera.set("at", text(normalize(way) * dice.length_unit * (is_orthographic ? 9 : dice.between(5, 9))));
  camera.set("look_at", text(dice.point(-0.4, 0.4)));
  if (dice.chance(0.3)) {
    const double size = dice.between(0.5, 2);
    camera.set("up", text(Vec3{dice.between(-0.6, 0.6), 1, dice.between(-0.3, 0.3)} * size));
  }
  if (is_orthographic)
    camera.set("projection", "orthographic").set("width", text(dice.length(3, 5)));
  else if (dice.chance(0.8))
    camera.set("fov", text(dice.between(25, 75)));
  // The lens is path mode's.
  if (dice.chance(0.1)) {
    camera.set("aperture", text(dice.length(0.01, 0.2)));
    if (dice.chance(0.5))
      camera.set("focus", text(dice.length(1, 6)));
    else
      camera.set("focus_at", text(dice.point(-0.4, 0.4)));
  }
  return camera;
}

double random_length_unit(Dice& dice) {
  return std::pow(100, dice.unit());
}

Block random_scene(Dice& dice, Mode mode) {
  Block file;
  dice.length_unit = random_length_unit(dice);
  const bool is_color = mode == Mode::color;
  if (is_color) add_settings(dice, file);
  file.things.push_back(random_camera(dice));
  const auto& view = file.things.back().props;
  const bool is_orthographic =
      std::any_of(view.begin(), view.end(), [](const Prop& p) { return p.name == "projection"; });
  if (is_color)
    for (Block& light : random_lights(dice)) file.things.push_back(std::move(light));
  if (is_color && dice.chance(0.2)) file.things.push_back(random_sky(dice));
  // Rays of an orthographic view start all over the place: for POV-Ray some would start inside a slanted floor.
  if (dice.chance(0.5) && !is_orthographic)
    file.things.push_back(floor(dice));
  else if (dice.chance(0.6))
    file.things.push_back(tray(dice));
  const int count = is_color ? 2 + dice.below(4) : 1 + dice.below(4);
  for (int i = 0; i < count; ++i) {
    Block thing = random_shape(dice, 0, false);
    place(dice, thing, 1.8);
    if (is_color && dice.chance(0.9)) add_material(dice, thing, false);
    // A part of a solid with a surface of its own.
    if (is_color && thing.head != "group" && !thing.things.empty() && dice.chance(0.5))
      add_material(dice, thing.things.back(), true);
    if (is_color && thing.head == "group" && dice.chance(0.6)) add_material(dice, thing.things.front(), false);
    add_flags(dice, thing);
    file.things.push_back(std::move(thing));
  }
  if (is_color && dice.chance(0.3)) file.things.push_back(nested(dice));
  if (dice.chance(0.2)) add_copies(dice, file);
  if (dice.chance(0.1)) add_row(dice, file);
  if (is_color && dice.chance(0.08)) {
    // The eye inside a solid.
    Block m = opaque(dice);
    std::erase_if(m.props, [](const Prop& p) { return p.name == "diffuse" || p.name == "ambient"; });
    make_clear(dice, m, ior(dice));
    file.things.push_back(block("sphere")
                              .set("radius", text(dice.length(0.8, 2)))
                              .set("at", file.things.front().props.front().text)
                              .set("material", std::move(m)));
  }
  return file;
}

} // namespace rt::tools::oracle
