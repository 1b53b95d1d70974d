#include "tools/povray/export/export.hpp"

#include "renderer/scene/names.hpp"
#include "renderer/scene/validation/validate.hpp"
#include "tools/povray/export/export_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

class Exporter {
public:
  Exporter(const Scene& scene, const ExportOptions& options)
      : scene_(scene), options_(options), group_uses_(scene.shapes.all<Group>().size()),
        combination_uses_(scene.shapes.all<Combination>().size()) {}

  Exported run() {
    for (const Object& object : scene_.objects) count_uses(object);
    eyes_ = ray_origins(scene_.camera, scene_.size);
    for (const Origin& origin : dropped_triangles(scene_))
      inexact_.push_back({"POV-Ray leaves out a triangle whose `normals`, as its transforms leave them, are not all on "
                          "the same side of it",
                          origin});
    has_media_ = std::any_of(scene_.materials.begin(), scene_.materials.end(), needs_interior);
    Writer objects = write_objects();
    Writer out;
    header(out);
    if (options_.pass == Pass::depth) write_depth_functions(out, scene_.camera);
    std::string text = out.take();
    text += declarations_;
    text += objects.take();
    return {std::move(text), std::move(inexact_)};
  }

  std::string run_geometry(const std::string& name) {
    for (const Object& object : scene_.objects) count_uses(object);
    Writer out;
    everything(out, fmt::format("#declare {} = union", name), {});
    return declarations_ + out.take();
  }

private:
  // What an object inherits from the composites around it.
  struct Around {
    MaterialId material = no_material; ///< that of the nearest enclosing composite that has one
    bool is_textured = false;          ///< an enclosing composite has a texture in the exported text
    bool in_solid = false;
    bool in_shadowless = false;
    bool is_inside = false; ///< of any composite
    Map to_scene;           ///< from the space that the object is placed in
    /// Groups are dissolved: what to write for each member after its own transforms, without and with a texture of its
    /// own.
    bool is_apart = false;
    std::string after_plain, after_textured;
  };

  void header(Writer& out) {
    if (options_.comments) write_introduction(out, scene_);
    write_settings(out, scene_, options_.follows_every_ray ? 0 : min_weight(scene_), inexact_);
    if (options_.pass == Pass::color) write_sky(out);
    comment_origin(out, "camera", no_name, scene_.camera_origin);
    write_camera(out, scene_.camera, scene_.size);
  }

  // POV-Ray's skies occlude each other; ours add up.
  void write_sky(Writer& out) {
    const Light* first = nullptr;
    for (const Light& light : scene_.lights) {
      if (is_lamp(light)) continue;
      if (first) inexact_.push_back({"POV-Ray shows one sky at a time: this one is left out", light.origin});
      if (!first) first = &light;
    }
    if (!first) return out.line(fmt::format("background {{ {} }}", rgb(scene_.background)));
    comment_origin(out, noun(first->source), first->name, first->origin);
    write_light(out, *first, scene_.camera);
  }

  Writer write_objects() {
    Writer out;
    out.blank();
    switch (options_.pass) {
    case Pass::color:
      // Within a light group POV-Ray does not cache the last blocker, which would make a shadow's edge depend on the
      // pixels before it.
      if (!scene_.lights.empty()) out.open("light_group");
      for (const Light& light : scene_.lights) {
        if (!is_lamp(light)) continue;
        comment_origin(out, noun(light.source), light.name, light.origin);
        if (const SpotLight* spot = std::get_if<SpotLight>(&light.source); spot && !spot->shadows)
          inexact_.push_back({"POV-Ray has no spotlight without shadows: `shadowless` makes it shine in all directions",
                              light.origin});
        write_light(out, light, scene_.camera);
      }
      objects(out, scene_.objects, {});
      if (!scene_.lights.empty()) out.close("global_lights off");
      break;
    case Pass::ids:
      objects(out, scene_.objects, textured());
      break;
    case Pass::depth:
      everything(out, "union", depth_texture);
      break;
    case Pass::normals:
      write_normal_lights(out);
      everything(out, "union", "texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }");
      break;
    }
    return out;
  }

