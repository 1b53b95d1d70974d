#include "renderer/math/tone_mapping.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;

TEST_CASE("tone mapping: a stop doubles the light, and nothing else changes it by default") {
  CHECK(ToneCurve({})(0.3f) == 0.3f);
  CHECK(ToneCurve({})(7.5f) == 7.5f);
  CHECK(ToneCurve({1, Tone::clip})(0.3f) == 0.6f);
  CHECK(ToneCurve({-2, Tone::clip})(1.0f) == 0.25f);
  CHECK(std::isnan(ToneCurve({1, Tone::filmic})(NAN)));
}

TEST_CASE("tone mapping: filmic leaves dark and middle tones, and rolls the bright ones off below white") {
  const ToneCurve filmic({0, Tone::filmic});
  for (const float v : {0.0f, 0.01f, 0.18f, 0.4f}) CHECK(filmic(v) == v);
  CHECK(filmic(1) == Approx(1 - 0.6 * 0.36787944117144233).epsilon(1e-6)); // one scale above the knee: 1 − 0.6/e
  CHECK(filmic(0.401f) - 0.4f == Approx(0.001f).epsilon(0.002));           // no kink at the knee
  float before = 0;
  for (int i = 1; i <= 400; ++i) {
    const float v = filmic(static_cast<float>(i) * 0.01f);
    CHECK(v > before);
    CHECK(v < 1);
    before = v;
  }
  CHECK(ToneCurve({1, Tone::filmic})(0.5f) == filmic(1));
}
