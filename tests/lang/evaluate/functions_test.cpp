// Functions of the scene's that travel to the renderer.

#include "renderer/functions/evaluate.hpp"
#include "renderer/math/random.hpp"
#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

using Codes = std::vector<std::string>;

namespace {

scene::Scene scene_of(const std::string& text) {
  Loaded loaded = load(text);
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  return *std::move(loaded.scene);
}

const rt::Function& only_function(const scene::Scene& scene) {
  REQUIRE(scene.patterns.size() == 1);
  return *std::get<scene::FunctionPattern>(scene.patterns[0].layout).function;
}

/// What the language gives for `body` at each of the points: [x, y, z].
std::vector<Vec3> values_in_language(const std::string& body, const std::vector<Vec3>& points, bool is_color) {
  std::string text = body + "\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    // A number stands for grey: white times either is a colour.
    text += fmt::format("v{} = {}f([{}, {}, {}])\n", i, is_color ? "white * " : "", p.x, p.y, p.z);
    text += is_color ? fmt::format("sphere {{ at: [v{0}.r, v{0}.g, v{0}.b] }}\n", i)
                     : fmt::format("sphere {{ at: [v{}, 0, 0] }}\n", i);
  }
  std::vector<Vec3> values;
  for (const scene::Object& object : scene_of(text).objects) values.push_back(object.at);
  return values;
}

/// The function in the language and in the renderer are the same to the last bit.
void check_same(const std::string& body, bool is_color = false) {
  INFO(body);
  const rt::Function function = only_function(scene_of(body + "\nsphere { material: f }"));
  REQUIRE(function.results.size() == (is_color ? 3 : 1));
  SplitMix64 random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i)
    points.push_back({random.between(0.01, 1), random.between(0.01, 1), random.between(-3, 3)});
  for (int i = 0; i < 30; ++i)
    points.push_back({0.25 * std::floor(random.between(1, 5)), 0.5, std::floor(random.between(-5, 5))});
  const std::vector<Vec3> expected = values_in_language(body, points, is_color);
  REQUIRE(expected.size() == points.size());
  std::vector<double> registers(function.register_count());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double inputs[] = {points[i].x, points[i].y, points[i].z};
    evaluate(function, inputs, registers);
    for (std::size_t k = 0; k < function.results.size(); ++k) {
      const double found = registers[function.results[k]];
      INFO(points[i].x << ", " << points[i].y << ", " << points[i].z << ": " << found << ", not " << expected[i][k]);
      REQUIRE(std::bit_cast<std::uint64_t>(found + 0.0) == std::bit_cast<std::uint64_t>(expected[i][k] + 0.0));
    }
  }
}

Codes codes_of(const std::string& text) {
  return errors(load(text));
}

} // namespace

