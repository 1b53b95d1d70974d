#include "tools/inspect/scene_hash.hpp"

#include "renderer/math/random.hpp"
#include "tools/inspect/describe.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace rt::tools {
namespace {

/// Hashes every value word by word, including its kind, so that no two traversals look the same.
class HashSink {
public:
  static constexpr bool has_origins = false;

  void begin_object() { take(1); }
  void end_object() { take(2); }
  void begin_array() { take(3); }
  void end_array() { take(4); }
  void key(std::string_view name) { string(name); }
  void number(double value) { take(std::bit_cast<std::uint64_t>(value)); }
  void boolean(bool value) { take(value ? 5 : 6); }
  void string(std::string_view text) {
    take(text.size());
    for (std::size_t at = 0; at < text.size(); at += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, text.data() + at, std::min<std::size_t>(8, text.size() - at));
      take(word);
    }
  }
  std::uint64_t result() const { return mix_bits(state_); }

private:
  /// A bijection for each word, and no two words lead from one state to the same one.
  void take(std::uint64_t word) { state_ = (std::rotl(state_, 23) ^ word) * golden_increment; }

  std::uint64_t state_ = 0;
};

} // namespace

std::string scene_hash(const scene::Scene& scene) {
  HashSink sink;
  Describer(scene, sink).scene();
  return fmt::format("{:016x}", sink.result());
}

} // namespace rt::tools
