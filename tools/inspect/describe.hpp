#pragma once

#include "renderer/scene/names.hpp"
#include "renderer/scene/scene.hpp"
#include "tools/inspect/object_ids.hpp"

#include <type_traits>

/// The traversal of a scene's description shared by its JSON and its hash. Properties come from the field tables of
/// renderer/scene and renderer/shapes: a new one appears automatically, and a new kind of step, paint or light that is
/// not handled here does not compile.
///
/// A `Sink` has begin_object, end_object, begin_array, end_array, key(name), number(double), boolean(bool),
/// string(text) and `has_origins`, which says whether it wants to know where things were written,
/// and by which ids a film knows them.
namespace rt::tools {

template <class Sink>
class Describer {
public:
  Describer(const scene::Scene& scene, Sink& sink) : scene_(scene), sink_(sink) {}

  void scene() {
    sink_.begin_object();
    scene::Settings settings = scene_;
    settings.max_depth = scene::depth_limit(scene_);
    settings.samples = scene::sample_count(scene_);
    fields(scene::fields(&scene_), &settings);
    sink_.key("camera");
    sink_.begin_object();
    fields(scene::fields(&scene_.camera), &scene_.camera);
    origin(scene_.camera_origin);
    sink_.end_object();
    list("lights", scene_.lights, [this](const scene::Light& l) { light(l); });
    list("materials", scene_.materials, [this](const scene::Material& m) {
      sink_.begin_object();
      fields(scene::fields(&m), &m);
      sink_.end_object();
    });
    list("patterns", scene_.patterns, [this](const scene::Pattern& p) { pattern(p); });
    list("groups", scene_.shapes.template all<scene::Group>(), [this](const scene::Group& g) {
      sink_.begin_object();
      list("members", g.members, [this](const scene::Object& o) { object(o); });
      sink_.end_object();
    });
    list("combinations", scene_.shapes.template all<scene::Combination>(), [this](const scene::Combination& c) {
      sink_.begin_object();
      text("operation", noun(c.operation));
      list("operands", c.operands, [this](const scene::Object& o) { object(o); });
      sink_.end_object();
    });
    if constexpr (Sink::has_origins) {
      const ObjectIds ids(scene_);
      std::size_t i = 0;
      list("objects", scene_.objects, [&](const scene::Object& o) { object(o, ids.range(i++)); });
      list("manifest", ids.manifest(), [&](const ObjectIds::NamedRange& named) {
        sink_.begin_object();
        text("name", named.name);
        id_range(named.ids);
        sink_.end_object();
      });
    } else {
      list("objects", scene_.objects, [this](const scene::Object& o) { object(o); });
    }
    sink_.end_object();
  }

private:
  void text(std::string_view key, std::string_view value) {
    sink_.key(key);
    sink_.string(value);
  }
  void number(std::string_view key, double value) {
    sink_.key(key);
    sink_.number(value);
  }
  void vector(const Vec3& v) { numbers({v.x, v.y, v.z}); }
  void vector(std::string_view key, const Vec3& v) {
    sink_.key(key);
    vector(v);
  }
  void color(std::string_view key, const Color& c) {
    sink_.key(key);
    numbers({c.r, c.g, c.b});
  }
  void numbers(std::initializer_list<double> values) {
    sink_.begin_array();
    for (const double value : values) sink_.number(value);
    sink_.end_array();
  }
  template <class T, class F>
  void list(std::string_view key, const std::vector<T>& items, F&& f) {
    sink_.key(key);
    sink_.begin_array();
    for (const T& item : items) f(item);
    sink_.end_array();
  }

  void fields(std::span<const scene::Field> table, const void* owner) {
    for (const scene::Field& field : table) {
      const std::optional<scene::FieldValue> value = field.get(owner);
      if (!value) continue;
      sink_.key(field.name);
      std::visit([&](const auto& v) { this->value(field, v); }, *value);
    }
  }

  void value(const scene::Field&, double v) { sink_.number(v); }
  void value(const scene::Field&, bool v) { sink_.boolean(v); }
  void value(const scene::Field&, const Vec3& v) { vector(v); }
  void value(const scene::Field&, const Color& c) { numbers({c.r, c.g, c.b}); }
  void value(const scene::Field&, const scene::Resolution& r) {
    numbers({static_cast<double>(r[0]), static_cast<double>(r[1])});
  }
  void value(const scene::Field& field, const scene::Choice& c) {
    sink_.string(field.choices[static_cast<std::size_t>(c.index)]);
  }
  void value(const scene::Field&, const std::vector<Vec3>& points) {
    sink_.begin_array();
    for (const Vec3& point : points) vector(point);
    sink_.end_array();
  }
  void value(const scene::Field&, scene::PatternId pattern) {
    sink_.begin_object();
    number("pattern", static_cast<double>(pattern));
    sink_.end_object();
  }
  void value(const scene::Field& field, const scene::Stops& stops) {
    sink_.begin_array();
    for (const scene::Stop& stop : stops) {
      sink_.begin_array();
      sink_.number(stop.place);
      std::visit([&](const auto& shown) { value(field, shown); }, stop.shown);
      sink_.end_array();
    }
    sink_.end_array();
  }
  void value(const scene::Field&, const scene::FunctionRef& function) {
    sink_.begin_array();
    for (const std::string& line : listing(*function)) sink_.string(line);
    sink_.end_array();
  }
  void value(const scene::Field&, const scene::Fade& fade) {
    sink_.begin_object();
    text("law", scene::name(fade.law));
    number("distance", fade.distance);
    sink_.end_object();
  }