TEST_CASE("functions: every operator and function means the same in the language and in the renderer") {
  for (const char* expression : {"p.x + 2 * p.y - p.z / 3",
                                 "-p.x ^ 2 + 2 ^ p.z",
                                 "p.z % 0.7",
                                 "p.z % -0.7",
                                 "+p.x",
                                 "p[0] + p[-1]",
                                 "sin(90 * p.z) + cos(30 * p.z) - tan(20 * p.z)",
                                 "asin(p.x) + acos(p.y) + atan(p.z)",
                                 "atan2(p.z, p.x)",
                                 "sqrt(p.x) + abs(p.z) + sign(p.z)",
                                 "floor(p.z) + ceil(p.z) + round(p.z) + trunc(p.z)",
                                 "clamp(p.z) + clamp(p.z, p.x - 1, 2)",
                                 "smoothstep(-1, 2, p.z) + smoothstep(p.x, p.x, p.y)",
                                 "pow(p.x, p.z) + exp(p.z) + log(p.x) + log2(p.x) + log10(p.y)",
                                 "hypot(p.x, p.y, p.z)",
                                 "mod(p.z, p.x)",
                                 "dot(p, [1, 2, 3]) + length(p)",
                                 "cross(p, [1, 2, 3]).y",
                                 "normalize(p).z",
                                 "distance(p, [1, 1, 1])",
                                 "angle_between(p, [1, 2, 3])",
                                 "project(p, [1, 2, 3]).x",
                                 "reflect(p, [p.y, 1, 0]).y",
                                 "triple(p, [1, 2, 3], [3, 1, 2])",
                                 "component(p, [1, 2, 3])",
                                 "cylindrical(p).y",
                                 "from_cylindrical(p).x",
                                 "spherical(p).z",
                                 "from_spherical(p).y",
                                 "length([p.x, p.y]) + dot([p.x, 1], [2, p.z])",
                                 "min(p.x, p.y, 0.3) + max([p.x, p.z])",
                                 "min(p) + max(p) + sum(p)",
                                 "sum([i * p.x for i in 1..5]) + product(p.x, p.y)",
                                 "len(p) * p.x",
                                 "sum(map(fn(c) => c * c, p))",
                                 "fold(fn(s, i) => s * p.x + i, 0, 1..4)",
                                 "mix(p.x, p.y, p.z)",
                                 "lerp(p, [1, 2, 3], 0.3).z",
                                 "noise_at(p * 3) + noise_at([p.x, p.z], \"seed\", 7)",
                                 "(p * 2 - [1, 0, 1] / 3).z",
                                 "(2 * p * p / [1, 2, 3]).y",
                                 "if p.z > 0 { p.x } else { p.y }",
                                 "if p.x < 0.5 and not (p.z >= 1) or p.y == 0.5 { 1 } else { 2 }",
                                 "if p != [1, 0.5, 1] { 3 } else { 4 }",
                                 "if any(fn(i) => p.z > i, [1, 2]) { 1 } else { 0 }",
                                 "if all([p.x > 0.2, p.y > 0.2]) { 1 } else { 0 }",
                                 "(if p.z > 0 { p } else { [1, 2, 3] }).y",
                                 "({ a: p.x, b: [p.y] }).b[0]",
                                 "1 / (p.z + 10)",
                                 "sum(concat([p.x, 2, 3, 4], reverse([p.z, p.y]))) + zip(p, [1, 2, 3])[2][0]"})
    check_same(fmt::format("fn f(p) = {}", expression));
}

TEST_CASE("functions: colours mean the same in the language and in the renderer") {
  for (const char* expression :
       {"rgb(p.x, p.y, 0.5)", "hsv(360 * p.z, p.x, p.y)", "hsv(-100 * p.z, 1, 1)", "linear_rgb(p.x, 2 * p.y, p.z + 5)",
        "mix(teal, gold, p.x)", "mix(hsv(p.x, 1, 1), 0.5, p.y) * 0.7", "peru * p.x + grey / 2", "tan * hsv(p.y, 1, 1)",
        "if p.z > 0 { red } else { p.x }", "linear_rgb(0.1, 0.2, 0.3) * hsv(90, p.x, 1).g"})
    check_same(fmt::format("fn f(p) = {}", expression), true);
}

TEST_CASE("functions: calls, loops, closures and recursion that ends are written out") {
  check_same("amounts = [0.5, 0.25, 0.125]\n"
             "fn wave(x, frequency = 90) = sin(frequency * x)\n"
             "fn octave(n, q) = if n == 0 { 0 } else { wave(q.x) / n + octave(n - 1, q * 2) }\n"
             "scale = fn(k) => fn(v) => v * k\n"
             "fn f(p) {\n  q = scale(3)(p)\n  sum([a * wave(q.y, frequency: 30 * i) for a in amounts for i in 1..2]) + "
             "octave(3, q)\n}");
}

TEST_CASE("functions: what is computed twice is there once, and what is constant is computed before") {
  const rt::Function f =
      only_function(scene_of("k = 3\nsphere { material: fn(p) => sin(k * 30 * p.x) + sin(90 * p.x) }"));
  CHECK(listing(f) == std::vector<std::string>{"t1 = 90 * x", "t2 = sin(t1)", "t3 = t2 + t2", "t3"});
}

