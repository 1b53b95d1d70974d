#include "lang/load.hpp"
#include "tests/paths.hpp"
#include "tools/explain/observer.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

using namespace rt;
using namespace rt::lang;

namespace {

Loaded tried(const std::string& text) {
  LoadOptions options;
  options.observe = tools::explain::tracing_observer();
  return load_text(text, "test.rtl", ".", options);
}

/// The one failure of a scene, as it is shown.
std::string failure(const std::string& text) {
  const Loaded loaded = tried(text);
  for (const Diagnostic& d : loaded.diagnostics) UNSCOPED_INFO(d.message);
  REQUIRE(loaded.expectations.failures.size() == 1);
  return render(loaded.expectations.failures[0], loaded.sources, false);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string first_error(const std::string& text) {
  for (const Diagnostic& d : tried(text).diagnostics) {
    if (d.severity == Severity::error) return d.code;
  }
  return "";
}

std::string first_message(const std::string& text) {
  for (const Diagnostic& d : tried(text).diagnostics) {
    if (d.severity == Severity::error) return d.message;
  }
  return "";
}

// A ball of radius 1 seen from 10 in front of it, in the middle of 5 × 5 pixels.
const std::string one_ball = "size: [5, 5]\ncamera { at: [0, 0, 10], look_at: [0, 0, 0], fov: 20 }\n"
                             "ball = sphere {}\nball\n";

} // namespace

// Of how many scenes in a folder all expectations hold.
std::size_t scenes_that_hold(const std::string& folder) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RTLANG_SOURCE_DIR "/" + folder)) {
    LoadOptions options;
    options.observe = tools::explain::tracing_observer();
    const Loaded loaded = load_file(entry.path().string(), options);
    for (const Diagnostic& d : loaded.diagnostics) {
      if (d.severity == Severity::error) UNSCOPED_INFO(render(d, loaded.sources, false));
    }
    for (const Diagnostic& d : loaded.expectations.failures) UNSCOPED_INFO(render(d, loaded.sources, false));
    INFO(entry.path());
    CHECK(loaded.scene);
    CHECK(loaded.expectations.failed == 0);
    CHECK(loaded.expectations.passed > 0);
    ++scenes;
  }
  return scenes;
}

TEST_CASE("expect: the exercises hold") {
  CHECK(scenes_that_hold("examples/exercises") == 13);
}

// Each number is from a closed form or a quadrature. The estimates are the same each time; with four standard errors
// within the tolerance, one of 16,000 would fail with other seeds.
TEST_CASE("expect: light is what closed forms say") {
  CHECK(scenes_that_hold("tests/light") == 18);
}

TEST_CASE("expect: an estimate needs a tolerance, and one that can be met") {
  const std::string room = "mode: path\nbox { size: 2, material: material { diffuse: 0.5, emission: 1 } }\n";
  CHECK(has(first_message(room + "expect radiance([0, 0, 0], [1, 0, 0]) ~ 2"), "specify its precision"));
  CHECK(has(first_message("sphere {}\nexpect irradiance([0, 2, 0], [0, 1, 0]) ~ 1 within 0.1"),
            "irradiance requires `mode: path`"));
  CHECK(has(first_message(room + "expect irradiance([0, 0, 0], [0, 0, 0]) ~ 1 within 0.1"), "must be finite"));
  CHECK_THAT(failure(room + "expect radiance([0, 0, 0], [1, 0, 0]) ~ 2.5 within 0.1"), Catch::Contains("differ"));
}

TEST_CASE("expect: what is seen is named, and what was found instead is reported") {
  CHECK(tried(one_ball + "expect pixel(2, 2) hits ball\nexpect pixel(2, 2) hits \"ball\"\nexpect pixel(0, 0) misses")
            .expectations.passed == 3);
  const std::string text = failure(one_ball + "other = sphere { at: [9, 9, 9] }\nexpect pixel(2, 2) hits other");
  CHECK(has(text, "error[E0701]"));
  CHECK(has(text, "test.rtl:6:1"));
  CHECK(has(text, "expected `other`"));
  CHECK(has(text, "found `ball` (test.rtl:3) at t 9"));
  CHECK(has(failure(one_ball + "expect pixel(0, 0) hits ball"), "found nothing"));
  CHECK(has(failure(one_ball + "expect pixel(2, 2) misses"), "expected nothing"));
}

