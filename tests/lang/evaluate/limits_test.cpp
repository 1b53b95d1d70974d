#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

#include <atomic>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

using Codes = std::vector<std::string>;

namespace {

// The thread sanitizer keeps a call stack of its own, for 65,536 functions, and does not look whether it is full: no
// program that it watches can nest deeper, however large its stack. Here a call takes nine functions, and three more
// for each `[( … )][0]` around it.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define RTLANG_IS_WATCHED
#endif
#endif
#ifdef RTLANG_IS_WATCHED
constexpr int many_calls = 5'000, many_brackets = 15;
#else
constexpr int many_calls = 50'000, many_brackets = 60;
#endif

} // namespace

TEST_CASE("limits: recursion up to the limit works, one call more does not") {
  const std::string sum = "fn sum_to(n) = if n == 0 { 0 } else { n + sum_to(n - 1) }\n";
  CHECK(number("sum_to(999)", sum) == 499500); // 1000 nested calls
  CHECK(errors(sum + "sphere { radius: sum_to(1000) }") == Codes{"E0502"});
  LoadOptions options;
  options.limits.recursion = 100000;
  CHECK(load(sum + "sphere { radius: sum_to(" + std::to_string(many_calls) + ") }", options).scene);
}

TEST_CASE("limits: calls within deep expressions do not end the stack") {
  std::string deep = "f(n - 1)";
  for (int i = 0; i < many_brackets; ++i) deep = "[(" + deep + ")][0]";
  CHECK(number("f(999)", "fn f(n) = if n == 0 { 0 } else { " + deep + " }") == 0);
  CHECK(errors("fn f(n) = " + deep + "\nsphere { radius: f(1) }") == Codes{"E0502"});
}

TEST_CASE("limits: endless recursion of defs, of functions through builtins, and of each other") {
  CHECK(errors("def a(n) { a { n: n + 1 } }\na { n: 0 }") == Codes{"E0502"});
  CHECK(errors("def a(n) { group { union { a { n: n + 1 } } } }\na { n: 0 }") == Codes{"E0502"});
  CHECK(errors("fn f(x) = map(f, [x])\nsphere { radius: f(1) }") == Codes{"E0502"});
  CHECK(errors("fn f(x) = g(x)\nfn g(x) = f(x)\nsphere { radius: f(1) }") == Codes{"E0502"});
}

TEST_CASE("limits: what calls itself without end leaves the rest of the file to be looked at") {
  CHECK(errors("fn f(x) = f(x)\na = f(1)\nb = a + 1\nsphere { radius: f(2) }\nbox { size: b }\nfor i in 5 { box {} "
               "}\nsphere { at: [1, 2] }") ==
        Codes{"E0502", "E0307", "E0301"}); // one for each place, and nothing about what would have been the value
  CHECK(errors("def a() { group { a {} } }\nif true { a {} }\nbox { size: -1 }") == Codes{"E0502", "E0302"});
}

TEST_CASE("limits: the call stack is reported, and its middle left out") {
  const Loaded loaded = load("fn f(n) = f(n + 1)\nsphere { radius: f(0) }");
  const Diagnostic* d = find(loaded, "E0502");
  REQUIRE(d);
  REQUIRE(d->call_stack.size() == 7);
  CHECK(d->call_stack.front().message == "in `f`, called here");
  CHECK(d->call_stack[3].message.find("more calls") != std::string::npos);
  CHECK(d->call_stack.back().span->begin == 36); // the call in the sphere
}

TEST_CASE("limits: steps, objects and memory") {
  LoadOptions options;
  options.limits.steps = 500;
  CHECK(errors("for i in 0..<1000 { sphere {} }", options) == Codes{"E0501"});
  CHECK(errors("sphere { radius: sum(map(fn(x) => x, 0..<1000)) }", options) == Codes{"E0501"});
  CHECK(errors("for i in 0..<100 { sphere {} }", options).empty());
  options = {};
  options.limits.objects = 10;
  CHECK(errors("for i in 0..<11 { sphere {} }", options) == Codes{"E0503"});
  CHECK(errors("g = group { for i in 0..<5 { sphere {} } }\nfor i in 0..<5 { g }", options).empty()); // shared: 5 + 5
  options = {};
  options.limits.memory_bytes = 1'000'000;
  CHECK(errors("a = [x for x in 0..<1e6]\nsphere {}", options) == Codes{"E0504"});
  CHECK(errors("a = reverse(0..<1e7)\nsphere {}", options) == Codes{"E0504"});
}

TEST_CASE("limits: endless ranges and huge lists end at once") {
  CHECK(errors("for i in 0..1e300 { sphere {} }") == Codes{"E0501"});
  CHECK(errors("a = sum(0..1e15)\nsphere {}") == Codes{"E0310"});
  CHECK(errors("a = [x for x in 0..1e18]\nsphere {}") == Codes{"E0501"});
}

TEST_CASE("limits: nested too deep is a mistake, not a crash") {
  CHECK(errors("a = fold(fn(x, i) => [x, i, 0, 0], [], 0..5000)\nsphere {}") == Codes{"E0506"});
  CHECK(errors("a = fold(fn(x, i) => group { x }, sphere {}, 0..5000)\na") == Codes{"E0506"});
  CHECK(errors("a = fold(fn(x, i) => checker { a: x }, red, 0..5000)\nsphere { material: a }") == Codes{"E0506"});
  CHECK(errors("a = fold(fn(f, i) => fn(x) => f(x) + 1, fn(x) => x, 0..<900)\nsphere { radius: a(1) }").empty());
  CHECK(errors("a = fold(fn(f, i) => fn(x) => f(x) + 1, fn(x) => x, 0..<200000)\nsphere {}").empty()); // never called
}

TEST_CASE("limits: it stops when asked to") {
  const std::atomic<bool> stop = true;
  LoadOptions options;
  options.stop = &stop;
  CHECK(errors("for i in 0..1e7 { sphere {} }", options) == Codes{"E0505"});
}
