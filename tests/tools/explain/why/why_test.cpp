// The numbers of an explanation against derivations by hand.

#include "tests/tools/explain/why/explained.hpp"

#include <cmath>

using namespace rt;
using namespace rt::tests;
using namespace rt::tools;

TEST_CASE("why: a sphere's quadratic, its discriminant and both roots") {
  // o = 0, d = +x, C = (2, 0, 0), r = 1: a = 1, b = 2·d·(o − C) = −4, c = 4 − 1 = 3, b² − 4ac = 16 − 12 = 4, t = (4 ∓
  // 2) / 2.
  const auto asked = along("sphere { at: [2, 0, 0] }", {0, 0, 0}, {1, 0, 0});
  const json d = derivation_of(*asked);
  CHECK(d["quantities"]["a"] == 1);
  CHECK(d["quantities"]["b"] == -4);
  CHECK(d["quantities"]["c"] == 3);
  CHECK(d["quantities"]["discriminant"] == 4);
  CHECK(d["quantities"]["t1"] == 1);
  CHECK(d["quantities"]["t2"] == 3);
  CHECK(d["t"] == 1);
  CHECK(d["disagreement"] == 0);
  CHECK(contains(text_of(*asked), "t₁ is taken, the nearest ahead"));
}

TEST_CASE("why: from inside a sphere the farther root is taken, and it says why") {
  // r = 4 about the origin: c = −16, roots ±4.
  const auto asked = along("sphere { radius: 4 }", {0, 0, 0}, {1, 0, 0});
  const json d = derivation_of(*asked);
  CHECK(d["quantities"]["t1"] == -4);
  CHECK(d["t"] == 4);
  CHECK(d["choice"] == "t₁ is behind the ray's origin, so t₂ is taken");
  CHECK(contains(text_of(*asked), "< 0: the ray starts inside"));
}

TEST_CASE("why: a direction of any length is made a unit vector, so that t is the distance") {
  // (0, 0, 0) + t (1, 1, 1) meets the sphere about (1, 1, 0.8) of radius 1 at t = 0.363733 and 1.502934 of its lengths
  // √3: 3t² − 5.6t + 1.64 = 0.
  const auto asked = along("sphere { at: [1, 1, 0.8] }", {0, 0, 0}, {1, 1, 1});
  const json d = derivation_of(*asked);
  CHECK(d["quantities"]["t1"].get<double>() == Approx((5.6 - std::sqrt(5.6 * 5.6 - 12 * 1.64)) / 6 * std::sqrt(3.0)));
  CHECK(d["quantities"]["t2"].get<double>() == Approx(1.502934 * std::sqrt(3.0)).epsilon(1e-6));
}

TEST_CASE("why: a scaled sphere is met in its own space, where t is the same") {
  // An ellipsoid with half axes 2, 1, 1: in its own space the ray (−3, 0, 0) + t (0.5, 0, 0) meets the unit sphere at
  // 0.25t² − 3t + 8 = 0: t = 4 and 8.
  const auto asked = along("sphere { scale: [2, 1, 1] }", {-6, 0, 0}, {1, 0, 0});
  const json d = derivation_of(*asked);
  CHECK(d["own_space"] == true);
  CHECK(d["ray"]["origin"] == json({-3.0, 0.0, 0.0}));
  CHECK(d["ray"]["direction"] == json({0.5, 0.0, 0.0}));
  CHECK(d["quantities"]["a"] == 0.25);
  CHECK(d["quantities"]["b"] == -3);
  CHECK(d["quantities"]["c"] == 8);
  CHECK(d["t"] == 4);
}

TEST_CASE("why: a plane's numerator and denominator") {
  // The point (2, 0, 0) and the normal (−1, 0, 0): k = −2; from the origin along +x: (k − N·o) / (N·d) = −2 / −1.
  const json d = derivation_of(*along("plane { normal: [-1, 0, 0], offset: -2 }", {0, 0, 0}, {1, 0, 0}));
  CHECK(d["quantities"]["numerator"] == -2);
  CHECK(d["quantities"]["denominator"] == -1);
  CHECK(d["t"] == 2);
}

