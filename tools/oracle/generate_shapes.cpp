#include "tools/oracle/generate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace rt::tools::oracle {
namespace {

std::string list(const std::vector<Vec3>& points) {
  std::string all;
  for (const Vec3& p : points) all += (all.empty() ? "" : ", ") + text(p);
  return "[" + all + "]";
}

Block block(const char* head) {
  return {head, {}, {}, {}, {}, false};
}

Block sphere(Dice& dice) {
  return block("sphere").set("radius", text(dice.length(0.3, 1)));
}

Block box(Dice& dice) {
  Block b = block("box");
  if (dice.chance(0.3)) {
    const Vec3 p = dice.point(-0.9, -0.1), q = dice.point(0.1, 0.9);
    // Any two opposite corners will do.
    return dice.chance(0.5) ? b.set("from", text(p)).set("to", text(q))
                            : b.set("from", text({q.x, p.y, q.z})).set("to", text({p.x, q.y, p.z}));
  }
  return dice.chance(0.5) ? b.set("size", text(dice.length(0.5, 1.4))) : b.set("size", text(dice.point(0.3, 1.5)));
}

Block cylinder(Dice& dice, bool is_solid) {
  Block b = block("cylinder");
  b.set("radius", text(dice.length(0.15, 0.6)));
  const bool is_infinite = dice.chance(0.12);
  if (dice.chance(0.5))
    b.set("from", text(dice.point(-0.9, -0.1))).set("to", text(dice.point(0.1, 0.9)));
  else {
    if (dice.chance(0.7)) b.set("axis", text(dice.arrow(0.5, 2)));
    if (!is_infinite) b.set("height", text(dice.length(0.4, 2)));
  }
  if (is_infinite)
    b.set("infinite", "true");
  else if (!is_solid && dice.chance(0.35))
    b.set("open", "true");
  return b;
}

Block cone(Dice& dice, bool is_solid) {
  Block b = block("cone");
  const double radius = dice.length(0.2, 0.7);
  b.set("radius", dice.chance(0.1) ? "0" : text(radius));
  if (b.props[0].text == "0")
    b.set("top_radius", text(dice.length(0.2, 0.7)));
  else if (dice.chance(0.5))
    b.set("top_radius", dice.chance(0.2) ? b.props[0].text : text(dice.length(0.05, 0.9)));
  if (dice.chance(0.6))
    b.set("from", text(dice.point(-0.9, -0.1))).set("to", text(dice.point(0.1, 0.9)));
  else
    b.set("to", text(Vec3{0, dice.length_unit, 0}));
  if (!is_solid && dice.chance(0.35)) b.set("open", "true");
  return b;
}

Block disc(Dice& dice) {
  Block b = block("disc");
  const double radius = dice.length(0.4, 1);
  b.set("radius", text(radius));
  if (dice.chance(0.8)) b.set("normal", text(dice.arrow(0.5, 2)));
  if (dice.chance(0.4)) b.set("hole", text(radius * dice.between(0.2, 0.8)));
  return b;
}

Block triangle(Dice& dice) {
  std::vector<Vec3> p;
  Vec3 n;
  do {
    p = {dice.vector(-1, 1), dice.vector(-1, 1), dice.vector(-1, 1)};
    n = cross(p[1] - p[0], p[2] - p[0]);
  } while (length(n) < 0.4);
  for (Vec3& corner : p) corner = corner * dice.length_unit;
  Block b = block("triangle").set("points", list(p));
  if (dice.chance(0.4)) return b;
  // POV-Ray leaves out a triangle whose normals are not all on one side.
  std::vector<Vec3> normals;
  const double side = dice.sign();
  for (int i = 0; i < 3; ++i) {
    const double size = dice.between(0.5, 2);
    normals.push_back((normalize(n) * side + dice.arrow(0, 0.8)) * size);
  }
  return b.set("normals", list(normals));
}

// Around the origin of the plane z = 0, so that the written decimals lie in one plane.
std::vector<Vec3> outline(Dice& dice, int corners, double least, double most) {
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + dice.between(-0.3, 0.3)) * 2 * std::numbers::pi / corners, r = dice.length(least, most);
    points.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return points;
}

Block quad(Dice& dice) {
  Block b = block("quad");
  const double form = dice.unit();
  if (form < 0.35) {
    b.set("size", text(dice.length(0.5, 1.5)));
    if (dice.chance(0.8)) b.set("normal", text(dice.arrow(0.5, 2)));
    return b;
  }
  if (form < 0.7) {
    const Vec3 u = dice.direction();
    const double slant = dice.between(-0.5, 0.5);
    const Vec3 v = normalize(cross(u, dice.direction()) + u * slant);
    return b.set("corner", text(dice.point(-0.8, 0.2)))
        .set("edge_u", text(u * dice.length_unit))
        .set("edge_v", text(v * dice.length(0.5, 1.2)));
  }
  return b.set("points", list(outline(dice, 4, 0.7, 0.9)));
}

Block polygon(Dice& dice) {
  return block("polygon").set("points", list(outline(dice, 3 + dice.below(6), 0.3, 1)));
}

