#include "tools/povray/export/export_function.hpp"
#include "tools/povray/export/export_parts.hpp"
#include "tools/povray/export/export_pattern.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

bool is_grey(const Color& c) {
  return c.r == c.g && c.g == c.b;
}
std::string amount(const Color& c) {
  return is_grey(c) ? number(c.r) : rgb(c);
}

// Of properties that are no patterns.
double constant(const NumberPaint& paint) {
  return std::get<double>(paint);
}
const Color& constant(const Paint& paint) {
  return std::get<Color>(paint);
}

// Writes one material. Its patterns all live in the material's space, but POV-Ray carries a pigment or texture inside a
// pattern along with that pattern: `current` is the map from where the text stands to the material's space, and what
// stands inside is moved back.
class TextureWriter {
public:
  TextureWriter(Writer& out, const Scene& scene, std::vector<std::string>& inexact)
      : out_(out), scene_(scene), inexact_(inexact) {}

  void texture(const std::string& head, const Material& m, const Map& current) {
    out_.open(head);
    out_.close(texture_body(m, current));
  }

private:
  // What stands in a texture, up to its transform, which is given back. A finish has numbers only, and the share that a
  // pigment lets by is one of its pattern: any other property that is a pattern becomes a pattern of textures.
  std::string texture_body(const Material& m, const Map& current) {
    for (const Field& field : fields(&m)) {
      const std::optional<FieldValue> value = field.get(&m);
      const PatternId* id = value ? std::get_if<PatternId>(&*value) : nullptr;
      if (!id || field.name == "color" || field.name == "bump") continue;
      const Pattern& p = pattern(*id);
      if (const FunctionPattern* computed = std::get_if<FunctionPattern>(&p.layout)) {
        const bool is_linear = field.name != "shininess" && field.name != "roughness";
        if (is_linear) return function_body(m, field, *computed->function, p, current);
        inexact_.push_back("POV-Ray's `roughness` is a number: a function cannot be written there");
        Material part = m;
        (field.name == "shininess" ? static_cast<void>(part.shininess = Material{}.shininess) : part.roughness.reset());
        return texture_body(part, current);
      }
      const PatternText text = pattern_text(p.layout, inexact_);
      if (text.is_mixed && (field.name == "shininess" || field.name == "roughness"))
        inexact_.push_back("POV-Ray's `roughness` is a number: between two stops it mixes their highlights");
      write_parts(text, "texture", [&](const FieldValue& shown) {
        Material part = m;
        field.set(&part, shown);
        return texture_body(part, map_of(p.placement));
      });
      return moved(p, current);
    }
    std::visit([&](const auto& color) { pigment(color, constant(m.refract), current); }, m.color);
    out_.line(finish(with_implied(m)));
    return {};
  }

  const Pattern& pattern(PatternId id) const { return scene_.patterns[static_cast<std::size_t>(id)]; }

  // Writes the pattern, and each of its parts by `body`, which gives back the part's end.
  template <class F>
  void write_parts(const PatternText& text, std::string_view kind, F&& body) {
    for (const std::string& function : text.declared) out_.line("#declare " + function);
    out_.line(text.head);
    for (const std::string& function : text.declared) out_.line("#undef " + function.substr(0, function.find(' ')));
    if (!text.is_list) out_.open(fmt::format("{}_map", kind));
    for (const PatternText::Part& part : text.parts) {
      if (!text.is_list)
        write_entry(part.place, [&] { return body(part.shown); });
      else if (const Color* color = std::get_if<Color>(&part.shown); color && kind == "pigment")
        out_.line(fmt::format("pigment {{ {} }}", body(*color)));
      else
        out_.open(kind), out_.close(body(part.shown));
    }
    if (!text.is_list) out_.close();
    if (!text.tail.empty()) out_.line(text.tail);
  }

  // One of a map; what `body` gives back stands at its end.
  template <class F>
  void write_entry(double place, F&& body) {
    out_.line("[" + number(place));
    if (const std::string end = body(); !end.empty()) out_.line(end);
    out_.line("]");
  }