TEST_CASE("why: a cylinder's projected ray, the heights of its roots and the tests of its ends") {
  // Upright, radius 1, from y = 0 to 2. From (−3, 1, 0) along +x: o⊥ = (−3, 0, 0), a = 1, b = −6, c = 8, t = 2 and 4 at
  // height 1.
  const char* const bar = "cylinder { from: [0, 0, 0], to: [0, 2, 0] }";
  const json side = derivation_of(*along(bar, {-3, 1, 0}, {1, 0, 0}));
  CHECK(side["quantities"]["o_across"] == json({-3.0, 0.0, 0.0}));
  CHECK(side["quantities"]["b"] == -6);
  CHECK(side["quantities"]["c"] == 8);
  CHECK(side["quantities"]["h1"] == 1);
  CHECK(side["t"] == 2);
  // From above, half-way to the side: a = 0, the top (y = 2) is 3 below the origin, the base 5.
  const auto down = along(bar, {0.5, 5, 0}, {0, -1, 0});
  const json end = derivation_of(*down);
  CHECK(end["quantities"]["a"] == 0);
  CHECK(end["quantities"]["t_top"] == 3);
  CHECK(end["quantities"]["t_base"] == 5);
  CHECK(end["quantities"]["distance_top"] == 0.5);
  CHECK(end["choice"] == "the other end is taken, the nearest ahead");
  CHECK(contains(text_of(*down), "a = d⊥·d⊥ = 0"));
  // Slanting in through the open top: (0, 3, 0) along (3, −4, 0)/5 passes y = 2 at t = 1.25, 0.75 off the axis, and
  // meets the side at x = 1, t = 5/3, y = 3 − 4/3 = 5/3.
  const auto open = along("cylinder { from: [0, 0, 0], to: [0, 2, 0], open: true }", {0, 3, 0}, {3, -4, 0});
  const json inside = derivation_of(*open);
  CHECK(inside["quantities"]["t_top"].get<double>() == Approx(1.25));
  CHECK(inside["quantities"]["distance_top"].get<double>() == Approx(0.75));
  CHECK(inside["quantities"]["h2"].get<double>() == Approx(5.0 / 3));
  CHECK(inside["t"].get<double>() == Approx(5.0 / 3));
  CHECK(contains(text_of(*open), "it is open there: no disc"));
}

TEST_CASE("why: a cone's quadratic") {
  // Radius 1 at y = 0, a point at y = 1: |across| = 1 − y. At y = 0.5 the radius is 0.5: from x = −2 t = 1.5 and 2.5;
  // a = 1, b = −4, c = 4 − 0.25.
  const json d = derivation_of(*along("cone {}", {-2, 0.5, 0}, {1, 0, 0}));
  CHECK(d["quantities"]["rho"] == 0.5);
  CHECK(d["quantities"]["a"] == 1);
  CHECK(d["quantities"]["b"] == -4);
  CHECK(d["quantities"]["c"] == 3.75);
  CHECK(d["t"] == 1.5);
  // Parallel to a line of the side, (1, −1)/√2: a = 0, one root. From (−2, 1, 0)… the side in the plane z = 0 is y = 1
  // − |x|; x + 2 = 1 − y and y = 1 + x meet at x = −1, y = 0: the rim; shifted up by 0.5 at x = −0.75, y = 0.25.
  const json parallel = derivation_of(*along("cone {}", {-2, 1.5, 0}, {1, -1, 0}));
  CHECK(parallel["quantities"]["t1"].get<double>() == Approx(1.25 * std::sqrt(2.0)));
}

TEST_CASE("why: a box's slabs") {
  // From (−3, 0.25, 0) along (4, 1, 0)/5·…: the slab of x, −1 to 1, from t = 2·√17/4 to 4·√17/4; y from −1.25 to 0.75
  // times √17.
  const json d = derivation_of(*along("box { size: 2 }", {-3, 0.25, 0}, {4, 1, 0}));
  const double unit = std::sqrt(17.0);
  CHECK(d["quantities"]["near_x"].get<double>() == Approx(0.5 * unit));
  CHECK(d["quantities"]["far_x"].get<double>() == Approx(unit));
  CHECK(d["quantities"]["far_y"].get<double>() == Approx(0.75 * unit));
  CHECK(d["quantities"]["leave"].get<double>() == Approx(0.75 * unit)); // out by the top
  CHECK(d["t"].get<double>() == Approx(0.5 * unit));
}

TEST_CASE("why: a triangle's inside test and the corners' weights") {
  // Corners (0,0,0), (1,0,0), (0,1,0); N = (0, 0, 1). At (0.2, 0.3, 0) the areas over the edges are 0.3, 0.5, 0.2.
  const json d = derivation_of(*along("triangle { points: [[0,0,0], [1,0,0], [0,1,0]] }", {0.2, 0.3, 2}, {0, 0, -1}));
  CHECK(d["quantities"]["numerator"] == -2);
  CHECK(d["quantities"]["denominator"] == -1);
  CHECK(d["quantities"]["side1"].get<double>() == Approx(0.3));
  CHECK(d["quantities"]["side2"].get<double>() == Approx(0.5));
  CHECK(d["quantities"]["side3"].get<double>() == Approx(0.2));
  CHECK(d["quantities"]["weights"].at(0).get<double>() == Approx(0.5)); // of the first corner
  CHECK(d["t"] == 2);
}

