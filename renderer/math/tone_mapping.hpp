#pragma once

#include <cstdint>

namespace rt {

/// What to do with light that is brighter than white.
enum class Tone : std::uint8_t {
  clip, ///< it becomes white
  filmic ///< a shoulder: v above 0.4 becomes 0.4 + 0.6·(1 − e^−(v − 0.4)/0.6), which has no kink and never reaches 1
};

/// How linear light is shown in pictures of 8 and 16 bits, per channel: v·2^exposure, then the tone curve.
struct ToneMapping {
  double exposure = 0; ///< stops
  Tone tone = Tone::clip;
  friend constexpr bool operator==(const ToneMapping&, const ToneMapping&) = default;
};

/// Applies it. With no exposure and `clip` it changes nothing: values above 1 are left to the quantiser.
class ToneCurve {
public:
  explicit ToneCurve(const ToneMapping& mapping);
  float operator()(float linear) const {
    const float v = linear * factor_;
    return tone_ == Tone::clip || !(v > knee) ? v : shoulder(v);
  }

private:
  static constexpr float knee = 0.4f; // below, tones are unchanged: middle grey is 0.18
  static float shoulder(float v);

  float factor_;
  Tone tone_;
};

} // namespace rt