  static std::string moved(const Pattern& p, const Map& current) {
    const Map own = map_of(p.placement);
    if (own == current) return {};
    if (current != Map{}) return matrix(then(own, inverse(current)));
    const std::string text = transforms(p.placement);
    return text.empty() ? text : text.substr(1);
  }

  void pigment(const FieldValue& paint, double filter, const Map& current) {
    if (const Color* color = std::get_if<Color>(&paint))
      return out_.line(fmt::format("pigment {{ {} }}", rgb(*color, filter)));
    out_.open("pigment");
    out_.close(pigment_body(paint, filter, current));
  }

  // What stands in a pigment; its end, the colour or the transform, is given back.
  std::string pigment_body(const FieldValue& paint, double filter, const Map& current) {
    if (const Color* color = std::get_if<Color>(&paint)) return rgb(*color, filter);
    const Pattern& p = pattern(std::get<PatternId>(paint));
    if (const FunctionPattern* computed = std::get_if<FunctionPattern>(&p.layout))
      function_pigment(*computed->function, filter);
    else
      write_parts(pattern_text(p.layout, inexact_), "pigment",
                  [&](const FieldValue& shown) { return pigment_body(shown, filter, map_of(p.placement)); });
    return moved(p, current);
  }

  // A pattern of POV-Ray's is one number between 0 and 1, which a map turns into colours.
  struct Channel {
    FunctionText text;
    double scale; // the most that it gives
    Color color;  // what it is a share of
  };
  // No picture shows more. The scale costs no digits: a share of black and of the most is as precise as the share.
  static constexpr double brightest = 1e6;