TEST_CASE("why: squares by their edges, polygons by counting crossings, discs by their distance") {
  const auto square = along("quad { normal: [0, 0, 1], size: 2 }", {0.5, 0, 3}, {0, 0, -1});
  CHECK(contains(text_of(*square), "none is negative, so P is inside of all four edges"));
  // An L: (0.5, 1.5) lies in its upright part. To the right of it there is one edge, x = 1.
  const auto bent =
      along("polygon { points: [[0,0,0], [2,0,0], [2,1,0], [1,1,0], [1,2,0], [0,2,0]] }", {0.5, 1.5, 3}, {0, 0, -1});
  CHECK(derivation_of(*bent)["quantities"]["crossings"] == 1);
  CHECK(contains(text_of(*bent), "odd: P is inside"));
  const auto ring = along("disc { normal: [0, 0, 1], radius: 2, hole: 1 }", {0, 1.5, 3}, {0, 0, -1});
  CHECK(derivation_of(*ring)["quantities"]["distance"] == 1.5);
}

TEST_CASE("why: a difference is shown as intervals of the line, and a cut surface faces the other way") {
  // A box from z = −1 to 1 less a ball of radius 0.5 about (0, 0, 1): from z = 5 down, the box is [4, 6], the ball
  // [3.5, 4.5].
  const auto asked = along("box { size: 2 } - sphere { radius: 0.5, at: [0, 0, 1] }", {0, 0, 5}, {0, 0, -1});
  const json c = surface_of(*asked)["combination"];
  CHECK(c["operation"] == "difference");
  CHECK(c["operands"][0]["inside"] == json::array({json({4.0, 6.0})}));
  CHECK(c["operands"][1]["inside"] == json::array({json({3.5, 4.5})}));
  CHECK(c["inside"] == json::array({json({4.5, 6.0})}));
  CHECK(surface_of(*asked)["t"] == 4.5);
  CHECK(contains(text_of(*asked), "which is subtracted: its normal is flipped"));
  CHECK(contains(text_of(*asked), "t₁ is not on the surface of the combination, so t₂ is taken"));
}

TEST_CASE("why: parts that lie in each other leave no intervals of rounding") {
  const double c = std::sqrt(0.75), s = 0.5; // of 30°
  const auto tilted = [&](const Vec3& v) { return Vec3{v.x, v.y * c - v.z * s, v.y * s + v.z * c}; };
  for (int i = 0; i < 40; ++i) {
    // Down through the block's top, the hole's wall, and out by the hole's lower end, which lies in the block's.
    const auto asked = along("(box { from: [-1, 0, -1], to: [1, 1, 1] }.rotate(y: 10) "
                             "- cylinder { from: [0, 0, 0], to: [0, 1, 0], radius: 0.6 }.rotate(y: 37)).rotate(x: 30)",
                             tilted({1.15, 3, 0.01 * i - 0.2}), normalize(tilted({-0.2, -1, 0})));
    const json inside = surface_of(*asked)["combination"]["inside"];
    REQUIRE(inside.size() == 1);
    REQUIRE(inside[0][0].get<double>() == Approx(2 * std::sqrt(1.04))); // 2 down, and 0.4 aside
  }
}

TEST_CASE("why: each term of the shading equation has its numbers") {
  // A white floor, a lamp of colour 2 straight above at height 3 with fade quadratic(3): 1 / (1 + 1) = 0.5. With
  // ambient 0.1: 0.1 + 2·0.5·0.8·1 = 0.9. The highlight, specular 0.5, from 45°: h is half-way, 22.5° off:
  // 0.5·cos(22.5°)^10.
  const auto asked = along("ambient: 0.1\nplane { y: 0, material: material { specular: 0.5, shininess: 10 } }\n"
                           "light { at: [0, 3, 0], intensity: 2, fade: quadratic(3) }",
                           {-1, 1, 0}, {1, -1, 0});
  const json light = surface_of(*asked)["lights"].at(0);
  CHECK(light["distance"] == 3);
  CHECK(light["fade"] == 0.5);
  CHECK(light["n_dot_l"].get<double>() == Approx(1));
  CHECK(light["diffuse"].at(0).get<double>() == Approx(0.8));
  const double h = std::cos(22.5 * 3.14159265358979323846 / 180);
  CHECK(light["highlight_cosine"].get<double>() == Approx(h));
  CHECK(light["highlight"].at(0).get<double>() == Approx(0.5 * std::pow(h, 10)));
  CHECK(surface_of(*asked)["ambient"].at(0).get<double>() == Approx(0.1));
  CHECK(contains(text_of(*asked), "nothing is in the way"));
}

