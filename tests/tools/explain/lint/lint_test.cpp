// The rules of the lint that look at a scene's description and its rays. Each has a scene that breaks it and near
// misses.

#include "lang/check/lint/rules.hpp"
#include "tests/paths.hpp"
#include "tools/explain/lint/lint.hpp"
#include "tools/explain/lint/lint_parts.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <filesystem>

using namespace rt;
using namespace rt::tools;

namespace {

struct Linted {
  lang::Loaded loaded;
  std::vector<lang::Diagnostic> warnings;

  /// "W0201 at 2, W0301 at 4"; no line for what is about all.
  std::string codes() const {
    std::string out;
    for (const lang::Diagnostic& d : warnings) {
      out += (out.empty() ? "" : ", ") + d.code;
      if (d.span.begin != d.span.end)
        out += fmt::format(" at {}", loaded.sources.position(d.span.file, d.span.begin).line);
    }
    return out;
  }
  std::string text() const {
    std::string out;
    for (const lang::Diagnostic& d : warnings) out += d.message + " | " + d.label + "\n";
    return out;
  }
};

Linted lint(const std::string& text, const explain::LintOptions& options = {}) {
  lang::LoadOptions load_options;
  load_options.lint = true;
  Linted l{lang::load_text("size: [160, 120]\n" + text, "test.rtl", ".", load_options), {}};
  for (const lang::Diagnostic& d : l.loaded.diagnostics) {
    INFO(d.message);
    CHECK(d.severity != lang::Severity::error);
  }
  l.warnings = explain::lint(l.loaded, options);
  return l;
}

// The first line of the texts below is line 2: the size stands before it.
std::string codes(const std::string& text) {
  return lint(text).codes();
}

const std::string sunlight = "sun { direction: [-1, -2, -1] }\n";
const std::string front = "camera { at: [0, 0, 8] }\n" + sunlight;

} // namespace

TEST_CASE("lint: a camera in a transparent solid sees through its surface") {
  // The box reaches to z = 10, the eye is at 8; then to 7.
  CHECK(codes("box { size: 20, material: glass }\nsphere {}\n" + front) == "W0201 at 4");
  CHECK(lint("pond = box { size: 20, material: glass }\npond\nsphere {}\n" + front).text() ==
        "the camera is inside `pond` (line 2) | everything is seen through its surface\n");
  CHECK(codes("box { size: 14, material: water }\n" + front) == "");
}

TEST_CASE("lint: a camera in an opaque solid is a mistake where it sees nothing else") {
  const std::string ball = "sphere { radius: 9 }\n";
  CHECK(codes(ball + front) == "W0201 at 3");
  CHECK(codes("sphere { radius: 7 }\n" + front) == "");
  CHECK(codes(ball + "box {}\nlight { at: [0, 3, 3] }\ncamera { at: [0, 0, 8] }\n") == ""); // a room
  CHECK(codes(ball + "light { at: [0, 3, 3] }\ncamera { at: [0, 0, 8] }\n") == "");         // an empty one
  // Inside of what is subtracted there is nothing.
  CHECK(codes("box { size: 40 } - box { size: 30 }\nlight { at: [0, 3, 3] }\ncamera { at: [0, 0, 8] }\n") == "");
  CHECK(codes("plane { y: 3 }\nplane { z: -9 }\nlight { at: [0, 2, 0] }\ncamera { at: [0, 0, 8] }\n") == "");
}

