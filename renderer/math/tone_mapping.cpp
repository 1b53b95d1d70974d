#include "renderer/math/tone_mapping.hpp"

#include <cmath>

namespace rt {

ToneCurve::ToneCurve(const ToneMapping& mapping)
    : factor_(static_cast<float>(std::exp2(mapping.exposure))), tone_(mapping.tone) {}

float ToneCurve::shoulder(float v) {
  constexpr float room = 1 - knee;
  return knee + room * (1 - std::exp(-(v - knee) / room));
}

} // namespace rt
