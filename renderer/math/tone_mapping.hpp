#pragma once

#include <cstdint>

namespace rt {

/// What becomes of light that is brighter than white.
enum class Tone : std::uint8_t {
  clip, ///< it is white
  filmic ///< a shoulder: v above 0.4 becomes 0.4 + 0.6·(1 − e^−(v − 0.4)/0.6), which has no kink and never reaches 1
};

/// How linear light is shown in pictures of 8 and 16 bits, channel by channel: v·2^exposure, and then the tone.
struct ToneMapping {
  double exposure = 0; ///< stops
  Tone tone = Tone::clip;
  friend constexpr bool operator==(const ToneMapping&, const ToneMapping&) = default;
};

/// Applies it. With no exposure and `clip` it changes nothing: what is above 1 is left to whoever rounds.
class ToneCurve {
public:
  explicit ToneCurve(const ToneMapping& mapping);
  float operator()(float linear) const {
    const float v = linear * factor_;
    return tone_ == Tone::clip || !(v > knee) ? v : shoulder(v);
  }

private:
  static constexpr float knee = 0.4f; // below, tones are left as they are: middle grey is 0.18
  static float shoulder(float v);

  float factor_;
  Tone tone_;
};

} // namespace rt
