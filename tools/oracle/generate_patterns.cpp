#include "tools/oracle/generate_patterns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace rt::tools::oracle {
namespace {

class PatternDice {
public:
  PatternDice(Dice& dice, const std::function<std::string(Dice&)>& value, bool is_linear)
      : dice_(dice), value_(value), is_linear_(is_linear) {}

  Block pattern(int depth) {
    Block b = layout(depth);
    place_pattern(dice_, b);
    // Hexagons meet in the plane z = 0, where flat shapes stand too: there rounding decides.
    const bool is_moved = std::ranges::any_of(b.props, [](const Prop& p) { return p.name == "at"; });
    if (b.head == "hexagon" && !is_moved) b.set("at", text(dice_.point(-0.5, 0.5)));
    return b;
  }

private:
  Block layout(int depth) {
    switch (dice_.below(15)) {
    case 0:
      return with_parts("stripes", {"a", "b"}, depth).set("width", text(dice_.between(0.2, 0.8)));
    case 1:
      return with_parts("tiles", {"a", "b", "mortar"}, depth).set("joint", text(dice_.between(0.02, 0.2)));
    case 2:
      return brick(depth);
    case 3:
      return with_parts("hexagon", {"a", "b", "c"}, depth);
    case 4:
      return with_parts("dots", {"ground", "color"}, depth).set("radius", text(dice_.between(0.2, 0.6)));
    case 5:
      return graded("onion", depth);
    case 6:
      return graded("rings", depth);
    case 7:
      return graded("spiral", depth).set("arms", std::to_string(dice_.chance(0.5) ? 1 + dice_.below(3) : -2));
    case 8:
      return graded("leopard", depth);
    case 9:
      return cells();
    case 10:
    case 13:
      return dice_.chance(0.7) ? fractal() : dice_.chance(0.5) ? crackle() : ripples();
    case 11:
    case 12:
      return gradient(depth);
    default:
      return with_parts("checker", {"a", "b"}, depth);
    }
  }

  static Block block(std::string head) { return {std::move(head), {}, {}, {}, {}, false}; }

  Block with_parts(const char* noun, std::initializer_list<const char*> parts, int depth) {
    Block b = block(noun);
    for (const char* part : parts) {
      if (depth < 1 && dice_.chance(0.15))
        b.set(part, pattern(depth + 1));
      else
        b.set(part, value_(dice_));
    }
    return b;
  }

  Block brick(int depth) {
    Block b = with_parts("brick", {"mortar", "color"}, depth);
    if (dice_.chance(0.7))
      b.set("size", text(Vec3{dice_.between(0.5, 1), dice_.between(0.2, 0.5), dice_.between(0.3, 1)}));
    return b.set("joint", text((1 + dice_.below(16)) / 128.0)); // POV-Ray keeps it in 32 bits
  }

  Block gradient(int depth) {
    constexpr const char* kinds[] = {"radial", "spherical", "cylindrical", "angular", "box"};
    Block b = graded("gradient", depth);
    if (dice_.chance(0.6)) return b.set("kind", kinds[dice_.below(5)]);
    if (dice_.chance(0.2)) b.set("repeat", "false");
    return b.set("direction", text(dice_.direction() * dice_.between(0.5, 2)));
  }

  // POV-Ray's values by chance are others: all places show the same.
  Block by_chance(const char* noun) {
    Block b = block(noun).set("stops", fmt::format("[[0, {0}], [1, {0}]]", value_(dice_)));
    set_shared(b);
    return b.set("seed", std::to_string(1 + dice_.below(9)));
  }

  Block cells() { return by_chance("cells"); }

  Block fractal() {
    constexpr const char* nouns[] = {"noise", "turbulence", "granite", "agate", "marble", "wood"};
    const int kind = dice_.below(6);
    Block b = by_chance(nouns[kind]);
    if (kind > 2) b.set("wander", text(dice_.unit()));
    if (kind == 5) b.set("grain", text(dice_.unit()));
    return b.set("octaves", "2").set("lacunarity", text(dice_.between(1.5, 3))).set("gain", text(dice_.unit()));
  }

  Block crackle() {
    constexpr const char* measures[] = {"first", "second", "edge"};
    return by_chance("crackle").set("measure", measures[dice_.below(3)]);
  }

  Block ripples() {
    return by_chance("ripples").set("sources", std::to_string(1 + dice_.below(4))).set("spread", text(dice_.unit()));
  }

  Block graded(const char* noun, int depth) {
    Block b = block(noun);
    b.set("stops", stops(depth));
    set_shared(b);
    return b;
  }

  void set_shared(Block& b) {
    if (!is_linear_ || dice_.chance(0.2)) b.set("stepped", "true");
    if (dice_.chance(0.4)) b.set("frequency", text(dice_.between(-1, 4)));
    if (dice_.chance(0.3)) b.set("phase", text(dice_.between(-1, 2)));
    constexpr const char* waves[] = {"ramp", "triangle", "sine", "scallop", "cubic"};
    if (dice_.chance(0.5)) b.set("wave", waves[dice_.below(5)]);
    if (dice_.chance(0.2)) b.set("exponent", text(dice_.between(0.5, 3)));
  }

  std::string stops(int depth) {
    std::vector<double> places(static_cast<std::size_t>(1 + dice_.below(4)));
    for (double& place : places) place = dice_.unit();
    std::sort(places.begin(), places.end());
    std::string list;
    for (const double place : places) {
      const bool is_nested = depth < 1 && dice_.chance(0.15);
      const std::string shown = is_nested ? on_one_line(pattern(depth + 1)) : value_(dice_);
      list += fmt::format("{}[{}, {}]", list.empty() ? "" : ", ", text(place), shown);
    }
    return "[" + list + "]";
  }

  static std::string on_one_line(const Block& b) {
    std::string props;
    for (const Prop& p : b.props)
      props += fmt::format("{}{}: {}", props.empty() ? "" : ", ", p.name,
                           p.block.empty() ? p.text : on_one_line(p.block.front()));
    return fmt::format("{} {{ {} }}", b.head, props);
  }

  Dice& dice_;
  const std::function<std::string(Dice&)>& value_;
  bool is_linear_;
};

} // namespace

Block random_pattern(Dice& dice, const std::function<std::string(Dice&)>& value, bool is_linear) {
  return PatternDice(dice, value, is_linear).pattern(0);
}

void place_pattern(Dice& dice, Block& pattern) {
  if (dice.chance(0.7))
    pattern.set("scale", dice.chance(0.7) ? text(dice.length(0.2, 0.8)) : text(dice.point(0.2, 0.9)));
  if (dice.chance(0.4)) pattern.set("rotate", text(dice.vector(-90, 90)));
  if (dice.chance(0.4)) pattern.set("at", text(dice.point(-0.5, 0.5)));
}

} // namespace rt::tools::oracle