  void value(const scene::Field&, const scene::Metal& metal) {
    sink_.begin_object();
    color("n", metal.n);
    color("k", metal.k);
    sink_.end_object();
  }
  void value(const scene::Field&, const scene::Absorb& absorb) {
    sink_.begin_object();
    color("color", absorb.color);
    number("distance", absorb.distance);
    sink_.end_object();
  }

  void members(const scene::ScaleStep& s) { vector("scale", s.factors), vector("about", s.about); }
  void members(const scene::RotateStep& s) { vector("rotate", s.degrees), vector("about", s.about); }
  void members(const scene::RotateAxisStep& s) {
    number("rotate", s.degrees), vector("axis", s.axis), vector("about", s.about);
  }
  void members(const scene::MoveStep& s) { vector("move", s.offset); }
  void members(const scene::ShearStep& s) {
    sink_.key("shear");
    sink_.begin_object();
    number("xy", s.xy), number("xz", s.xz), number("yx", s.yx), number("yz", s.yz), number("zx", s.zx),
        number("zy", s.zy);
    sink_.end_object();
    vector("about", s.about);
  }
  void members(const scene::MirrorStep& s) { vector("mirror", s.normal), vector("about", s.about); }
  void members(const scene::MatrixStep& s) {
    sink_.key("matrix");
    sink_.begin_array(); // four columns: the images of x, y and z, and the translation
    for (const Vec3* column : {&s.matrix.x, &s.matrix.y, &s.matrix.z, &s.matrix.translation}) vector(*column);
    sink_.end_array();
  }

  void chain(const std::vector<scene::Step>& steps) {
    if (steps.empty()) return;
    list("chain", steps, [this](const scene::Step& step) {
      sink_.begin_object();
      std::visit([this](const auto& s) { this->members(s); }, step);
      sink_.end_object();
    });
  }
  void placement(const scene::Placement& p) {
    vector("scale", p.scale), vector("rotate", p.rotate), vector("at", p.at);
    chain(p.chain);
  }

  void name(scene::NameId id) {
    if (id != scene::no_name) text("name", scene::name(scene_, id));
  }
  void origin(const scene::Origin& from) {
    if constexpr (Sink::has_origins) {
      if (from.line == 0 || from.file >= scene_.files.size()) return;
      text("file", scene_.files[from.file]);
      number("line", from.line);
    }
  }

  void light(const scene::Light& l) {
    sink_.begin_object();
    text("light", noun(l.source));
    std::visit([this](const auto& source) { fields(scene::fields(&source), &source); }, l.source);
    chain(l.chain);
    if (!l.enclosing.empty()) {
      list("enclosing", l.enclosing, [this](const scene::Placement& p) {
        sink_.begin_object();
        placement(p);
        sink_.end_object();
      });
    }
    name(l.name);
    origin(l.origin);
    sink_.end_object();
  }

  void pattern(const scene::Pattern& p) {
    sink_.begin_object();
    text("pattern", noun(p.layout));
    std::visit([this](const auto& layout) { fields(scene::fields(&layout), &layout); }, p.layout);
    placement(p.placement);
    sink_.end_object();
  }

  void id_range(ObjectIds::Range ids) {
    if (ids.first == ids.last) return number("id", static_cast<double>(ids.first));
    if (ids.last < ids.first) return;
    sink_.key("ids");
    numbers({static_cast<double>(ids.first), static_cast<double>(ids.last)});
  }

  void object(const scene::Object& o, ObjectIds::Range ids = {1, 0}) {
    sink_.begin_object();
    scene_.shapes.visit(o.shape, [&](const auto& shape) {
      using Shape = std::decay_t<decltype(shape)>;
      text("shape", Shape::noun);
      // Groups and combinations may be shared: they stand in lists of their own.
      if constexpr (scene::is_composite<Shape>)
        number("index", o.shape.index);
      else
        fields(scene::fields(&shape), &shape);
    });
    if (o.transform != scene::no_transform)
      placement(scene::placement(scene_, o));
    else
      vector("at", o.at);
    if (o.material != scene::no_material) number("material", static_cast<double>(o.material));
    name(o.name);
    if (!o.is_visible) sink_.key("visible"), sink_.boolean(false);
    if (!o.casts_shadow) sink_.key("casts_shadow"), sink_.boolean(false);
    id_range(ids);
    origin(o.origin);
    sink_.end_object();
  }

  const scene::Scene& scene_;
  Sink& sink_;
};

} // namespace rt::tools