TEST_CASE("lint: a light in an opaque solid") {
  const std::string scene = "sphere {}\ncamera { at: [0, 0, 8] }\nlight { at: [3, 3, 3] }\n";
  CHECK(codes(scene + "sphere { at: [3, 3, 3], radius: 0.5 }\n") == "W0202 at 4");
  CHECK(codes(scene + "sphere { at: [3, 3, 3], radius: 0.5, casts_shadow: false }\n") == "");
  CHECK(codes(scene + "sphere { at: [3, 3, 3], radius: 0.5, material: glass }\n") == "");
  CHECK(codes(scene + "sphere { at: [3, 3, 4], radius: 0.5 }\n") == "");
  // A lantern: a hull with the light in its hollow, open above.
  CHECK(codes(scene + "sphere { at: [3, 3, 3], radius: 0.5 } - sphere { at: [3, 3, 3], radius: 0.4 } - plane { normal: "
                      "[1, 1, 1], offset: 7 }\n")
            .find("W0202") == std::string::npos);
  CHECK(lint("sphere {}\ncamera { at: [0, 0, 8] }\nfor x in [-3, 3] { light { at: [x, 3, 3] } }\n"
             "for x in [-3, 3] { sphere { at: [x, 3, 3], radius: 0.5, name: \"shade\" } }\n")
            .text() == "this light is inside `shade` (line 5), which is opaque | no light gets out\n");
}

TEST_CASE("lint: nothing in view, with where it is") {
  // Seen from (0, 0, 8) along -z, the ball's middle at (6, 0, 0) is atan(6/8) = 36.9 degrees to the right; half of the
  // view is 25.
  CHECK(lint("sphere { at: [6, 0, 0] }\n" + front).text() ==
        "nothing is in view | the centre of all things is 37 degrees to the right from the view's centre\n");
  CHECK(codes("sphere { at: [3, 0, 0] }\n" + front) == "");
  CHECK(lint("sphere { at: [0, 9, 0] }\n" + front).text() ==
        "nothing is in view | the centre of all things is 48 degrees up from the view's centre\n"); // atan(9/8) = 48.4
  CHECK(lint("sphere { radius: 0.001, at: [0.03, 0.03, 0] }\n" + front).text() ==
        "nothing is in view | everything is smaller than a pixel\n");
  CHECK(codes("plane { z: 20 }\n" + front) == "W0203 at 3");
  CHECK(codes(front) == "W0203 at 2");               // there is nothing at all
  CHECK(codes(front + "expect 1 + 1 == 2\n") == ""); // a page of questions
}

TEST_CASE("lint: everything is behind the camera") {
  const Linted l = lint("sphere { at: [0, 0, 12] }\n" + front);
  CHECK(l.codes() == "W0204 at 3");
  REQUIRE_FALSE(l.warnings.empty());
  CHECK(l.warnings[0].notes[0].message == "the centre of all things is at [0, 0, 12]: write `look_at: [0, 0, 12]`");
  CHECK(codes("sphere { at: [0, 0, 12] }\nsphere {}\n" + front) == ""); // some things may be behind
}

TEST_CASE("lint: surfaces in one place that look different") {
  const std::string floor = "box { from: [-3, -1, -3], to: [3, 0, 3], material: green }\n";
  const std::string above = "camera { at: [0, 6, 6] }\n" + sunlight;
  const auto with = [&](const std::string& thing) { return codes(floor + thing + "\n" + above); };
  CHECK(with("box { from: [-1, -1, -1], to: [1, 0, 1], material: red }") == "W0205 at 3");
  CHECK(with("disc { radius: 1, material: red }") == "W0205 at 3");
  CHECK(with("disc { radius: 1, at: [0, 0.001, 0], material: red }") == "");
  CHECK(with("box { from: [-1, -1, -1], to: [1, 0, 1], material: green }") == ""); // nobody can tell which is seen
  CHECK(with("box { from: [-1, 0, -1], to: [1, 1, 1], material: red }") == "");    // stands on it: never seen
  CHECK(with("box { from: [3, -1, -3], to: [4, 0, 3], material: red }") == ""); // side by side: only an edge in common
  CHECK(with("sphere { at: [0, 1, 0], material: glass }") == "");               // touches in a point
  CHECK(with("box { from: [-1, 0, -1], to: [1, 1, 1], material: glass }") == ""); // stands on it, and all sees through
  CHECK(with("box { from: [-1, 0.01, -1], to: [1, 1, 1], material: glass }") == "");
  CHECK(codes("sphere { material: red }\nsphere { material: blue }\n" + front) == "W0205 at 3");
  CHECK(codes("sphere { material: red }\nsphere { radius: 1.0001, material: blue }\n" + front) == "W0207 at 2");
}

