#include "renderer/image/formats.hpp"
#include "renderer/image/quantise.hpp"
#include "renderer/math/color.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace rt::image {
namespace {

[[noreturn]] void fail(const std::string& name, std::string_view reason) {
  throw std::runtime_error(fmt::format("`{}` cannot be read: {}", name, reason));
}

/// Reads the words of a header: separated by white space, with comments from `#` to the end of their line.
class Words {
public:
  Words(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::string_view next() {
    skip_space();
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_])) ++at_;
    if (begin == at_) fail(name_, "the file is truncated");
    return bytes_.substr(begin, at_ - begin);
  }
  unsigned whole_number() {
    const std::string_view word = next();
    unsigned value = 0;
    for (const char c : word) {
      if (c < '0' || c > '9' || value > 100'000'000) fail(name_, "expected an integer in its header");
      value = 10 * value + static_cast<unsigned>(c - '0');
    }
    return value;
  }
  /// What follows the single white space that ends the header.
  std::string_view rest() const { return bytes_.substr(std::min(at_ + 1, bytes_.size())); }

private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  void skip_space() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
      ++at_;
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

/// The linear value of each sample value, 0 to `maximum`.
std::vector<float> light_of_samples(unsigned maximum, Transfer transfer) {
  std::vector<float> light(maximum + 1);
  for (unsigned i = 0; i <= maximum; ++i) {
    const double v = static_cast<double>(i) / maximum;
    light[i] = static_cast<float>(transfer == Transfer::srgb ? srgb_to_linear(v) : v);
  }
  return light;
}

} // namespace

std::string encode_ppm(const Film& film, const EncodeOptions& options) {
  const SrgbQuantiser quantise(options.bits);
  const ToneCurve curve(film.tone_mapping);
  std::string bytes = fmt::format("P6\n{} {}\n{}\n", film.width, film.height, (1 << options.bits) - 1);
  bytes.reserve(bytes.size() + film.color.size() * 3 * static_cast<std::size_t>(options.bits / 8));
  for (const Rgb32& c : film.color) {
    for (const float v : {c.r, c.g, c.b}) {
      const unsigned code = quantise(curve(v));
      if (options.bits == 16) bytes.push_back(static_cast<char>(code >> 8));
      bytes.push_back(static_cast<char>(code & 255));
    }
  }
  return bytes;
}

Image decode_pnm(std::string_view bytes, const std::string& name, Transfer assumed) {
  Words words(bytes, name);
  const char kind = words.next()[1];
  const bool is_text = kind == '2' || kind == '3', is_grey = kind == '2' || kind == '5';
  const unsigned width = words.whole_number(), height = words.whole_number(), maximum = words.whole_number();
  if (maximum == 0 || maximum > 65535) fail(name, fmt::format("its maximum value is {}, not 1 to 65535", maximum));

  const std::size_t channels = is_grey ? 1 : 3, sample_size = maximum > 255 ? 2 : 1;
  const std::string_view data = words.rest();
  // A wrong size is detected before memory is allocated for it: a sample in text takes a digit and a space.
  if (data.size() + 1 < std::uint64_t{width} * height * channels * (is_text ? 2 : sample_size))
    fail(name, "the file is truncated");
  Image image = empty_image(width, height, maximum > 255 ? 16 : 8, name);

  const std::vector<float> light = light_of_samples(maximum, assumed);
  std::size_t at = 0;
  const auto sample = [&] {
    unsigned value = 0;
    if (is_text) {
      value = words.whole_number();
    } else {
      if (at + sample_size > data.size()) fail(name, "the file is truncated");
      for (std::size_t i = 0; i < sample_size; ++i) value = value << 8 | static_cast<unsigned char>(data[at++]);
    }
    if (value > maximum) fail(name, "a sample is greater than its greatest value");
    return light[value];
  };
  for (Rgb32& c : image.color) {
    c.r = sample();
    c.g = is_grey ? c.r : sample();
    c.b = is_grey ? c.r : sample();
  }
  return image;
}

std::string encode_pfm(const Film& film) {
  static_assert(std::endian::native == std::endian::little, "the sign of the scale below says so");
  std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", film.width, film.height);
  const std::size_t header = bytes.size(), row = static_cast<std::size_t>(film.width) * sizeof(Rgb32);
  bytes.resize(header + film.color.size() * sizeof(Rgb32));
  for (int y = 0; y < film.height; ++y) // from the bottom up
    std::memcpy(bytes.data() + header + static_cast<std::size_t>(film.height - 1 - y) * row,
                film.color.data() + film.index(0, y), row);
  return bytes;
}

Image decode_pfm(std::string_view bytes, const std::string& name) {
  Words words(bytes, name);
  const bool is_grey = words.next() == "Pf";
  const unsigned width = words.whole_number(), height = words.whole_number();
  const double scale = std::strtod(std::string(words.next()).c_str(), nullptr);
  if (!(std::abs(scale) > 0)) fail(name, "its scale is not a number other than 0");

  const std::size_t channels = is_grey ? 1 : 3;
  const std::string_view data = words.rest();
  if (data.size() < std::uint64_t{width} * height * channels * 4) fail(name, "the file is truncated");
  Image image = empty_image(width, height, 32, name);
  const auto sample = [&](std::size_t i) {
    std::uint32_t word = 0;
    std::memcpy(&word, data.data() + 4 * i, 4);
    if (scale > 0) word = __builtin_bswap32(word);
    return std::bit_cast<float>(word);
  };
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::size_t i = channels * image.index(x, image.height - 1 - y);
      image.color[image.index(x, y)] =
          is_grey ? Rgb32{sample(i), sample(i), sample(i)} : Rgb32{sample(i), sample(i + 1), sample(i + 2)};
    }
  }
  return image;
}

} // namespace rt::image
