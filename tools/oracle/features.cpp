#include "tools/oracle/features.hpp"

#include "renderer/scene/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rt::tools::oracle {
namespace {

using namespace rt::scene;

bool same(const FieldValue& a, const FieldValue& b) {
  return a == b;
}

// Features that are not properties: found by inspection.
const std::vector<std::string> structures{"group",
                                          "union",
                                          "intersection",
                                          "difference",
                                          "solid in a solid",
                                          "half-space in a solid",
                                          "shared group",
                                          "group in a group",
                                          "scale",
                                          "scale, one factor",
                                          "mirrored by scale",
                                          "rotate",
                                          "step about a point",
                                          "material inherited",
                                          "material of a solid's part",
                                          "pattern in a pattern",
                                          "pattern placed",
                                          "transparent",
                                          "transparent solid",
                                          "two transparent",
                                          "no shadow",
                                          "name",
                                          "light in a group",
                                          "light with a chain",
                                          "fade linear",
                                          "fade quadratic",
                                          "fade inverse_square",
                                          "several lights"};

template <class T>
void add_field_names(std::vector<std::string>& names, const std::string& noun) {
  for (const Field& f : fields(static_cast<const T*>(nullptr))) names.push_back(fmt::format("{}.{}", noun, f.name));
}

class Finder {
public:
  explicit Finder(const Scene& scene) : scene_(scene) {}

  std::set<std::string> run() {
    written(fields(&scene_), &scene_, Scene{}, "scene");
    written(fields(&scene_.camera), &scene_.camera, Camera{}, "camera");
    for (const Light& light : scene_.lights) this->light(light);
    if (scene_.lights.size() > 1) found_.insert("several lights");
    for (const Object& o : scene_.objects) object(o, no_material, 0, false);
    for (const auto& [shape, uses] : uses_)
      if (uses > 1) found_.insert("shared group");
    if (transparent_ > 1) found_.insert("two transparent");
    return std::move(found_);
  }

private:
  template <class T>
  void written(std::span<const Field> table, const void* owner, const T& plain, const std::string& noun) {
    for (const Field& f : table) {
      const auto value = f.get(owner), usual = f.get(&plain);
      if (value && (!usual || !same(*value, *usual))) found_.insert(fmt::format("{}.{}", noun, f.name));
    }
  }

  void light(const Light& light) {
    found_.emplace(noun(light.source));
    std::visit(
        [&]<class L>(const L& source) {
          written(fields(&source), &source, L{}, std::string(L::noun));
          if constexpr (requires { source.fade; })
            if (source.fade.law != Fade::Law::none) found_.insert(fmt::format("fade {}", name(source.fade.law)));
        },
        light.source);
    if (!light.enclosing.empty()) found_.insert("light in a group");
    if (!light.chain.empty()) found_.insert("light with a chain");
  }

  void object(const Object& o, MaterialId inherited, int depth, bool in_solid) {
    if (!o.is_visible) return;
    if (!o.casts_shadow) found_.insert("no shadow");
    if (o.name != no_name) found_.insert("name");
    if (o.transform != no_transform) placement(scene_.transforms[static_cast<std::size_t>(o.transform)]);
    const MaterialId id = o.material != no_material ? o.material : inherited;
    if (o.material != no_material) {
      material(scene_.materials[static_cast<std::size_t>(o.material)]);
      if (in_solid) found_.insert("material of a solid's part");
    } else if (inherited != no_material)
      found_.insert("material inherited");
    scene_.shapes.visit(o.shape, [&](const auto& shape) { this->shape(shape, o, id, depth, in_solid); });
  }

  void shape(const Group& g, const Object& o, MaterialId id, int depth, bool in_solid) {
    found_.insert("group");
    if (depth > 0) found_.insert("group in a group");
    ++uses_[o.shape.index];
    for (const Object& member : g.members) object(member, id, depth + 1, in_solid);
  }

  void shape(const Combination& c, const Object&, MaterialId id, int depth, bool in_solid) {
    found_.emplace(noun(c.operation));
    if (in_solid) found_.insert("solid in a solid");
    if (is_clear(id)) found_.insert("transparent solid");
    for (const Object& operand : c.operands) object(operand, id, depth + 1, true);
  }

  template <class S>
  void shape(const S& s, const Object&, MaterialId id, int, bool in_solid) {
    found_.insert(std::string(S::noun));
    written(fields(&s), &s, S{}, std::string(S::noun));
    if (std::is_same_v<S, Plane> && in_solid) found_.insert("half-space in a solid");
    if (!is_clear(id)) return;
    found_.insert("transparent");
    ++transparent_;
  }

  bool is_clear(MaterialId id) const {
    return id != no_material && !is_opaque(scene_.materials[static_cast<std::size_t>(id)]);
  }