TEST_CASE("lint: surfaces of one combination may coincide") {
  CHECK(codes("box { size: 2, material: red } | box { size: [2, 1, 2], material: blue }\n" + front) == "");
}

TEST_CASE("lint: a thing smaller than a pixel that no pixel shows") {
  // A pixel is 2·8·tan(25°)/160 = 0.047 wide at the origin; pixel centres lie at odd multiples of half of that: 0.0233.
  const std::string wall = "plane { z: -4 }\n";
  CHECK(codes(wall + "sphere { radius: 0.01 }\n" + front) == "W0206 at 3");
  CHECK(codes(wall + "sphere { radius: 0.01, at: [0.0233, 0.0233, 0] }\n" + front) == ""); // a pixel's centre
  CHECK(codes(wall + "sphere { radius: 0.1 }\n" + front) == "");
  CHECK(codes(wall + "sphere { radius: 0.01, at: [9, 0, 0] }\n" + front) == ""); // not in view
  const std::string tiny = "size: [60, 60]\nplane { z: -4 }\nsphere { radius: 0.01 }\n" + front;
  CHECK(explain::lint(lang::load_text(tiny, "test.rtl", ".", {}), {}).empty()); // hardly a picture
  // Of many, one is seen: the line is fine.
  CHECK(codes(wall + "for x in [0, 1, 2] { sphere { radius: 0.01 + 0.1 * x, at: [x, 0, 0] } }\n" + front) == "");
  CHECK(lint(wall + "for x in 0..9 { sphere { radius: 0.001, at: [0.1 * x, 0, 0] } }\n" + front).warnings[0].message ==
        "each sphere of this line (10 of them) is smaller than a pixel, and no pixel shows it");
}

TEST_CASE("lint: a thing behind an infinite plane, seen from the camera") {
  const std::string scene = "floor = plane { y: -1 }\nfloor\nsphere {}\n" + front;
  CHECK(codes(scene + "sphere { at: [0, -3, 0] }\n") == "W0207 at 7");
  CHECK(codes(scene + "sphere { at: [0, -1.5, 0] }\n") == "");         // its top reaches to -0.5
  CHECK(codes(scene + "sphere { at: [0, -2, 0] }\n") == "W0207 at 7"); // touches it from below
  CHECK(codes(scene + "for y in [-3, 3] { sphere { at: [2, y, 0] } }\n") == "");
  CHECK(codes("plane { y: -1, material: water }\nsphere {}\n" + front + "sphere { at: [0, -3, 0] }\n").find("W0207") ==
        std::string::npos);
}

TEST_CASE("lint: a thing inside of an opaque solid") {
  const std::string hull = "box { size: 2 }\n" + front;
  CHECK(codes(hull + "sphere { radius: 0.9 }\n") == "W0207 at 5");
  CHECK(codes(hull + "sphere { radius: 1.1 }\n") == "");
  CHECK(codes(hull + "sphere { radius: 0.9, at: [0, 0, -3] }\n") == ""); // behind it, not inside
  CHECK(codes("box { size: 2, material: glass }\nsphere { radius: 0.9 }\n" + front) == "");
  CHECK(codes("box { size: 2 } - sphere { radius: 0.95 }\nsphere { radius: 0.9 }\n" + front) ==
        ""); // in a hollow: not inside
  CHECK(codes("sphere { radius: 2 }\nsphere { radius: 1.9 }\n" + front) ==
        "W0207 at 3"); // its box sticks out, it does not
  // A room with the camera in it hides nothing.
  CHECK(codes("box { size: 30 }\nsphere {}\nlight { at: [3, 3, 3] }\nsphere { radius: 0.5, at: [0, 0, -2] }\ncamera { "
              "at: [0, 0, 8] }\n") == "");
}