  void everything(Writer& out, std::string_view head, std::string_view texture) {
    if (std::none_of(scene_.objects.begin(), scene_.objects.end(), [&](const Object& o) { return has_surface(o); }))
      return;
    out.open(head);
    objects(out, scene_.objects, textured());
    out.close(texture);
  }

  static Around textured() {
    Around around;
    around.is_textured = true;
    return around;
  }

  void objects(Writer& out, const std::vector<Object>& list, const Around& around) {
    for (const Object& o : list)
      if (has_surface(o)) object(out, o, around);
  }

  // POV-Ray does not allow composites without members.
  bool has_surface(const Object& o) const {
    if (!o.is_visible || !refers_to_composite(o.shape)) return o.is_visible;
    const auto& all = parts(scene_.shapes, o.shape);
    if (o.shape.kind == kind_of<Combination> &&
        scene_.shapes.get<Combination>(o.shape).operation == Combination::Operation::subtract)
      return !all.empty() && has_surface(all.front());
    return std::any_of(all.begin(), all.end(), [&](const Object& part) { return has_surface(part); });
  }

  void object(Writer& out, const Object& o, const Around& around) {
    comment_origin(out, noun(scene_.shapes, o.shape), o.name, o.origin);
    Around inside = around;
    const Placement placement = placement_of(scene_, o);
    const std::optional<Triangle> kept = moved_to_be_kept(scene_, o);
    const std::string own = transforms(placement);
    std::string modifiers;
    if (options_.pass == Pass::color)
      modifiers = surface(o, around, inside, kept ? own : "") + shadow(o, around, inside);
    if (options_.pass == Pass::ids && !around.in_solid && o.shape.kind != kind_of<Group>)
      modifiers = fmt::format(" {}", id_texture(++last_id_));
    inside.to_scene = then(map_of(placement), around.to_scene);
    if (options_.pass == Pass::color) modifiers += eye(o, inside);
    const bool has_texture = modifiers.find(" texture {") != std::string::npos;
    modifiers += (kept ? "" : own) + (has_texture ? around.after_textured : around.after_plain);
    // POV-Ray transforms each vertex normal to the scene and interpolates there, as we do, but normalises it beforehand
    // only in `scale`, not in `matrix`.
    const std::string last = !around.is_inside && has_smooth(scene_, o) ? " scale 1" : "";
    modifiers += last;
    inside.is_inside = true;
    if (o.shape.kind == kind_of<Group> && options_.pass == Pass::color && !around.in_solid &&
        (around.is_apart || must_be_apart(o, inside))) {
      inside.is_apart = true;
      inside.after_plain = modifiers;
      inside.after_textured = (o.casts_shadow ? "" : " no_shadow") + own + around.after_textured + last;
      return objects(out, parts(scene_.shapes, o.shape), inside);
    }
    inside.is_apart = false;
    inside.after_plain.clear();
    inside.after_textured.clear();
    if (o.shape.kind == kind_of<Group>)
      group(out, o.shape, inside, modifiers);
    else if (o.shape.kind == kind_of<Combination>)
      combination(out, o.shape, inside, modifiers);
    else {
      const Primitive p = kept                 ? primitive(*kept)
                          : is_thin(o, inside) ? thin_primitive(scene_.shapes.get<Disc>(o.shape))
                                               : primitive(scene_.shapes, o.shape);
      out.line(fmt::format("{} {{ {}{} }}", p.keyword, p.body, modifiers));
    }
  }

  // POV-Ray decides for a whole solid, not for its parts, whether it casts a shadow.
  std::string shadow(const Object& o, const Around& around, Around& inside) {
    if (o.casts_shadow || around.in_shadowless) return {};
    if (around.in_solid)
      inexact_.push_back(
          {"in POV-Ray a solid casts its shadow as a whole: `casts_shadow` of a part cannot be written", o.origin});
    inside.in_shadowless = true;
    return " no_shadow";
  }