TEST_CASE("expect: t, depth, the normal and all crossings of a ray") {
  // From z = 10 along -2 z the ball's near side, z = 1, is 4.5 lengths away and its far side 5.5.
  const std::string fine = "expect ray([0, 0, 10], [0, 0, -2]) hits ball at t 4.5\n"
                           "expect crossings([0, 0, 10], [0, 0, -2]) ~ [4.5, 5.5]\n"
                           "expect crossings([0, 0, 10], [0, 0, -2], sphere { radius: 2 }) ~ [4, 6]\n"
                           "expect depth(2, 2) ~ 9\nexpect normal(2, 2) ~ [0, 0, 1]\n"
                           "expect depth(2, 2) ~ 9.05 within 0.1\n";
  const Loaded loaded = tried(one_ball + fine);
  CHECK(loaded.expectations.passed == 6);
  CHECK(loaded.expectations.failed == 0);
  const std::string text = failure(one_ball + "expect ray([0, 0, 10], [0, 0, -2]) hits ball at t 4.6");
  CHECK(has(text, "expected `ball` at t 4.6"));
  CHECK(has(text, "at t 4.5"));
}

TEST_CASE("expect: values are compared with 1e-9 of slack, or with what `within` says") {
  CHECK(tried("expect 1 + 1e-10 ~ 1").expectations.passed == 1);
  CHECK(tried("expect [1, [2, 3]] ~ [1, [2, 3.05]] within 0.1").expectations.passed == 1);
  const std::string text = failure("expect 1.5 ~ 1 within 0.1");
  CHECK(has(text, "expected 1 within 0.1"));
  CHECK(has(text, "found 1.5"));
  CHECK(has(failure("expect 1 + 1 == 3"), "found 2"));
  CHECK(tried("expect [1, 2] ~ [1, 2, 3]").expectations.failed == 1);
}

TEST_CASE("expect: loops keep their values, and a copy bears the name of what it copies") {
  CHECK(tried("for x in [1, 2, 3] { y = x * x\n expect y == x * x and x < 4 }").expectations.passed == 3);
  CHECK(tried(one_ball + "ball { at: [3, 0, 0] }\nexpect ray([3, 0, 9], [0, 0, -1]) hits ball").expectations.passed ==
        1);
  CHECK(
      tried("def post() { sphere {} }\npost {}\nexpect ray([0, 0, 9], [0, 0, -1]) hits \"post\"").expectations.passed ==
      1);
}

TEST_CASE("expect: a failure in a loop says which turn it was") {
  const std::string text = failure("for i, x in [5, 6, 7] { for y in [[1, 2], [3, 4]] { expect x + y[0] < 10 } }");
  CHECK(has(text, "in the loop iteration with i = 2, x = 7, y = [3, 4]"));
  CHECK(tried("for x in 0..3 { if x > 1 { expect x < 3 } }").expectations.passed == 1);
}

TEST_CASE("expect: it stands at the top level, and only rays hit") {
  CHECK(first_error("group { sphere {}\n expect true }") == "E0217");
  CHECK(first_error(one_ball + "expect [1, 2] hits ball") == "E0218");
  CHECK(first_error(one_ball + "expect pixel(2, 2) hits ball at 4") == "E0139");
  CHECK(first_error("expect 1 ~ 1 at t 2") == "E0139");
  CHECK(first_error("expect pixel(1, 1) hits bal") == "E0201");
  CHECK(first_error("a = depth(1, 1)") == "E0201");
}

TEST_CASE("expect: without an observer nothing is tried, and names are checked all the same") {
  const Loaded loaded = load_text("expect 1 == 2", "test.rtl", ".", {});
  CHECK(loaded.scene);
  CHECK(loaded.expectations.failed == 0);
}
