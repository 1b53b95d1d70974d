#include "tools/povray/export/export_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// How POV-Ray calls a pattern that is a list of pigments or of textures, which its paints become in the order of its
// fields.
std::string_view keyword(const Checker&) {
  return "checker";
}

// Writes one material. Its patterns all live in the material's space, but POV-Ray carries a pigment or texture inside a
// pattern along with that pattern: `current` is the map from where the text stands to the material's space, and what
// stands inside is moved back.
class TextureWriter {
public:
  TextureWriter(Writer& out, const Scene& scene, std::vector<std::string>& inexact)
      : out_(out), scene_(scene), inexact_(inexact) {}

  // A finish has numbers only, and the share that a pigment lets by is one of its pattern: any other property that is a
  // pattern becomes a pattern of textures.
  void texture(const std::string& head, const Material& m, const Map& current) {
    for (const Field& field : fields(&m)) {
      const std::optional<FieldValue> value = field.get(&m);
      const PatternId* id = value ? std::get_if<PatternId>(&*value) : nullptr;
      if (!id || field.name == "color") continue;
      const Pattern& p = pattern(*id);
      out_.open(head);
      for_each_paint(p, [&](const FieldValue& paint) {
        Material part = m;
        field.set(&part, paint);
        texture("texture", part, map_of(p.placement));
      });
      out_.close(moved(p, current));
      return;
    }
    out_.open(head);
    std::visit([&](const auto& color) { pigment(color, constant(m.refract), current); }, m.color);
    out_.line(finish(with_implied(m)));
    out_.close();
  }

private:
  const Pattern& pattern(PatternId id) const { return scene_.patterns[static_cast<std::size_t>(id)]; }

  // Writes what kind of pattern it is, and then each of its paints by f.
  template <class F>
  void for_each_paint(const Pattern& p, F&& f) {
    std::visit(
        [&](const auto& layout) {
          out_.line(keyword(layout));
          for (const Field& field : fields(&layout))
            if (const auto paint = field.is_textured ? field.get(&layout) : std::nullopt) f(*paint);
        },
        p.layout);
  }

  static std::string moved(const Pattern& p, const Map& current) {
    const Map own = map_of(p.placement);
    if (own == current) return {};
    if (current != Map{}) return matrix(then(own, inverse(current)));
    const std::string text = transforms(p.placement);
    return text.empty() ? text : text.substr(1);
  }

  void pigment(const FieldValue& paint, double filter, const Map& current) {
    const PatternId* id = std::get_if<PatternId>(&paint);
    if (!id) {
      out_.line(fmt::format("pigment {{ {} }}", rgb(std::get<Color>(paint), filter)));
      return;
    }
    const Pattern& p = pattern(*id);
    out_.open("pigment");
    for_each_paint(p, [&](const FieldValue& part) { pigment(part, filter, map_of(p.placement)); });
    out_.close(moved(p, current));
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