TEST_CASE("lint: transparent solids that overlap") {
  const auto with = [](const std::string& two) { return codes(two + front); };
  CHECK(with("sphere { material: glass }\nsphere { at: [1, 0, 0], material: water }\n") == "W0208 at 3");
  CHECK(with("sphere { material: glass }\nsphere { at: [2.1, 0, 0], material: water }\n") == "");
  CHECK(with("sphere { material: glass }\nsphere { radius: 0.5, material: water }\n") == ""); // one in the other
  CHECK(with("sphere { material: glass } | sphere { at: [1, 0, 0], material: glass }\n") == "");
  CHECK(with("sphere { material: glass }\nsphere { at: [1, 0, 0] }\n") == "");
  CHECK(with("tint = material { refract: 0.9, ior: 1 }\nsphere { material: tint }\nsphere { at: [1, 0, 0], material: "
             "tint }\n") == "");
}

TEST_CASE("lint: a transform of almost nothing") {
  CHECK(codes("sphere { scale: [1, 1e-7, 1] }\nsphere { at: [0, 2, 0] }\n" + front) == "W0209 at 2");
  CHECK(codes("box { size: 1e8 }.scale(1e-8)\n" + front) == "W0209 at 2"); // as large as the other, but hardly meant
  CHECK(codes("sphere { scale: [1, 0.001, 1] }\nsphere { at: [0, 2, 0] }\n" + front) == "");
  CHECK(codes("for i in 0..3 { sphere { at: [i, 0, 0] } }\n" + front) == "");
}

TEST_CASE("lint: a light that reaches nothing, and why") {
  const std::string scene = "plane { y: -1 }\nsphere {}\ncamera { at: [0, 1, 8] }\n";
  const auto label = [&](const std::string& light) {
    const Linted l = lint(scene + light);
    return l.codes() + ": " + (l.warnings.empty() ? "" : l.warnings[0].label);
  };
  CHECK(label("light { at: [0, -5, 0] }\n") == "W0301 at 5: everything visible faces away from it");
  CHECK(label("spot { at: [0, 5, 0], look_at: [0, 9, 0] }\n") == "W0301 at 5: nothing visible is within its cone");
  CHECK(label("light { at: [0, 5, 5], intensity: 0 }\n") == "W0301 at 5: its `color` or `intensity` is 0");
  CHECK(label("sun { direction: [0, -1, 0] }\nbox { size: [9999, 1, 9999], at: [0, 50, 0], name: \"lid\" }\n") ==
        "W0301 at 5: what line 6 places blocks it");
  CHECK(label("light { at: [0, 5, 5] }\n") == ": ");
  CHECK(label("light { at: [0, 0, -5] }\n") == ": "); // it lights the floor
  // A small spot of light is found by looking closer: at (1, -1, 0), half of 1.5 degrees wide, 6 away: 0.16 across.
  CHECK(label("spot { at: [1, 5, 0], look_at: [1, -1, 0], angle: 1.5 } // lint: allow radians\n") == ": ");
}

TEST_CASE("lint: everything visible is black") {
  CHECK(codes("sphere {}\nambient: 0\ncamera { at: [0, 0, 8] }\n") == "W0302");
  CHECK(codes("sphere {}\nambient: 0\ncamera { at: [0, 0, 8] }\nlight { at: [0, 0, -8] }\n") == "W0301 at 5, W0302");
  CHECK(codes("sphere { material: material { emission: 0.5 } }\nambient: 0\ncamera { at: [0, 0, 8] }\n") == "");
  CHECK(codes("sphere { material: black }\n" + front) == "W0302");
  // sRGB's darkest step but 0 begins at 0.5/255/12.92 = 0.00015.
  CHECK(codes("sphere {}\nambient: 0.001\ncamera { at: [0, 0, 8] }\n") == "");
  CHECK(codes("sphere {}\nambient: 0.0001\ncamera { at: [0, 0, 8] }\n") == "W0302");
}

