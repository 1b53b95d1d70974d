#include "tools/povray/run/povray.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

namespace rt::tools::povray {
namespace {

// Numbers are stored big-endian. Reading beyond the end yields zeros and is reported by `failed`.
class Bytes {
public:
  explicit Bytes(std::string_view data) : data_(data) {}
  bool failed() const { return failed_; }
  bool has(std::size_t count) const { return count <= data_.size() - at_; }
  std::size_t at() const { return at_; }
  void go_to(std::size_t at) {
    failed_ = failed_ || at > data_.size();
    at_ = std::min(at, data_.size());
  }
  std::string_view take(std::size_t count) {
    if (!has(count)) {
      failed_ = true;
      return {};
    }
    at_ += count;
    return data_.substr(at_ - count, count);
  }
  std::uint32_t u32() {
    std::uint32_t value = 0;
    for (const char c : take(4)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
  }

private:
  std::string_view data_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

// A rectangle of pixels, both ends included, five floats each: red, green, blue, filter, transmit.
struct Block {
  std::uint32_t left = 1, top = 1, right = 0, bottom = 0;
  std::string_view pixels;
};

constexpr std::size_t bytes_per_pixel = 20;

// A message is an object of attributes: key, type, the number of bytes (of floats in a vector of floats), and those.
Block read_block(Bytes& bytes) {
  Block block;
  bytes.take(8); // the object's key and type
  const std::uint32_t attributes = bytes.u32();
  for (std::uint32_t i = 0; i < attributes && !bytes.failed(); ++i) {
    const std::string_view key = bytes.take(4), type = bytes.take(4);
    const std::uint32_t size = bytes.u32();
    if (key == "PBlo" && type == "VFL4")
      block.pixels = bytes.take(4 * std::size_t{size});
    else if (type == "INT4" && size == 4) {
      const std::uint32_t value = bytes.u32();
      if (key == "Left") block.left = value;
      if (key == "Top ") block.top = value;
      if (key == "Righ") block.right = value;
      if (key == "Bott") block.bottom = value;
    } else
      bytes.take(size);
  }
  return block;
}

bool place(const Block& block, std::size_t width, std::size_t height, std::vector<Rgb32>& image, std::size_t& covered) {
  if (block.right >= width || block.bottom >= height || block.left > block.right || block.top > block.bottom)
    return false;
  const std::size_t columns = block.right - block.left + 1, rows = block.bottom - block.top + 1;
  if (block.pixels.size() != columns * rows * bytes_per_pixel) return false;
  Bytes values(block.pixels);
  const auto next = [&] { return std::bit_cast<float>(values.u32()); };
  for (std::size_t y = block.top; y <= block.bottom; ++y)
    for (std::size_t x = block.left; x <= block.right; ++x) {
      Rgb32& pixel = image[y * width + x];
      pixel.r = next(), pixel.g = next(), pixel.b = next();
      values.take(8);
    }
  covered += columns * rows;
  return true;
}

} // namespace

std::optional<std::vector<Rgb32>> read_render_state(const std::string& data, int width, int height) {
  constexpr std::size_t header_size = 512;
  Bytes bytes(data);
  if (bytes.take(header_size).substr(0, 25) != "POV-Ray Render State File") return std::nullopt;
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<Rgb32> image(w * h);
  std::size_t covered = 0;
  while (bytes.has(20)) {
    const std::size_t begin = bytes.at();
    if (bytes.take(8) != "POVRAYMS") return std::nullopt;
    bytes.u32();
    const std::uint32_t length = bytes.u32();
    const Block block = read_block(bytes);
    if (bytes.failed()) return std::nullopt;
    if (!block.pixels.empty() && !place(block, w, h, image, covered)) return std::nullopt;
    bytes.go_to(begin + length + 20);
  }
  if (covered != w * h) return std::nullopt;
  return image;
}

std::vector<Packed> to_16_bits(const std::vector<Rgb32>& color) {
  std::vector<Packed> image;
  image.reserve(color.size());
  const auto whole = [](float v) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(double{v}, 0.0, 1.0) * 65535));
  };
  for (const Rgb32& c : color) image.push_back({whole(c.r), whole(c.g), whole(c.b)});
  return image;
}

} // namespace rt::tools::povray
