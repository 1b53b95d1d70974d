#include "tools/bench/peers/picture.hpp"

#include "renderer/math/color.hpp"

#include <png.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace rt::tools::bench {
namespace {

Picture from_bytes(int width, int height, const std::vector<std::uint8_t>& bytes, Encoding encoding) {
  Picture picture{width, height, std::vector<float>(bytes.size())};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const double value = bytes[i] / 255.0;
    picture.values[i] = static_cast<float>(encoding == Encoding::srgb ? srgb_to_linear(value) : value);
  }
  return picture;
}

} // namespace

// libpng's simple interface would convert according to the file's gamma chunk; this one returns the values as they are.
Picture read_png(const std::string& path, Encoding encoding) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw std::runtime_error("cannot open " + path);
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::vector<std::uint8_t> bytes;
  std::vector<png_bytep> rows;
  if (setjmp(png_jmpbuf(png))) {
    png_destroy_read_struct(&png, &info, nullptr);
    throw std::runtime_error("cannot read " + path);
  }
  png_init_io(png, file.get());
  png_read_info(png, info);
  png_set_strip_16(png);
  png_set_strip_alpha(png);
  png_set_gray_to_rgb(png);
  png_set_palette_to_rgb(png);
  png_read_update_info(png, info);
  const std::size_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  bytes.resize(width * height * 3);
  for (std::size_t y = 0; y < height; ++y) rows.push_back(bytes.data() + y * width * 3);
  png_read_image(png, rows.data());
  png_destroy_read_struct(&png, &info, nullptr);
  return from_bytes(static_cast<int>(width), static_cast<int>(height), bytes, encoding);
}

Picture read_ppm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string magic;
  int width = 0, height = 0, maximum = 0;
  if (!(file >> magic >> width >> height >> maximum) || magic != "P6" || maximum != 255)
    throw std::runtime_error("cannot read " + path);
  file.get();
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    throw std::runtime_error("cannot read " + path);
  return from_bytes(width, height, bytes, Encoding::linear);
}

double share_that_differs(const Picture& a, const Picture& b, double steps) {
  if (a.width != b.width || a.height != b.height || a.values.empty()) return 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.values.size(); i += 3) {
    float most = 0;
    for (std::size_t k = i; k < i + 3; ++k) most = std::max(most, std::abs(a.values[k] - b.values[k]));
    if (most * 255 > steps) ++count;
  }
  return static_cast<double>(count) * 3 / static_cast<double>(a.values.size());
}

} // namespace rt::tools::bench
