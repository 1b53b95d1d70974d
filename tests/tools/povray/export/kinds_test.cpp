// Every kind of thing that there is has its text for POV-Ray.

#include "tests/support/scenes.hpp"
#include "tools/povray/export/export_parts.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace rt;
using namespace rt::tests;
using namespace rt::tools::povray;
using Catch::Contains;

namespace {

template <class S>
concept HasInside = requires(const S& shape, const Vec3& point) {
  { holds(shape, point) } -> std::same_as<bool>;
};

// A shape that was added and forgotten does not compile.
struct NewSolid {};
static_assert(!HasInside<NewSolid>);

} // namespace

TEST_CASE("export: every shape that is no composite has an inside, or says that it has none") {
  scene::ShapeKinds::for_each([]<class S>() {
    if constexpr (!scene::is_composite<S>) static_assert(HasInside<S>);
  });
  // The middle of a solid is inside.
  CHECK(holds(scene::Sphere{}, {}));
  CHECK(holds(scene::Box{}, {}));
  CHECK(holds(scene::Cylinder{}, {}));
  CHECK(holds(scene::Cone{}, {0, 0.1, 0}));
  CHECK(holds(scene::Plane{}, {0, -1, 0}));
  CHECK(holds(scene::Disc{}, {0, -1, 0}));
  CHECK_FALSE(holds(scene::Triangle{}, {}));
  CHECK_FALSE(holds(scene::Quad{}, {}));
  CHECK_FALSE(holds(scene::Polygon{}, {}));
}

TEST_CASE("export: every light is written, under its own name") {
  scene::LightKinds::for_each([]<class L>() {
    WrittenScene b;
    b.light(L{});
    const std::string text = export_povray(b.scene, {}).text;
    const char* const written = std::is_same_v<L, scene::SkyLight> ? "sky_sphere {" : "light_source {";
    CHECK_THAT(text, Contains("// " + std::string(L::noun)) && Contains(written));
  });
}

TEST_CASE("export: every pattern is written, as pigments where it is a colour and else as textures") {
  scene::PatternKinds::for_each([]<class P>() {
    const scene::Material plain;
    for (const scene::Field& field : fields(&plain)) {
      if (!field.is_textured) continue;
      INFO(std::string(P::noun) + " on " + std::string(field.name));
      WrittenScene b;
      P layout;
      for (const scene::Field& part : fields(&layout)) // 0.5 is within what every property takes
        if (part.is_textured)
          part.set(&layout, grey(0.5));
        else if (part.type == scene::FieldType::stops)
          part.set(&layout, scene::Stops{{0.25, grey(0.5)}, {0.75, grey(0.5)}});
      const auto pattern = b.pattern({layout, {}});
      scene::Material m;
      field.set(&m, pattern);
      b.place(scene::Sphere{1}, b.material(m));
      const tools::povray::Exported exported = export_povray(b.scene, {.comments = false});
      const bool is_computed = std::is_same_v<P, scene::FunctionPattern>, is_mixed = is_computed || scene::IsGraded<P>;
      const bool has_no_way =
          is_mixed && (field.name == "shininess" || field.name == "roughness"); // numbers in POV-Ray
      // Which POV-Ray does not have, unless bumps are level.
      const bool has_none = field.name == "coat" || (is_computed && field.name == "bump");
      CHECK(exported.inexact.empty() == !(has_no_way || has_none));
      if ((is_computed && (has_no_way || has_none)) || field.name == "bump") continue;
      if (field.name == "color")
        CHECK_THAT(exported.text, Contains("pigment {\n    "));
      else
        CHECK_THAT(exported.text, Contains("texture_map {") || Contains("texture {\n    pigment"));
    }
  });
}