TEST_CASE("why: what stands in the light is named with its line and distance, and what dims it with its filter") {
  // Above the floor at x = 0: a pane of refract 0.5 at y = 1 and an opaque board at y = 2; the lamp is the sun from
  // above.
  const std::string floor = "ambient: 0\nplane { y: 0 }\nsun { direction: [0, -1, 0] }\n";
  const std::string pane = "pane = quad { size: 1, at: [0, 1, 0], material: material { refract: 0.5 } }\npane\n";
  const auto dimmed = along(floor + pane, {3, 3, 0}, {-1, -1, 0});
  const json light = surface_of(*dimmed)["lights"].at(0);
  CHECK(light["filter"] == json({0.5, 0.5, 0.5}));
  CHECK(light["in_the_way"].at(0)["distance"].get<double>() == Approx(1));
  CHECK(light["in_the_way"].at(0)["objects"].at(0)["name"] == "pane");
  CHECK(surface_of(*dimmed)["lights"].at(0)["diffuse"].at(0).get<double>() == Approx(0.4));
  const auto blocked = along(floor + pane + "board = quad { size: 1, at: [0, 2, 0] }\nboard\n", {3, 3, 0}, {-1, -1, 0});
  CHECK(contains(text_of(*blocked), "`board` (line 6) blocks it at distance 2"));
  CHECK(explain::verdict(blocked->answer) == "black because `board` (line 6) blocks sun (line 3), and ambient is 0");
}

TEST_CASE("why: refraction has Snell's angles, and total internal reflection the critical one") {
  // Into glass of 1.5 at 45°: sin θ₂ = 0.70711 / 1.5 = 0.47140, 28.13°. Out of it at 45°: 1.06 > 1, critical
  // angle 41.81°.
  const std::string glass =
      "ambient: 0.1\nbox { from: [-9, -9, -9], to: [9, 0, 9], material: material { refract: 0.9, ior: 1.5 } }\n";
  const auto in = along(glass, {-1, 1, 0}, {1, -1, 0});
  const json transition = surface_of(*in)["passage"];
  CHECK(transition["passage"]["kind"] == "entering");
  CHECK(transition["angle"].get<double>() == Approx(45));
  CHECK(transition["angle_behind"].get<double>() == Approx(28.1255057));
  CHECK(contains(text_of(*in), "45.00° becomes 28.13°"));
  const auto out = along(glass, {-1, -1, 0}, {1, 1, 0});
  CHECK(contains(text_of(*out), "45.00° is beyond the critical angle of 41.81°"));
  CHECK(contains(text_of(*out), "ior 1.5 to 1"));
}

TEST_CASE("why: Fresnel's reflectance at right angles is ((n − 1) / (n + 1))²") {
  const auto asked =
      along("sphere { material: material { reflect: 1, refract: 1, ior: 1.5, fresnel: true } }", {0, 0, 5}, {0, 0, -1});
  CHECK(surface_of(*asked)["mirror"]["fresnel"].get<double>() == Approx(0.04));
  CHECK(surface_of(*asked)["mirror"]["weight"].at(0).get<double>() == Approx(0.04));
  CHECK(surface_of(*asked)["passage"]["weight"].at(0).get<double>() == Approx(0.96));
}

TEST_CASE("why: surfaces that touch are shown as one event, each with its part in it") {
  // Glass on water from y = -1 to 0: light goes from one to the other, and the rest is glass's water-side, unbent.
  const auto asked = along("background: 0.5\n"
                           "box { from: [-9, -2, -9], to: [9, -1, 9], material: material { refract: 0.9, ior: 1.25, "
                           "diffuse: 0, ambient: 0 } }\n"
                           "box { from: [-9, -1, -9], to: [9, 0, 9], material: material { refract: 0.8, ior: 1.5, "
                           "diffuse: 0, ambient: 0 } }\n",
                           {0, 3, 0}, {0, -1, 0});
  const json in_glass = surface_of(*asked)["passage"]["ray"]["surfaces"];
  REQUIRE(in_glass.at(0)["touching"].size() == 2);
  CHECK(in_glass.at(0)["passage"]["passage"]["kind"] == "entering");
  CHECK(in_glass.at(0)["passage"]["passage"]["ior_from"] == 1.5);
  CHECK(in_glass.at(0)["passage"]["passage"]["ior_to"] == 1.25);
  const json in_water = in_glass.at(0)["passage"]["ray"]["surfaces"];
  CHECK_FALSE(in_water.at(0).contains("touching")); // it has been said
  CHECK(in_water.at(0)["passage"]["passage"]["kind"] == "leaving_outer");
  CHECK(in_water.at(0)["t"] == in_glass.at(0)["t"]);
  // Every solid filters twice.
  CHECK(asked->answer.sum.total.r == Approx(0.8 * 0.8 * 0.9 * 0.9 * 0.5).epsilon(1e-12));
  CHECK(contains(text_of(*asked), "hits 2 coincident surfaces, closer to each other than rounding can tell: box "
                                  "(line 2) and box (line 3)"));
}