  void material(const Material& m) {
    written(fields(&m), &m, Material{}, "material");
    for (const Field& field : fields(&m))
      for_each_pattern({&field, 1}, &m, [&](PatternId id) {
        found_.insert(fmt::format("pattern {}", field.name));
        pattern(id);
      });
  }

  void pattern(PatternId id) {
    const Pattern& p = scene_.patterns[static_cast<std::size_t>(id)];
    const Placement& place = p.placement;
    if (place.scale != Vec3{1, 1, 1} || place.rotate != Vec3{} || place.at != Vec3{}) found_.insert("pattern placed");
    std::visit(
        [&]<class P>(const P& layout) {
          found_.emplace(P::noun);
          written(fields(&layout), &layout, P{}, std::string(P::noun));
          for_each_pattern(fields(&layout), &layout, [&](PatternId inner) {
            found_.insert("pattern in a pattern");
            pattern(inner);
          });
        },
        p.layout);
  }

  void placement(const Placement& p) {
    if (p.scale != Vec3{1, 1, 1})
      found_.insert(p.scale.x == p.scale.y && p.scale.y == p.scale.z ? "scale, one factor" : "scale");
    if (p.scale.x * p.scale.y * p.scale.z < 0) found_.insert("mirrored by scale");
    if (p.rotate != Vec3{}) found_.insert("rotate");
    for (const Step& step : p.chain) {
      found_.insert(fmt::format("step {}", noun(step)));
      std::visit(
          [&](const auto& s) {
            if constexpr (requires { s.about; })
              if (s.about != Vec3{}) found_.insert("step about a point");
          },
          step);
    }
  }

  const Scene& scene_;
  std::set<std::string> found_;
  std::map<std::uint32_t, int> uses_;
  int transparent_ = 0;
};

} // namespace

std::vector<std::string> feature_names() {
  std::vector<std::string> names;
  ShapeKinds::for_each([&]<class S>() {
    if constexpr (!is_composite<S>) {
      names.emplace_back(S::noun);
      add_field_names<S>(names, std::string(S::noun));
    }
  });
  add_field_names<Material>(names, "material");
  for (const Field& f : fields(static_cast<const Material*>(nullptr)))
    if (f.is_textured) names.push_back(fmt::format("pattern {}", f.name));
  PatternKinds::for_each([&]<class P>() {
    names.emplace_back(P::noun);
    add_field_names<P>(names, std::string(P::noun));
  });
  LightKinds::for_each([&]<class L>() {
    names.emplace_back(L::noun);
    add_field_names<L>(names, std::string(L::noun));
  });
  add_field_names<Camera>(names, "camera");
  add_field_names<Scene>(names, "scene");
  StepKinds::for_each([&]<class S>() { names.push_back(fmt::format("step {}", S::noun)); });
  for (const std::string& structure : structures) names.push_back(structure);
  return names;
}

std::vector<std::size_t> features_of(const Scene& scene) {
  const std::set<std::string> found = Finder(scene).run();
  const std::vector<std::string> names = feature_names();
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (found.count(names[i])) numbers.push_back(i);
  return numbers;
}

Coverage::Coverage() : names_(feature_names()), pairs_(names_.size() * names_.size()) {}

void Coverage::add(const std::vector<std::size_t>& features) {
  for (const std::size_t a : features)
    for (const std::size_t b : features) ++pairs_[a * names_.size() + b];
}

void Coverage::add(const Coverage& other) {
  for (std::size_t i = 0; i < pairs_.size(); ++i) pairs_[i] += other.pairs_[i];
}

std::vector<std::string> Coverage::missing(const std::vector<std::string>& without) const {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const bool may_miss =
        std::any_of(without.begin(), without.end(), [&](const std::string& p) { return names_[i].rfind(p, 0) == 0; });
    if (count(i) == 0 && !may_miss) result.push_back(names_[i]);
  }
  return result;
}

std::string Coverage::report(bool all_pairs) const {
  std::string text = "feature                              scenes\n";
  for (std::size_t i = 0; i < names_.size(); ++i) text += fmt::format("  {:<34} {:>6}\n", names_[i], count(i));
  std::size_t pairs = 0, met = 0;
  std::string lines;
  for (std::size_t a = 0; a < names_.size(); ++a)
    for (std::size_t b = a + 1; b < names_.size(); ++b) {
      ++pairs;
      met += count(a, b) > 0;
      if (all_pairs) lines += fmt::format("  {} + {}: {}\n", names_[a], names_[b], count(a, b));
    }
  return text + fmt::format("pairs of features: {} of {} occurred together\n", met, pairs) + lines;
}

} // namespace rt::tools::oracle