  // The texture if the object specifies one, and the index of refraction if it is a separate solid.
  std::string surface(const Object& o, const Around& around, Around& inside, const std::string& moved) {
    std::string text;
    if (o.material != no_material) inside.material = o.material;
    if (o.material != no_material || !around.is_textured) {
      text = fmt::format(" texture {{ {}{} }}", texture(o.material), moved);
      inside.is_textured = true;
    }
    if (around.in_solid || o.shape.kind == kind_of<Group> || !leftmost(o, around.material, needs_interior)) return text;
    const bool says_it = o.material != no_material && needs_interior(material(o.material));
    return fmt::format("{} {}", text,
                       interior(says_it ? material(o.material) : *leftmost(o, around.material, needs_interior)));
  }

  // POV-Ray's rays start inside everything that contains the eye, whether it is a medium or not: `inverse` turns the
  // inside of a non-medium outwards, which changes nothing else, because normals are flipped to the viewer.
  std::string eye(const Object& o, const Around& inside) {
    if (inside.in_solid || !has_media_ || o.shape.kind == kind_of<Group>) return {};
    const std::size_t held = held_eyes(o, inside.to_scene);
    if (held == 0 || is_thin(o, inside)) return {};
    if (is_medium(o, inside.material)) {
      if (++media_around_eye_ == 2)
        inexact_.push_back({"the eye is inside more than one transparent solid, and POV-Ray does not say which it "
                            "takes for the inner one",
                            o.origin});
      return {};
    }
    if (held < eyes_.size())
      inexact_.push_back({"a part of the view's rays starts inside of this opaque thing: POV-Ray takes it for a medium "
                          "that they are in",
                          o.origin});
    return " inverse";
  }

  // A disc that only some of the view's rays start below is written without that inside.
  bool is_thin(const Object& o, const Around& inside) const {
    if (options_.pass != Pass::color || !has_media_ || o.shape.kind != kind_of<Disc>) return false;
    const std::size_t held = held_eyes(o, inside.to_scene);
    return held > 0 && held < eyes_.size();
  }

  // How many of the points where rays start are inside.
  std::size_t held_eyes(const Object& o, const Map& to_scene) const {
    return static_cast<std::size_t>(std::count_if(
        eyes_.begin(), eyes_.end(), [&](const Vec3& eye) { return holds_in_povray(scene_, o, to_scene, eye); }));
  }

  bool is_medium(const Object& o, MaterialId inherited) const {
    return o.shape.kind != kind_of<Disc> &&
           leftmost(o, inherited, [](const Material& m) { return !is_opaque(m); }) != nullptr;
  }

  // For a group around the eye POV-Ray knows only that, not the member; and instances differ in it.
  bool must_be_apart(const Object& o, const Around& inside) const {
    if (!has_media_) return false;
    for (const Object& member : parts(scene_.shapes, o.shape)) {
      if (!member.is_visible) continue;
      Around next = inside;
      next.to_scene = then(map_of(placement_of(scene_, member)), inside.to_scene);
      if (member.shape.kind == kind_of<Group> ? must_be_apart(member, next) : held_eyes(member, next.to_scene) > 0)
        return true;
    }
    return false;
  }

  // The material of the first part that is suitable. A combination is one medium: its own material's, else that of its
  // leftmost part that has an index.
  template <class Is>
  const Material* leftmost(const Object& o, MaterialId inherited, const Is& is_such) const {
    const MaterialId id = o.material != no_material ? o.material : inherited;
    if (!refers_to_composite(o.shape)) return is_such(material(id)) ? &material(id) : nullptr;
    for (const Object& part : parts(scene_.shapes, o.shape))
      if (const Material* found = part.is_visible ? leftmost(part, id, is_such) : nullptr) return found;
    return nullptr;
  }

  void group(Writer& out, ShapeRef shape, const Around& inside, const std::string& modifiers) {
    composite(out, inside.in_solid ? "merge" : "union", shape, inside, modifiers, group_uses_[shape.index]);
  }