TEST_CASE("functions: one stands wherever a pattern may, and is placed as one") {
  const scene::Scene scene =
      scene_of("sphere { material: { color: fn(p) => red * p.x, specular: fn(p) => p.y, reflect: "
               "checker { a: fn(p) => p.z } } }\n"
               "sphere { material: pattern { of: fn(p) => p.x, scale: 2 }.move(x: 1) }");
  CHECK(scene.patterns.size() == 5);
  const auto& placed = scene.patterns.back();
  CHECK(std::holds_alternative<scene::FunctionPattern>(placed.layout));
  CHECK(placed.placement.scale == Vec3{2, 2, 2});
  CHECK(placed.placement.chain.size() == 1);
}

TEST_CASE("functions: what cannot depend on the point is a mistake, with the place and the reason") {
  const auto code_of = [](const std::string& body) { return codes_of("sphere { material: fn(p) => " + body + " }"); };
  CHECK(code_of("[1, 2, 3][p.x]") == Codes{"E0304"});
  CHECK(code_of("sum([i for i in 0..p.x])") == Codes{"E0304"});
  CHECK(code_of("random(p.x)") == Codes{"E0315"});
  CHECK(code_of("len(str(p.x))") == Codes{"E0315"});
  CHECK(code_of("sort([p.x, p.y, 1, 2])[0]") == Codes{"E0315"});
  CHECK(code_of("noise_at([1, 2, 3], p.x)") == Codes{"E0310"});
  CHECK(code_of("if p.x > 0 { 1 } else { [1] }") == Codes{"E0315"});
  CHECK(code_of("if p.x { 1 } else { 2 }") == Codes{"E0305"});
  CHECK(code_of("sum([i for i in [1, 2, 3] if p.x > i])") == Codes{"E0305"});
  CHECK(code_of("p.w") == codes_of("x = [1, 2, 3]\nsphere { radius: x.w }"));
  CHECK(code_of("p + 1") == Codes{"E0304"});
  CHECK(code_of("\"x\" + p.x") == Codes{"E0304"});
  CHECK(code_of("sphere { radius: p.x }.radius") == Codes{"E0301"});
  CHECK(code_of("p") == Codes{"E0301"});
  CHECK(code_of("p.x > 0") == Codes{"E0301"});
  CHECK(codes_of("sphere { material: fn(a, b) => 1 }") == Codes{"E0301"});
  CHECK(codes_of("sphere { material: fn() => 1 }") == Codes{"E0301"});
  CHECK(codes_of("sphere { material: { specular: fn(p) => red * p.x } }") == Codes{"E0301"});
  CHECK(codes_of("sphere { material: { specular: pattern { of: fn(p) => red * p.x } } }") == Codes{"E0301"});
  CHECK(codes_of("sphere { material: { ior: fn(p) => 1 } }") == Codes{"E0301"});
  CHECK(codes_of("sphere { radius: fn(p) => 1 }") == Codes{"E0301"});
  CHECK(
      codes_of("fn down(p, n) = if p.x > n { down(p, n + 1) } else { n }\nsphere { material: fn(p) => down(p, 0) }") ==
      Codes{"E0502"});
  CHECK(codes_of("sphere { material: fn(p) => sum([sin(i * p.x) for i in 0..40000]) }") == Codes{"E0507"});
}

TEST_CASE("functions: one within another has a point of its own") {
  const auto codes_with = [](const std::string& inner) {
    return codes_of("fn of(f, p) = f(p)\n"
                    "sphere { material: fn(p) => of(material { color: fn(q) => " +
                    inner + " }.color, p) }");
  };
  CHECK(codes_with("q.x").empty());
  CHECK(codes_with("p.x + q.x") == Codes{"E0315"});
}

TEST_CASE("functions: a mistake says that the point is not known yet") {
  const Loaded loaded = load("sphere { material: fn(p) => random(p.x) }");
  const std::string text = report(loaded);
  INFO(text);
  CHECK(text.find("`random` cannot be used with what depends on the point") != std::string::npos);
  CHECK(text.find("known only while the picture is made") != std::string::npos);
  CHECK(text.find("test.rtl:1:29") != std::string::npos);
}