TEST_CASE("why: it ends in a plain sentence") {
  const std::string lit = "sun { direction: [0, 0, -1] }\nambient: 0.1\n";
  CHECK(sentence_of("background: skyblue") == "this is the background: the ray hits nothing");
  CHECK(sentence_of("background: black") == "black because the ray hits nothing, and the background is black");
  CHECK(sentence_of(lit + "ball = sphere {}\nball") ==
        "`ball` (line 3) is lit by sun (line 1) (89 %) and ambient light (11 %)");
  CHECK(sentence_of("ambient: 0\nsun { direction: [0, 0, 1] }\nsphere {}") ==
        "black because sphere (line 3) faces away from sun (line 2), and ambient is 0");
  CHECK(sentence_of("ambient: 0\nspot { at: [0, 9, 9], look_at: [0, 9, 0] }\nsphere {}") ==
        "black because sphere (line 3) is outside the cone of spot (line 2), and ambient is 0");
  CHECK(sentence_of("ambient: 0.01\nsphere {}") == "dark because there is no light, and there is little ambient light");
  CHECK(sentence_of("ambient: 0\nlight { at: [0, 0, 1] }\nsphere {}") ==
        "black because light (line 2) is at the very point that is seen and does not light it, and ambient is 0");
  CHECK(sentence_of(lit + "sphere { material: black }") == "black because the color of sphere (line 3) is black");
  CHECK(sentence_of(lit + "sphere { material: material { color: #333, specular: 0.9 } }")
            .starts_with("bright because sphere (line 3) shows the highlight of sun (line 1) here"));
  CHECK(sentence_of("ambient: 0\nsphere { material: material { emission: 0.9 } }") ==
        "sphere (line 2) emits light: emission gives 100 %");
  CHECK(sentence_of("background: #fff\nambient: 0\nsphere { material: material { reflect: 0.9 } }") ==
        "100 % of the light comes from the background, mirrored in sphere (line 3)");
  CHECK(sentence_of("background: #fff\nambient: 0\nsphere { material: material { refract: 0.9, ior: 1.5 } }") ==
        "100 % of the light comes from the background, through sphere (line 3)");
  CHECK(sentence_of("ambient: 0\nsun { direction: [0, 0, -1], intensity: 3 }\nsphere {}") ==
        "sphere (line 3) is lit by sun (line 2) (100 %); it is brighter than the picture can show and "
        "clipped to white");
  // Light that is there and does not get by: blue through a red pane, bent or not, and a weak mirror of a bright
  // background.
  const std::string blue = "ambient: 1\nplane { z: -5, material: #00f }\n";
  CHECK(sentence_of(blue + "box { material: material { color: #f00, refract: 1 } }") ==
        "black because it is seen through box (line 3), and little of the light of plane (line 2) gets through");
  CHECK(sentence_of(blue + "box { material: material { color: #f00, refract: 1, ior: 1.5 } }") ==
        "black because it is seen through box (line 3), but little of the light from there gets through");
  CHECK(
      sentence_of(
          "background: #fff\nambient: 0\nsphere { material: material { color: #fff, diffuse: 0.5, reflect: 0.04 } }") ==
      "dark because there is no light, and ambient is 0");
  // Two mirrors that face each other, and nothing else: the ray goes to and fro until it may not.
  CHECK(sentence_of("ambient: 0\nmax_depth: 3\nplane { z: -1, material: material { reflect: 1 } }\nplane { z: 9, "
                    "material: material { reflect: 1 } }") ==
        "black because plane (line 3) mirrors, and plane (line 4) mirrors, and plane (line 3) mirrors, and plane (line "
        "4) mirrors, and the ray ends at max_depth 3");
}
