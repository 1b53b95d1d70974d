#include "renderer/image/sums_layer.hpp"

#include <fmt/format.h>

namespace rt::image {
namespace {

// Calls f with each word of a pixel in order, as a reference for reading and writing.
template <class Words, class F>
void for_each_word(Words& words, F&& f) {
  std::size_t i = 0;
  for (std::size_t half = 0; half < 2; ++half) {
    f.samples(words[i], half);
    ++i;
    for (std::size_t channel = 0; channel < 3; ++channel, i += 4) f.sum(&words[i], half, channel);
  }
}

std::uint32_t low(std::uint64_t word) {
  return static_cast<std::uint32_t>(word & 0xffffffffu);
}
std::uint32_t high(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32);
}
std::uint64_t joined(std::uint32_t low, std::uint32_t high) {
  return std::uint64_t{high} << 32 | low;
}

struct Packer {
  const PixelSums& sums;
  void samples(std::uint32_t& word, std::size_t half) const { word = sums.samples(half); }
  void sum(std::uint32_t* words, std::size_t half, std::size_t channel) const {
    const FixedSum& s = sums.sum(half, channel);
    const auto upper = static_cast<std::uint64_t>(s.upper());
    words[0] = low(s.lower()), words[1] = high(s.lower()), words[2] = low(upper), words[3] = high(upper);
  }
};

struct Unpacker {
  PixelSums& sums;
  void samples(const std::uint32_t& word, std::size_t half) const { sums.samples(half) = word; }
  void sum(const std::uint32_t* words, std::size_t half, std::size_t channel) const {
    sums.sum(half, channel) =
        FixedSum::from(static_cast<std::int64_t>(joined(words[2], words[3])), joined(words[0], words[1]));
  }
};

std::array<std::string, std::tuple_size_v<SumsWords>> make_names() {
  std::array<std::string, std::tuple_size_v<SumsWords>> names;
  std::size_t i = 0;
  for (const char half : {'A', 'B'}) {
    names[i++] = fmt::format("sums.{}.samples", half);
    for (const char channel : {'R', 'G', 'B'})
      for (int word = 0; word < 4; ++word) names[i++] = fmt::format("sums.{}.{}{}", half, channel, word);
  }
  names[i] = "sums.noise";
  return names;
}

} // namespace

const std::array<std::string, std::tuple_size_v<SumsWords>>& sums_channels() {
  static const auto names = make_names();
  return names;
}

std::vector<SumsWords> sums_words(const Film& film) {
  std::vector<SumsWords> words(film.sums.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    for_each_word(words[i], Packer{film.sums[i]});
    words[i].back() = film.noise_states[i];
  }
  return words;
}

void set_sums(Film& film, const std::vector<SumsWords>& words) {
  film.sums.resize(words.size());
  film.noise_states.resize(words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    for_each_word(words[i], Unpacker{film.sums[i]});
    film.noise_states[i] = words[i].back();
  }
}

} // namespace rt::image
