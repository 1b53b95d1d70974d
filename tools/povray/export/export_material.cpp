#include "tools/povray/export/export_parts.hpp"

#include <fmt/format.h>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

bool is_grey(const Color& c) {
  return c.r == c.g && c.g == c.b;
}
std::string amount(const Color& c) {
  return is_grey(c) ? number(c.r) : rgb(c);
}

// Writes one material. Its patterns all live in the material's space, but POV-Ray carries a pigment or texture inside a
// pattern along with that pattern: `current` is the map from where the text stands to the material's space, and what
// stands inside is moved back.
class TextureWriter {
public:
  TextureWriter(Writer& out, const Scene& scene, std::vector<std::string>& inexact)
      : out_(out), scene_(scene), inexact_(inexact) {}

  // A finish has numbers only: a pattern of numbers becomes a pattern of two textures.
  void texture(const std::string& head, Material m, const Map& current) {
    for (Paint Material::*part : {&Material::ambient, &Material::diffuse, &Material::emission}) {
      const PatternId* id = std::get_if<PatternId>(&(m.*part));
      if (!id) continue;
      const Pattern& p = pattern(*id);
      out_.open(head);
      out_.line(keyword(p));
      for (const Paint& paint : {p.a, p.b}) {
        m.*part = paint;
        texture("texture", m, map_of(p.placement));
      }
      out_.close(moved(p, current));
      return;
    }
    out_.open(head);
    pigment(m.color, m.refract, current);
    out_.line(finish(m));
    out_.close();
  }

private:
  const Pattern& pattern(PatternId id) const { return scene_.patterns[static_cast<std::size_t>(id)]; }

  static std::string keyword(const Pattern& p) {
    switch (p.kind) {
    case PatternKind::checker:
      return "checker";
    }
    return {};
  }

  static std::string moved(const Pattern& p, const Map& current) {
    const Map own = map_of(p.placement);
    if (own == current) return {};
    if (current != Map{}) return matrix(then(own, inverse(current)));
    const std::string text = transforms(p.placement);
    return text.empty() ? text : text.substr(1);
  }

  void pigment(const Paint& paint, double filter, const Map& current) {
    if (const Color* color = std::get_if<Color>(&paint)) {
      out_.line(fmt::format("pigment {{ {} }}", rgb(*color, filter)));
      return;
    }
    const Pattern& p = pattern(std::get<PatternId>(paint));
    out_.open("pigment");
    out_.line(keyword(p));
    for (const Paint& part : {p.a, p.b}) pigment(part, filter, map_of(p.placement));
    out_.close(moved(p, current));
  }

  std::string finish(const Material& m) {
    const Color diffuse = std::get<Color>(m.diffuse);
    if (!is_grey(diffuse)) inexact_.push_back("POV-Ray's `diffuse` is a number: a colour cannot be written there");
    std::string text = fmt::format("finish {{ ambient {} diffuse {} emission {}", amount(std::get<Color>(m.ambient)),
                                   number(diffuse.r), amount(std::get<Color>(m.emission)));
    if (m.specular != 0)
      text += m.highlight == Highlight::blinn
                  ? fmt::format(" specular {} roughness {}", number(m.specular), number(1 / m.shininess))
                  : fmt::format(" phong {} phong_size {}", number(m.specular), number(m.shininess));
    if (m.metallic != 0) text += " metallic " + number(m.metallic);
    if (m.reflect != black) text += reflection(m);
    return text + " }";
  }

  static std::string reflection(const Material& m) {
    std::string text = m.fresnel ? fmt::format(" reflection {{ rgb 0, {} fresnel on", rgb(m.reflect))
                                 : fmt::format(" reflection {{ {}", rgb(m.reflect));
    if (m.metallic != 0) text += " metallic " + number(m.metallic);
    return text + (m.fresnel ? " } conserve_energy" : " }");
  }

  Writer& out_;
  const Scene& scene_;
  std::vector<std::string>& inexact_;
};

} // namespace

void write_texture(Writer& out, const std::string& head, const Scene& scene, const Material& material,
                   std::vector<std::string>& inexact) {
  TextureWriter(out, scene, inexact).texture(head, material, {});
}

bool needs_interior(const Material& material) {
  return material.refract > 0 || material.fresnel;
}

std::string interior(const Material& material) {
  return fmt::format("interior {{ ior {} }}", number(material.ior));
}

} // namespace rt::tools::povray