TEST_CASE("lint: most of what is seen is overexposed") {
  // White, diffuse 0.8, ambient 0.1 and light from the eye: 0.1 + 0.8·i·cos is above 1 where cos > 0.9/(0.8·i). Of the
  // ball's disc (seen from far away) that is the share 1 - (0.9/(0.8·i))²: over a half from i = 1.59 on.
  const auto with = [](double intensity) {
    return codes(fmt::format("sphere {{}}\ncamera {{ at: [0, 0, 800], fov: 0.5 }} // lint: allow radians\nsun {{ "
                             "direction: [0, 0, -1], intensity: {} }}\n",
                             intensity));
  };
  CHECK(with(1.8) == "W0303");
  CHECK(with(1.4) == "");
}

TEST_CASE("lint: rays that end at max_depth and would have counted") {
  const std::string scene = "sphere { radius: 2, material: glass }\nplane { y: -2 }\n" + front;
  CHECK(codes("max_depth: 1\n" + scene) == "W0304 at 3");
  CHECK(codes("max_depth: 9\n" + scene) == "");
  // Between two mirrors of 1/4 the second reflection counts for 1/16, which is below a tenth.
  const std::string mirrors =
      "for x in [-2, 2] { box { size: [0.1, 9, 30], at: [x, 0, 0], material: material { reflect: 0.25 } } }\n" + front;
  CHECK(codes("max_depth: 1\n" + mirrors) == "");
  CHECK(codes("max_depth: 0\n" + mirrors) == "W0304 at 3");
  explain::LintOptions generous;
  generous.depth_share = 100;
  CHECK(lint("max_depth: 1\n" + scene, generous).codes() == "");
}

TEST_CASE("lint: what is allowed is not reported, by comment or by option") {
  CHECK(codes("sphere { radius: 9 }\nsun {}\ncamera { at: [0, 0, 8] } // lint: allow camera_inside\n") == "");
  CHECK(codes("// lint: allow black_picture in this file\nsphere {}\nambient: 0\ncamera { at: [0, 0, 8] }\n") == "");
  explain::LintOptions options;
  options.allowed = {"black_picture"};
  CHECK(lint("sphere {}\nambient: 0\ncamera { at: [0, 0, 8] }\n", options).codes() == "");
}

TEST_CASE("lint: the same for any number of threads") {
  const std::string scene =
      "for x in -3..3 { sphere { at: [x, 0, 0], radius: 0.6, material: glass } }\nmax_depth: 2\n" + front;
  explain::LintOptions one, many;
  one.threads = 1;
  many.threads = 7;
  const Linted a = lint(scene, one), b = lint(scene, many);
  CHECK_FALSE(a.warnings.empty());
  CHECK(lang::render_json(a.warnings, a.loaded.sources) == lang::render_json(b.warnings, b.loaded.sources));
}

TEST_CASE("lint: shapes are numbered as hits number them") {
  const Linted l = lint(
      "group { sphere {}\n box { at: [2, 0, 0] } | box { at: [3, 0, 0] }\n sphere { at: [5, 0, 0], visible: false } }\n"
      "def pair() { sphere { at: [0, 2, 0] }\n sphere { at: [0, 4, 0] } }\npair {}\npair { at: [6, 0, 0] }\n" +
      front);
  const scene::Scene& scene = *l.loaded.scene;
  const RayQuery query(scene);
  int checked = 0;
  CHECK(explain::for_each_leaf(scene, [&](const explain::LintLeaf& leaf) {
    const Vec3 middle = leaf.box.center();
    const auto hit = query.nearest({middle + Vec3{0.01, 0.02, 50}, {0, 0, -1}});
    REQUIRE(hit);
    CHECK(hit->order == leaf.order);
    ++checked;
  }));
  CHECK(checked == 6); // a ball, a union, and twice two balls
}

TEST_CASE("lint: the examples are fine") {
  namespace fs = std::filesystem;
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(RTLANG_SOURCE_DIR) / "examples")) {
    if (entry.path().extension() != ".rtl") continue;
    lang::LoadOptions options;
    options.lint = true;
    const lang::Loaded loaded = lang::load_file(entry.path().string(), options);
    REQUIRE(loaded.scene);
    for (const lang::Diagnostic& d : explain::lint(loaded, {})) FAIL_CHECK(lang::render(d, loaded.sources, false));
    ++count;
  }
  CHECK(count > 30);
}