Block half_space(Dice& dice) {
  Block b = block("plane");
  switch (dice.below(4)) {
  case 0:
    return b.set("x", text(dice.length(-0.5, 0.5)));
  case 1:
    return b.set("y", text(dice.length(-0.5, 0.5)));
  case 2:
    return b.set("z", text(dice.length(-0.5, 0.5)));
  default:
    return b.set("normal", text(dice.arrow(0.5, 2))).set("offset", text(dice.length(-0.4, 0.4)));
  }
}

Block solid_leaf(Dice& dice) {
  switch (dice.below(4)) {
  case 0:
    return sphere(dice);
  case 1:
    return box(dice);
  case 2:
    return cylinder(dice, true);
  default:
    return cone(dice, true);
  }
}

Block leaf(Dice& dice) {
  switch (dice.below(9)) {
  case 0:
    return disc(dice);
  case 1:
    return triangle(dice);
  case 2:
    return quad(dice);
  case 3:
    return polygon(dice);
  case 4:
    return cylinder(dice, false);
  case 5:
    return cone(dice, false);
  case 6:
    return box(dice);
  default:
    return sphere(dice);
  }
}

Block combination(Dice& dice, int depth) {
  constexpr const char* nouns[] = {"union", "intersection", "difference"};
  constexpr const char* signs[] = {"|", "&", "-"};
  const int which = dice.below(3);
  Block b = block(nouns[which]);
  if (dice.chance(0.5)) b.operation = signs[which];
  const int parts = 2 + dice.below(2);
  for (int i = 0; i < parts; ++i) {
    const bool may_be_half_space = i > 0 && which != 0 && dice.chance(0.2);
    Block part = may_be_half_space ? half_space(dice) : random_shape(dice, depth + 1, true);
    place(dice, part, 0.35);
    b.things.push_back(std::move(part));
  }
  return b;
}

Block group(Dice& dice, int depth, bool is_solid) {
  Block b = block("group");
  const int members = 1 + dice.below(3);
  for (int i = 0; i < members; ++i) {
    Block member = random_shape(dice, depth + 1, is_solid);
    place(dice, member, 0.7);
    b.things.push_back(std::move(member));
  }
  return b;
}

std::string step(Dice& dice) {
  const std::string about = dice.chance(0.3) ? ", about: " + text(dice.point(-0.5, 0.5)) : "";
  const auto factor = [&] { return text(dice.factor(0.7, 1.4)); };
  switch (dice.below(10)) {
  case 0:
    return fmt::format(".scale({}{})", factor(), about);
  case 1: {
    const std::string z = factor(), y = factor(), x = factor();
    return fmt::format(".scale([{}, {}, {}]{})", x, y, z, about);
  }
  case 2:
    return fmt::format(".scale(y: {}{})", factor(), about);
  case 3:
    return fmt::format(".rotate({}{})", text(dice.vector(-180, 180)), about);
  case 4: {
    const double angle = dice.between(-180, 180);
    return fmt::format(".rotate({}: {}{})", "xyz"[dice.below(3)], text(angle), about);
  }
  case 5: {
    const double angle = dice.between(-180, 180);
    return fmt::format(".rotate(axis: {}, angle: {}{})", text(dice.direction()), text(angle), about);
  }
  case 6:
    return fmt::format(".move({})", text(dice.point(-0.4, 0.4)));
  case 7: {
    const double zx = dice.between(-0.5, 0.5), xy = dice.between(-0.5, 0.5);
    return fmt::format(".shear(xy: {}, zx: {}{})", text(xy), text(zx), about);
  }
  case 8:
    return fmt::format(".mirror({}{})", text(dice.direction()), about);
  default: {
    const Vec3 a = dice.vector(-0.3, 0.3), b = dice.vector(-0.3, 0.3), c = dice.vector(-0.3, 0.3),
               t = dice.point(-0.4, 0.4);
    return fmt::format(".transform([[{}, {}, {}, {}], [{}, {}, {}, {}], [{}, {}, {}, {}]])", text(1 + a.x), text(a.y),
                       text(a.z), text(t.x), text(b.x), text(1 + b.y), text(b.z), text(t.y), text(c.x), text(c.y),
                       text(1 + c.z), text(t.z));
  }
  }
}

} // namespace

Block random_shape(Dice& dice, int depth, bool is_solid) {
  const double kind = dice.unit();
  if (depth < 2 && kind < 0.25) return combination(dice, depth);
  if (depth < 2 && kind < 0.36) return group(dice, depth, is_solid);
  return is_solid ? solid_leaf(dice) : leaf(dice);
}

void place(Dice& dice, Block& thing, double reach) {
  thing.set("at", text(dice.point(-reach, reach)));
  if (dice.chance(0.4)) thing.set("rotate", text(dice.vector(-180, 180)));
  if (dice.chance(0.3)) {
    const double f = dice.factor(0.6, 1.4);
    thing.set("scale", dice.chance(0.4) ? text(f) : text({f, dice.factor(0.6, 1.4), dice.factor(0.6, 1.4)}));
  }
  while (dice.chance(0.3)) thing.chain.push_back(step(dice));
}

} // namespace rt::tools::oracle
