// The lists of kinds: what holds for each of them, so that one that is added and forgotten somewhere does not compile
// or fails here.

#include "renderer/scene/names.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/shading/lights.hpp"
#include "renderer/shading/materials.hpp"

#include <catch2/catch.hpp>

#include <set>
#include <string>

using namespace rt::scene;

namespace {

template <class K>
concept Described = requires(const K& kind) {
  { K::noun } -> std::convertible_to<std::string_view>;
  { fields(&kind) } -> std::same_as<std::span<const Field>>;
};
template <class L>
concept SampledLight = Described<L> && requires(const L& light, const rt::Affine& map, const rt::Vec3& p) {
  { check(light) } -> std::same_as<std::optional<Problem>>;
  { sample_light(placed(light, map), p) } -> std::same_as<rt::LightSample>;
};
template <class S>
concept ShownByPattern = std::same_as<S, Paint> || std::same_as<S, rt::PaintBlend>;
template <class P>
concept EvaluatedPattern = Described<P> && requires(const P& pattern, const rt::Vec3& p) {
  { paint_at(pattern, p) } -> ShownByPattern;
};

struct Unheard {};
static_assert(!SampledLight<Unheard> && !EvaluatedPattern<Unheard> && !Described<Unheard>);

template <class Kinds, class F>
void for_each_default(F&& f) {
  Kinds::for_each([&]<class K>() { f(K{}); });
}

} // namespace

TEST_CASE("kinds: each has a word of its own, and a line that says what it is") {
  std::set<std::string_view> nouns;
  const auto look_at = [&]<class K>(const K&) {
    static_assert(Described<K>);
    INFO(std::string(K::noun));
    CHECK(nouns.insert(K::noun).second);
    if constexpr (requires { K::help; }) CHECK_FALSE(K::help.empty());
  };
  for_each_default<ShapeKinds>(look_at);
  for_each_default<LightKinds>(look_at);
  for_each_default<PatternKinds>(look_at);
  CHECK(nouns.size() == ShapeKinds::size + LightKinds::size + PatternKinds::size);
}

TEST_CASE("kinds: every light is sampled, every pattern has a value at a point") {
  for_each_default<LightKinds>([]<class L>(const L& light) {
    static_assert(SampledLight<L>);
    INFO(std::string(L::noun));
    CHECK(noun(LightSource(light)) == L::noun);
    const rt::LightSample sample = sample_light(rt::make_light({light, {}, {}, no_name, {}}), {7, -3, 2});
    CHECK(length(sample.to_light) == Approx(1));
    CHECK(sample.distance > 0);
  });
  for_each_default<PatternKinds>([]<class P>(const P& pattern) {
    static_assert(EvaluatedPattern<P>);
    CHECK(noun(PatternLayout(pattern)) == P::noun);
  });
}

TEST_CASE("kinds: steps, operations and fades are called by the language's words") {
  std::set<std::string_view> nouns;
  StepKinds::for_each([&]<class S>() {
    CHECK(noun(Step(S{})) == S::noun);
    CHECK(nouns.insert(S::noun).second);
  });
  using Operation = Combination::Operation;
  CHECK(noun(Operation::unite) == "union");
  CHECK(noun(Operation::intersect) == "intersection");
  CHECK(noun(Operation::subtract) == "difference");
  CHECK(name(Fade::Law::none) == "none");
  CHECK(name(Fade::Law::linear) == "linear");
  CHECK(name(Fade::Law::quadratic) == "quadratic");
  CHECK(name(Fade::Law::inverse_square) == "inverse_square");
}
