#include "tools/inspect/scene_hash.hpp"

#include "tools/inspect/describe.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

namespace rt::tools {
namespace {

/// Takes in every value word by word, and what kind of value it is, so that no two walks look the same.
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
  std::uint64_t result() const { return mixed(state_); }

private:
  /// The finaliser of SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014): every bit
  /// of the argument reaches every bit of the result, and no two arguments have the same one.
  static constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }
  /// No two words lead from one state to the same one.
  void take(std::uint64_t word) { state_ = (std::rotl(state_, 23) ^ word) * 0x9e3779b97f4a7c15u; }

  std::uint64_t state_ = 0;
};

} // namespace

std::string scene_hash(const scene::Scene& scene) {
  HashSink sink;
  Describer(scene, sink).scene();
  return fmt::format("{:016x}", sink.result());
}

} // namespace rt::tools