  void combination(Writer& out, ShapeRef shape, Around inside, const std::string& modifiers) {
    inside.in_solid = true;
    composite(out, keyword(scene_.shapes.get<Combination>(shape).operation), shape, inside, modifiers,
              combination_uses_[shape.index]);
  }

  static const char* keyword(Combination::Operation operation) {
    switch (operation) {
    case Combination::Operation::unite:
      return "merge";
    case Combination::Operation::intersect:
      return "intersection";
    case Combination::Operation::subtract:
      return "difference";
    }
    return "";
  }

  void composite(Writer& out, std::string_view word, ShapeRef shape, const Around& inside, const std::string& modifiers,
                 std::uint32_t uses) {
    // Ids distinguish the members of instances: then every instance is written out.
    if (uses > 1 && (options_.pass != Pass::ids || inside.in_solid)) {
      out.line(fmt::format("object {{ {}{} }}", declared(word, shape, inside), modifiers));
      return;
    }
    out.open(word);
    objects(out, parts(scene_.shapes, shape), inside);
    out.close(modifiers.empty() ? modifiers : modifiers.substr(1));
  }

  // A shared composite is declared once for each different effect of its surroundings.
  std::string declared(std::string_view word, ShapeRef shape, const Around& inside) {
    const auto key =
        std::tuple(shape.kind, shape.index, inside.material, inside.is_textured, inside.in_solid, inside.in_shadowless);
    if (const auto known = shared_.find(key); known != shared_.end()) return known->second;
    Writer out;
    const std::string name = fmt::format("shared_{}", shared_.size() + 1);
    shared_.emplace(key, name);
    out.blank();
    out.open(fmt::format("#declare {} = {}", name, word));
    objects(out, parts(scene_.shapes, shape), inside);
    out.close();
    declarations_ += out.take();
    return name;
  }

  // The name of the declared texture of a material, which is written on first use.
  std::string texture(MaterialId id) {
    const std::string name =
        id == no_material ? "material_default" : fmt::format("material_{}", static_cast<std::uint32_t>(id) + 1);
    if (!textures_.emplace(id, true).second) return name;
    Writer out;
    std::vector<std::string> problems;
    out.blank();
    write_texture(out, fmt::format("#declare {} = texture", name), scene_, material(id), problems);
    for (std::string& problem : problems) inexact_.push_back({std::move(problem), current_});
    declarations_ += out.take();
    return name;
  }

  const Material& material(MaterialId id) const {
    return id == no_material ? white_matte_ : scene_.materials[static_cast<std::size_t>(id)];
  }

  void count_uses(const Object& o) {
    if (!o.is_visible || !refers_to_composite(o.shape)) return;
    const bool is_group = o.shape.kind == kind_of<Group>;
    if (++(is_group ? group_uses_ : combination_uses_)[o.shape.index] > 1) return;
    for (const Object& member : parts(scene_.shapes, o.shape)) count_uses(member);
  }

  void comment_origin(Writer& out, std::string_view noun, NameId name, Origin origin) {
    current_ = origin;
    if (!options_.comments) return;
    std::string text(name == no_name ? noun : scene::name(scene_, name));
    if (const std::string place = place_text(scene_, origin); !place.empty()) text += ", " + place;
    out.comment(text);
  }

  const Scene& scene_;
  const ExportOptions options_;
  const Material white_matte_;
  std::vector<std::uint32_t> group_uses_, combination_uses_;
  std::string declarations_;
  std::map<MaterialId, bool> textures_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, MaterialId, bool, bool, bool>, std::string> shared_;
  std::vector<Inexact> inexact_;
  Origin current_;
  std::uint32_t last_id_ = 0;
  bool has_media_ = false; ///< some material requires an index of refraction
  int media_around_eye_ = 0;
  std::vector<Vec3> eyes_;
};

} // namespace

Exported export_povray(const Scene& scene, const ExportOptions& options) {
  require_none(validate(scene));
  return Exporter(scene, options).run();
}

std::string export_geometry(const Scene& scene, const std::string& name) {
  return Exporter(scene, {.pass = Pass::depth, .comments = false}).run_geometry(name);
}

} // namespace rt::tools::povray