  std::vector<Channel> channels(const Function& function, double highest) {
    static constexpr Color primaries[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const bool is_grey = function.results.size() == 1;
    std::vector<Channel> all;
    for (std::size_t i = 0; i < function.results.size(); ++i) {
      std::string problem;
      auto text = function_text(function, i, problem);
      if (!text) inexact_.push_back(std::move(problem));
      const double scale = std::clamp(upper_bound(function, i), 1.0, std::min(highest, brightest));
      all.push_back({text.value_or(FunctionText{{}, "0"}), scale, is_grey ? white : primaries[i]});
    }
    return all;
  }

  // The average of three thirds, each three times as bright, is their sum.
  void function_pigment(const Function& function, double filter) {
    const std::vector<Channel> all = channels(function, std::numeric_limits<double>::infinity());
    const auto write = [&](const Channel& channel) {
      write_function_pattern(out_, channel.text, channel.scale);
      const Color full = channel.color * (channel.scale * static_cast<double>(all.size()));
      out_.line(fmt::format("color_map {{ [0 {}] [1 {}] }}", rgb(black, filter), rgb(full, filter)));
    };
    if (all.size() == 1) return write(all[0]);
    out_.line("average");
    out_.open("pigment_map");
    for (const Channel& channel : all) {
      out_.line("[1");
      write(channel);
      out_.line("]");
    }
    out_.close();
  }

  // The light that a surface gives is proportional to each property but one: a mixture of two textures, with the least
  // and the most of the property, has what is between.
  std::string function_body(const Material& m, const Field& field, const Function& function, const Pattern& p,
                            const Map& current) {
    const Map inner = map_of(p.placement);
    const std::vector<Channel> all = channels(function, field.constraint.max);
    const auto write = [&](const Channel& channel) {
      const Color most = channel.color * (channel.scale * static_cast<double>(all.size()));
      write_function_pattern(out_, channel.text, channel.scale);
      out_.open("texture_map");
      for (const auto& [place, value] : {std::pair(0.0, black), std::pair(1.0, most)}) {
        Material part = m;
        field.set(&part, value);
        write_entry(place, [&] { return texture_body(part, inner); });
      }
      out_.close();
      return std::string();
    };
    if (all.size() == 1) {
      write(all[0]);
      return moved(p, current);
    }
    out_.line("average");
    out_.open("texture_map");
    for (const Channel& channel : all) write_entry(1, [&] { return write(channel); });
    out_.close();
    return moved(p, current);
  }

  std::string finish(const Material& m) {
    const Color diffuse = constant(m.diffuse);
    if (constant(m.coat) != 0) inexact_.push_back("POV-Ray has no coat: `coat` is left out");
    if (!is_grey(diffuse)) inexact_.push_back("POV-Ray's `diffuse` is a number: a colour cannot be written there");
    std::string text = fmt::format("finish {{ ambient {} diffuse {} emission {}", amount(constant(m.ambient)),
                                   number(diffuse.r), amount(constant(m.emission)));
    if (const double specular = constant(m.specular), shininess = constant(m.shininess); specular != 0)
      text += m.highlight == Highlight::blinn
                  ? fmt::format(" specular {} roughness {}", number(specular), number(1 / shininess))
                  : fmt::format(" phong {} phong_size {}", number(specular), number(shininess));
    if (const double metallic = constant(m.metallic); metallic != 0) text += " metallic " + number(metallic);
    if (constant(m.reflect) != black) text += reflection(m);
    return text + " }";
  }

  static std::string reflection(const Material& m) {
    const Color reflect = constant(m.reflect);
    std::string text = m.fresnel ? fmt::format(" reflection {{ rgb 0, {} fresnel on", rgb(reflect))
                                 : fmt::format(" reflection {{ {}", rgb(reflect));
    if (const double metallic = constant(m.metallic); metallic != 0) text += " metallic " + number(metallic);
    return text + (m.fresnel ? " } conserve_energy" : " }");
  }

  Writer& out_;
  const Scene& scene_;
  std::vector<std::string>& inexact_;
};

// What is shown all over, where that is one and the same.
std::optional<FieldValue> only_shown(const Scene& scene, const FieldValue& shown) {
  const PatternId* id = std::get_if<PatternId>(&shown);
  if (!id) return shown;
  std::vector<std::string> ignored;
  std::optional<FieldValue> only;
  for (const PatternText::Part& part :
       pattern_text(scene.patterns[static_cast<std::size_t>(*id)].layout, ignored).parts) {
    const std::optional<FieldValue> one = only_shown(scene, part.shown);
    if (!one || (only && !(*only == *one))) return std::nullopt;
    only = one;
  }
  return only;
}

// With a power from 1000 on POV-Ray's fading is e^(−(1 − fade_color)·t/fade_distance): ours with the distance after
// which the darkest channel is down to 1/e.
std::string absorbed(const Absorb& absorb) {
  const auto depth = [](double left) { return -std::log(std::max(left, 1e-300)); };
  const Color depths{depth(absorb.color.r), depth(absorb.color.g), depth(absorb.color.b)};
  const double most = max_component(depths);
  if (most <= 0) return "";
  return fmt::format(" fade_power 1001 fade_distance {} fade_color {}", number(absorb.distance / most),
                     rgb(white - depths * (1 / most)));
}

} // namespace

void write_texture(Writer& out, const std::string& head, const Scene& scene, const Material& material,
                   std::vector<std::string>& inexact) {
  TextureWriter(out, scene, inexact).texture(head, material, {});
  const PatternId* bumps = std::get_if<PatternId>(&material.bump);
  if (bumps && !only_shown(scene, *bumps))
    inexact.push_back("POV-Ray bends normals in another way: `bump` is left out");
  if (material.thin && material.fresnel)
    inexact.push_back("POV-Ray bends what passes a `thin` sheet that mirrors by Fresnel's equations");
  if (material.absorb && is_medium(material))
    inexact.push_back("POV-Ray's shadows are absorbed too, and where solids overlap each absorbs");
}

bool needs_interior(const Material& material) {
  return !is_opaque(material) || material.fresnel;
}

std::string interior(const Material& material) {
  const bool is_straight = material.thin && !material.fresnel;
  return fmt::format("interior {{ ior {}{} }}", number(is_straight ? 1 : material.ior),
                     material.absorb && is_medium(material) ? absorbed(*material.absorb) : "");
}

} // namespace rt::tools::povray
